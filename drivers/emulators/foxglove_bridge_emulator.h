// A Foxglove bridge that is not one: ROS 2 behind it is whoever publishes here, on the loopback.
#pragma once

#include <QCborMap>
#include <QObject>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketServer>
#include <map>

#include "drivers/rosbridge/ros_schema.h"

namespace handmap {

class FoxgloveBridgeEmulator : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(FoxgloveBridgeEmulator)
 public:
  /// Listens. Throws RunFailed.
  FoxgloveBridgeEmulator();
  ~FoxgloveBridgeEmulator() override;

  QUrl url() const;  ///< foxglove://…, the same after every plug()
  void plug();
  void unplug();

  /// A topic that is there from now on; `type` is one that RosSchema knows.
  void offer(const QString& topic, const std::string& type);
  /// It is not there any more.
  void withdraw(const QString& topic);
  void publish(const QString& topic, const QCborMap& message);
  /// As it is, to all: for what no bridge should send.
  void sendRaw(const QByteArray& bytes, bool binary);
  /// In place of "cdr": how the messages of topics are said to be written.
  void setEncoding(const QString& encoding) { encoding_ = encoding; }
  bool hasSubscriber(const QString& topic) const;
  QString subprotocol() const { return subprotocol_; }  ///< that of the client that came last

 Q_SIGNALS:
  /// By a client; `type` as it said.
  void published(const QString& topic, const QString& type, const QCborMap& message);

 private:
  struct Channel {
    std::uint32_t id = 0;
    std::string type;
    RosSchema schema;
  };
  struct Told {
    QString topic;
    std::string type;
  };
  struct Client {
    std::map<std::uint32_t, std::uint32_t> asked;  ///< subscription → channel
    std::map<std::uint32_t, Told> told;            ///< by its own channel
  };
  void welcome();
  void obey(Client& client, const QByteArray& text);
  void hear(const Client& client, const QByteArray& frame);
  QByteArray advertisement(const QString& topic, const Channel& channel) const;

  QWebSocketServer server_;
  quint16 port_ = 0;
  QString encoding_ = QStringLiteral("cdr");
  QString subprotocol_;
  std::uint32_t last_id_ = 0;
  std::map<QWebSocket*, Client> clients_;
  std::map<QString, Channel> channels_;  ///< by topic
};

}  // namespace handmap
