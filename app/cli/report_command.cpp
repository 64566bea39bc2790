#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/run_folder.h"
#include "core/bags/ros_messages.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/report/report.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostReportBytes = 1u << 30;

struct ReportArguments {
  std::string run;
  std::string truth;
  std::string recording;
  std::string out;
  ReportLanguage language = ReportLanguage::English;
};

/// As the run's MCAP has them; none where there is no such file.
std::vector<ReportedParticles> particlesIn(const std::string& mcap) {
  std::vector<ReportedParticles> all;
  if (!std::filesystem::is_regular_file(mcap)) return all;
  const auto bag = openBag(mcap);
  std::vector<bool> wanted;
  for (const BagTopic& topic : bag->topics()) {
    wanted.push_back(topic.name == "/particles" && ros::isPointCloud(topic));
  }
  bag->read(wanted,
            [&](const BagMessage& message) {
              const ros::Points cloud =
                  ros::readPoints(bag->fieldsOf(message), bag->topics()[message.topic]);
              ReportedParticles& particles = all.emplace_back();
              particles.time_s = cloud.header.stamp_s;
              for (const RangePoint& p : cloud.points) particles.points.emplace_back(p.x, p.y);
            },
            {});
  return all;
}

ReportInputs inputsOf(const RunFolder& kept, const ReportArguments& arguments) {
  ReportInputs inputs;
  inputs.drawing = readMap(kept.drawing());
  inputs.refined = readMap(kept.refined());
  inputs.run = readFile(kept.report(), kMostReportBytes);
  inputs.run_file = kept.report();
  inputs.trajectory = readTum(kept.trajectory()).poses();
  inputs.particles = particlesIn(kept.mcap());
  inputs.language = arguments.language;
  if (!arguments.truth.empty()) inputs.truth = readMap(arguments.truth);
  if (!arguments.recording.empty()) inputs.recording = openRecording(arguments.recording);
  return inputs;
}

/// A run may be larger than memory. The old file stays whole where it fails.
void copyFile(const std::string& from, const std::string& to) {
  if (!std::filesystem::is_regular_file(from)) {
    throw Error(ErrorCode::BadInput,
                fmt::format("{}: found no such file, expected a readable file", from));
  }
  const std::string part = to + ".part";
  std::error_code error;
  std::filesystem::copy_file(from, part, std::filesystem::copy_options::overwrite_existing, error);
  if (!error) std::filesystem::rename(part, to, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw Error(ErrorCode::RunFailed, fmt::format("{}: cannot be written: {}", to, error.message()));
}

int report(const ReportArguments& arguments) {
  const RunFolder kept{arguments.run};
  checkOutputFiles({arguments.out}, {kept.drawing(), kept.refined(), kept.report(),
                                     kept.trajectory(), kept.mcap(), arguments.truth});
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  if (ending == ".html") {
    writeFileAtomically(arguments.out, reportHtml(inputsOf(kept, arguments)));
  } else if (ending == ".pdf") {
    writeFileAtomically(arguments.out, reportPdf(inputsOf(kept, arguments)));
  } else if (ending == ".csv") {
    writeFileAtomically(arguments.out,
                        tolerancesCsv(readMap(kept.drawing()), readMap(kept.refined())));
  } else if (ending == ".tex") {
    writeFileAtomically(arguments.out,
                        tolerancesLatex(readMap(kept.drawing()), readMap(kept.refined())));
  } else if (ending == ".mcap") {
    copyFile(kept.mcap(), arguments.out);
  } else {
    throw Error(ErrorCode::Usage, fmt::format("--out: found {}, expected NAME.html, .pdf, .csv, "
                                              ".tex or .mcap",
                                              arguments.out));
  }
  return 0;
}

}  // namespace

void addReportCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<ReportArguments>();
  ReportArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("report", "Make a page of a run that anybody can open, or a table");
  command->callback([&chosen, arguments] { chosen = [arguments] { return report(*arguments); }; });
  command->add_option("--run", a.run, "What run --keep wrote (required)")
      ->required()
      ->option_text("DIR");
  command->add_option("--truth", a.truth, "A true map, to be drawn beside")
      ->option_text("T.handmap");
  command->add_option("--recording", a.recording, "For pictures on the way")->option_text("DIR");
  addChoice(*command, "--language", a.language,
            {{"en", ReportLanguage::English}, {"ja", ReportLanguage::Japanese}},
            "Of what is printed (.pdf); the page (.html) has both");
  command
      ->add_option("--out", a.out,
                   "The page (.html, which refers to nothing outside; .pdf), how sure each wall is "
                   "(.csv, .tex), or the run as messages of ROS 2 (.mcap) (required)")
      ->required()
      ->option_text("FILE");
}

}  // namespace handmap
