// What core and drivers say, in Japanese: every text is a phrase, and nothing English is left in
// it.
#include <QCoreApplication>
#include <QDirIterator>
#include <QRegularExpression>
#include <QTranslator>

#include <gtest/gtest.h>

#include "app/gui/shell/language.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/calibration/stereo_calibrator.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/recording/frame_table.h"
#include "core/recording/image_file.h"
#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"
#include "core/session/run_warnings.h"
#include "drivers/live/assembler.h"
#include "drivers/odometry_lines/odometry_line.h"
#include "drivers/rosbridge/bounded_message.h"
#include "drivers/serial/byte_port.h"
#include "tests/journeys/window_test.h"

namespace handmap {
namespace {

/// Calls that say something to a person, up to the end of their statement.
const QRegularExpression kSaying(
    QStringLiteral(R"(\b(?:throwBadInput|Error|FrameError|fail|failKind|refused?|giveUp|tell|)"
                   R"(setState|tryAgain|setActivity|drop)\(((?:"(?:[^"\\\n]|\\.)*"|[^;"])*);)"));
const QRegularExpression kLiteral(
    QStringLiteral(R"("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)"));
const QRegularExpression kPhrase(
    QStringLiteral(R"(\bq?[pP]hrase\(\s*"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)"));

TEST(PhrasesOfTheSources, WhatIsThrownIsTranslated) {
  const QRegularExpression two_words(QStringLiteral("[a-z]{2,} [a-z]{3,}"));
  int sayings = 0;
  for (const char* folder : {"core", "drivers"}) {
    QDirIterator files(QStringLiteral(HANDMAP_SOURCES "/%1").arg(QLatin1String(folder)), {"*.cpp"},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString name = files.next();
      // No window shows what experiments, studies of drawings and emulators say.
      if (name.contains("/core/experiments/") || name.contains("/core/sketch_study/") ||
          name.contains("/emulators/")) {
        continue;
      }
      const QString text = QString::fromStdString(readFile(name.toStdString(), 1 << 20));
      for (auto saying = kSaying.globalMatch(text); saying.hasNext();) {
        QString arguments = saying.next().captured(1);
        sayings += arguments.contains(kPhrase) ? 1 : 0;
        arguments.remove(kPhrase);
        for (auto literal = kLiteral.globalMatch(arguments); literal.hasNext();) {
          const QString english = literal.next().captured();
          EXPECT_FALSE(english.contains(two_words))
              << name.toStdString() << ": " << english.toStdString() << ": say it by phrase()";
        }
      }
    }
  }
  EXPECT_GT(sayings, 200);
}

class SaidInJapanese : public WindowTest {
 protected:
  SaidInJapanese() {
    settings_.setValue("view/language", "ja");
    installLanguage(*qApp, settings_);
  }
  ~SaidInJapanese() override {
    for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(translator);
      delete translator;
    }
  }

  /// Japanese, and no Latin words but names: of files, keys, units, formats.
  static void expectJapanese(QString text, const QStringList& names) {
    const std::string whole = text.toStdString();
    EXPECT_TRUE(text.contains(QRegularExpression(QStringLiteral("[ぁ-んァ-ヶ一-龠]")))) << whole;
    for (const QString& name : names) text.remove(name);
    static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{2,}"));
    const auto word = kWord.match(text);
    EXPECT_FALSE(word.hasMatch()) << word.captured().toStdString() << " in: " << whole;
  }
  template <typename Provoke>
  static void expectJapaneseError(Provoke provoke, const QStringList& names) {
    try {
      provoke();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
      expectJapanese(QString::fromUtf8(error.what()), names);
      if (!error.hint().empty()) expectJapanese(QString::fromStdString(error.hint()), names);
    }
  }
};

TEST_F(SaidInJapanese, AMap) {
  const QStringList names{"x.handmap", "format",  "handmap", "version",
                          "buildings", "GeoJSON", "other"};
  for (const char* map :
       {"{}", "[]", R"({"format":7})", R"({"format":"other"})", R"({"format":"handmap"})",
        R"({"format":"handmap","version":99999})",
        R"({"format":"handmap","version":1,"buildings":7})", R"({"format":1,"format":2})"}) {
    expectJapaneseError([&] { parseMap(map, "x.handmap"); }, names);
  }
  expectJapaneseError([] { requireReadyToRun({}); }, {});
  expectJapaneseError([] { formatGeoJson({}); }, names);
  expectJapaneseError(
      [] {
        checkReference({"model", "/etc/passwd"}, "/tmp/x.handmap", {});
      },
      {"/tmp/x.handmap", "model", "/etc/passwd", "--allow-outside"});
}

TEST_F(SaidInJapanese, FilesOfARecording) {
  expectJapaneseError([] { readFile("/nowhere", 10); }, {"/nowhere"});
  expectJapaneseError([] { decodeImage("", "x"); }, {"PNG", "JPEG"});
  expectJapaneseError([] { decodeImage("text", "x"); }, {"PNG", "JPEG"});
  expectJapaneseError([] { openRecording("/nowhere"); }, {"/nowhere"});
  const QString file = path("table");
  const QStringList names{file, "frame", "time_s", "left", "right", "points", "stop", "pan_deg"};
  for (const char* table : {"", "time_s\n1\n", "frame,time_s\n1\n", "frame,time_s,points\n-1,0,a\n",
                            "frame,time_s,points\n1,0,a\n1,0,a\n", "frame,time_s\n1,1\n"}) {
    writeFileAtomically(file.toStdString(), table);
    expectJapaneseError([&] { readFrameTable(file.toStdString()); }, names);
    expectJapaneseError([&] { readTum(file.toStdString()); },
                        names + QStringList{"time x y z qx qy qz qw"});
  }
  expectJapaneseError([] { calibrateStereo({}, {}, "x"); }, {});
}

TEST_F(SaidInJapanese, ARig) {
  const QStringList names{"x.json", "format",  "handmap-rig", "version", "name", "camera",
                          "device", "scanner", "odometry",    "ros",     "kind", "lines"};
  for (const char* rig :
       {"{}", R"({"format":"handmap-rig","version":99})",
        R"({"format":"handmap-rig","version":1,"name":"a","odometry":{"kind":"none"}})"}) {
    expectJapaneseError([&] { parseRig(rig, "x.json", "/tmp"); },
                        names + QStringList{"none", "visual", "scan"});
  }
  expectJapaneseError([] { parsePortAddress("", 9600); }, {"/dev/ttyUSB0@9600", "tcp://host:port"});
  expectJapaneseError([] { parseOdometryLine("odom"); }, {"odom,t,x,y,yaw", "odom", "JSON"});
  expectJapaneseError([] { parseJsonMessage("7"); }, {"JSON", "illegal value"});
}

TEST_F(SaidInJapanese, Devices) {
  BytePort port(parsePortAddress("/dev/nowhere", 9600), 1);
  QString why;
  QObject::connect(&port, &BytePort::lost, &port, [&](const QString& words) { why = words; });
  port.open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !why.isEmpty(); }, 5000));
  expectJapanese(why, {"nowhere", "dev"});

  Rig rig;
  rig.scanner.emplace();
  std::vector<std::string> refused;
  Assembler assembler(rig, {[](const Observation&) {}, [](double) {},
                            [&](const std::string& reason) { refused.push_back(reason); }});
  assembler.moved(100.0, {}, 0.0);
  assembler.moved(1.0, {}, 1.0);
  assembler.moved(1.0, {}, 1.0);
  assembler.scanned(1.0, {}, 1.0);
  EXPECT_EQ(refused.size(), 3u);
  for (const std::string& reason : refused) expectJapanese(QString::fromStdString(reason), {});

  double now_s = 0.0;
  RigMonitor monitor([&] { return now_s; });
  monitor.add(DeviceRole::Scanner);
  monitor.setState(DeviceRole::Scanner, DeviceState::Ready, {});
  monitor.datum(DeviceRole::Scanner, 0.0);
  now_s = 10.0;
  expectJapanese(QString::fromStdString(monitor.status().devices.front().detail), {});
}

TEST_F(SaidInJapanese, WarningsOfARun) {
  Map map;
  map.buildings = {Building()};
  map.buildings[0].shape = Rectangle{{10.0, 60.0}, 20.0, 10.0, 0.0};
  const std::vector<StampedPose> way{{0.0, {}}, {1.0, {20.0, 0.0, 0.0}}};
  for (const RunCounts& counts :
       {RunCounts{10, 0, true, 0, 0, 0.0}, RunCounts{10, 0, false, 0, 0, 0.0},
        RunCounts{10, 0, false, 9, 0, 0.0}, RunCounts{10, 0, false, 9, 9, 8.0},
        RunCounts{10, 9, false, 9, 9, 8.0}}) {
    for (const double range_limit_m : {10.0, 80.0}) {
      const auto warnings = runWarnings({counts, range_limit_m, map, map, way, true});
      ASSERT_EQ(warnings.size(), 1u);
      expectJapanese(QString::fromStdString(warnings[0].message), {});
      expectJapanese(QString::fromStdString(warnings[0].hint), {"--model none", "range_limit_m"});
    }
  }
  map.buildings[0].estimate = Estimate{1.0, 1.0, 1.0, 9};
  const auto at_end = runWarnings({{10, 9, false, 9, 9, 8.0}, 80.0, map, map, way, true, 107.0});
  ASSERT_EQ(at_end.size(), 1u);
  expectJapanese(QString::fromStdString(at_end[0].message), {});
}

}  // namespace
}  // namespace handmap
