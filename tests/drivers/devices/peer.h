// A program of the other side, run by node.
#pragma once

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <string>

#include "tests/drivers/devices/waiting.h"

namespace handmap::test {

class Peer {
 public:
  static constexpr int kPatience_ms = 120'000;  // node takes its time to start on a busy machine

  /// Why it cannot be had here; empty where it can.
  static std::string missing(const QString& package) {
    if (QStandardPaths::findExecutable(QStringLiteral("node")).isEmpty()) {
      return "node is not installed";
    }
    if (!QFile::exists(QStringLiteral(HANDMAP_PEERS "/node_modules/") + package)) {
      return "the npm package " + package.toStdString() + " is not there: ./dev peers gets it";
    }
    return {};
  }

  Peer(const QString& script, const QStringList& arguments) {
    process_.setProcessChannelMode(QProcess::MergedChannels);
    process_.start(QStringLiteral("node"),
                   QStringList{QStringLiteral(HANDMAP_PEER_SCRIPTS "/") + script,
                               QStringLiteral(HANDMAP_PEERS)} +
                       arguments);
  }
  ~Peer() {
    process_.kill();
    process_.waitForFinished();
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Whether a line that begins so has come, or comes.
  bool says(const std::string& beginning) {
    return waitUntil(
        [&] {
          said += process_.readAll().toStdString();
          return ('\n' + said).find('\n' + beginning) != std::string::npos;
        },
        kPatience_ms);
  }
  std::string said;

 private:
  QProcess process_;
};

}  // namespace handmap::test
