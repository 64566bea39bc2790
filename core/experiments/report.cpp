#include "core/experiments/report.h"

#include <algorithm>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/text.h"
#include "core/experiments/trial_table.h"

namespace handmap {

namespace {

std::vector<TrialGroup> groupsOf(const Experiment& experiment,
                                 const std::map<TrialKey, Trial>& trials) {
  std::vector<TrialGroup> groups;
  for (const TrialKey& key : trialsOf(experiment)) {
    if (groups.empty() || groups.back().method != key.method ||
        groups.back().sigma_m != key.sigma_m) {
      groups.push_back({key.method, key.sigma_m, {}});
    }
    const auto there = trials.find(key);
    if (there != trials.end()) groups.back().trials.push_back(&there->second);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const TrialGroup& a, const TrialGroup& b) { return a.sigma_m < b.sigma_m; });
  return groups;
}

std::string conditions(const Experiment& experiment, const std::vector<TrialGroup>& groups) {
  const TrialSettings& settings = experiment.settings;
  std::size_t done = 0;
  for (const TrialGroup& group : groups) done += group.trials.size();
  const std::size_t all = trialsOf(experiment).size();
  std::string text = fmt::format(
      "Simulated: six buildings in two rows, known start, range points; trials from seed {} on, "
      "{}{}."
      " paper: the published FastSLAM/PSOM, {} particles, swarms of {}.\n",
      settings.seed,
      settings.keeping == Keeping::SideAndOrder ? "drawings keep side and order of the buildings"
                                                : "drawings need not keep side and order",
      settings.like == Like::People
          ? ", errors like those of people: correlated, sizes pulled to the mean, outlines turned"
          : "",
      settings.slam_particles, settings.pso_particles);
  if (done < all) text += fmt::format("\n**Not whole: {} of {} trials are there.**\n", done, all);
  return text;
}

}  // namespace

SeriesLook lookOf(Method method) {
  return method == Method::Paper ? SeriesLook::Paper : SeriesLook::Handmap;
}

Report reportOf(const Experiment& experiment, const std::map<TrialKey, Trial>& trials) {
  const TrialSettings& settings = experiment.settings;
  const std::vector<TrialGroup> groups = groupsOf(experiment, trials);
  Report report;
  const std::string below = fmt::format("\n{}", conditions(experiment, groups));
  switch (experiment.kind) {
    case ExperimentKind::Table2:
      report.markdown = "# Table 2: success against the error of the drawing\n" + below;
      addSuccess(groups, settings.like, report);
      break;
    case ExperimentKind::Figure8:
      report.markdown =
          "# Figure 8: errors of the buildings against the error of the drawing\n" + below;
      addErrors(groups, report);
      break;
    case ExperimentKind::Way:
      report.markdown = "# Errors over the way\n" + below;
      addWay(groups, report);
      break;
  }
  for (const auto& [name, chart] : report.charts) {
    report.markdown += fmt::format("\n![{}]({})\n", chart.title, name);
  }
  return report;
}

void writeReport(const Report& report, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, chart] : report.charts) {
    std::vector<uchar> png;
    cv::imencode(".png", drawn(chart), png);
    writeFileAtomically(folder / name, std::string(png.begin(), png.end()));
  }
  writeFileAtomically(folder / "report.csv", report.csv);
  writeFileAtomically(folder / "report.md", report.markdown);
}

}  // namespace handmap
