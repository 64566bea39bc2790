#include "app/gui/window/command_line.h"

#include <QCommandLineParser>
#include <limits>

#include "core/base/error.h"

namespace handmap {

namespace {

[[noreturn]] void refuse(const QString& message) {
  throw Error(ErrorCode::Usage, message.toStdString(), "handmap --help lists the options.");
}

int wholeNumber(const QCommandLineParser& parser, const QString& option) {
  bool is_number = false;
  const int number = parser.value(option).toInt(&is_number);
  if (!is_number || number < 0) {
    refuse(QStringLiteral("--%1: found \"%2\", expected a whole number of 0 or more")
               .arg(option, parser.value(option)));
  }
  return number;
}

SourceKind sourceKind(const QString& text) {
  if (text == "auto") return SourceKind::Auto;
  if (text == "images") return SourceKind::Images;
  if (text == "points") return SourceKind::Points;
  refuse(QStringLiteral("--source: found \"%1\", expected auto, images or points").arg(text));
}

VirtualRigKind virtualRig(const QString& text) {
  if (text == "laser") return VirtualRigKind::Laser;
  if (text == "camera") return VirtualRigKind::StereoHead;
  refuse(QStringLiteral("--virtual-rig: found \"%1\", expected laser or camera").arg(text));
}

/// Qt has no options whose value may be left out.
QStringList withVirtualRig(QStringList arguments) {
  for (qsizetype i = 0; i < arguments.size(); ++i) {
    if (arguments[i] != "--virtual-rig") continue;
    const QString next = arguments.value(i + 1);
    const bool told = next == "laser" || next == "camera";
    arguments[i] += '=' + (told ? arguments.takeAt(i + 1) : QStringLiteral("laser"));
  }
  return arguments;
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      "Draw the map you remember; Handmap finds the robot on it and corrects the drawing.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "MAP", "What to open: a drawing (.handmap), or whatever else can be dropped on the window.",
      "[MAP]");
  parser.addOptions({
      {"recording", "Take the robot's observations from this folder.", "DIR"},
      {"rig", "Connect the live robot that this file describes.", "FILE"},
      {"virtual-rig",
       "Open two rows of buildings with a simulated live robot: laser (the default), or camera for "
       "a stereo head that stops and looks around.",
       "laser|camera"},
      {"from", "First frame of the recording.", "N", "0"},
      {"source", "What to take of the recording: auto, images or points.", "KIND", "auto"},
      {"seed", "Seed of the run.", "N"},
      {"demo", "Open the demonstration and run it."},
      {"run", "Begin to run at once."},
      {"fast", "As fast as possible, not by the recording's clock."},
      {"exit-after-run", "Leave when the run has ended."},
      {"verbose", "Say on stderr what the run does."},
      {"offscreen-report",
       "Run as fast as possible, print the errors before and after, write the corrected map, the "
       "trajectory and a screenshot to DIR, and leave.",
       "DIR"},
      {"guide-pictures", "Make the pictures of the guide in DIR, and leave.", "DIR"},
  });
  if (!parser.parse(withVirtualRig(arguments))) refuse(parser.errorText());
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();
  if (parser.positionalArguments().size() > 1) {
    refuse(QStringLiteral("found %1 maps, expected one").arg(parser.positionalArguments().size()));
  }

  CommandLine line;
  line.map = parser.positionalArguments().value(0);
  line.recording = parser.value("recording");
  line.rig = parser.value("rig");
  if (parser.isSet("virtual-rig")) line.virtual_rig = virtualRig(parser.value("virtual-rig"));
  line.exit_after_run = parser.isSet("exit-after-run");
  line.report_folder = parser.value("offscreen-report");
  const bool asked = parser.isSet("from") || parser.isSet("source");
  if (asked || line.isBatch()) {
    line.replay.emplace();
    line.replay->from = wholeNumber(parser, "from");
    line.replay->kind = sourceKind(parser.value("source"));
  }
  if (parser.isSet("fast")) line.speed = 0.0;
  if (parser.isSet("seed")) line.seed = wholeNumber(parser, "seed");
  line.demo = parser.isSet("demo");
  line.guide_folder = parser.value("guide-pictures");
  line.verbose = parser.isSet("verbose");
  if (!line.guide_folder.isEmpty()) return line;
  line.run = parser.isSet("run") || line.demo || line.isBatch();
  if (line.demo && !(line.map.isEmpty() && line.recording.isEmpty())) {
    refuse(QStringLiteral("--demo brings its own map and robot"));
  }
  const bool is_live = line.virtual_rig.has_value() || !line.rig.isEmpty();
  if (is_live && line.isBatch()) {
    refuse(QStringLiteral("a live robot has no end to wait for: handmap-cli run --for SECONDS"));
  }
  if (int(line.demo) + int(line.virtual_rig.has_value()) + int(!line.rig.isEmpty()) +
          int(!line.recording.isEmpty()) >
      1) {
    refuse(QStringLiteral("found more than one of --demo, --recording, --rig and --virtual-rig"));
  }
  if (line.virtual_rig && !line.map.isEmpty()) {
    refuse(QStringLiteral("--virtual-rig brings its own map"));
  }
  if (line.run && !line.demo && line.recording.isEmpty() && !is_live) {
    refuse(QStringLiteral("a run needs --recording, --rig, --virtual-rig or --demo"));
  }
  if (line.run && !line.demo && !line.virtual_rig && line.map.isEmpty()) {
    refuse(QStringLiteral("a run needs a MAP or --demo"));
  }
  return line;
}

}  // namespace handmap
