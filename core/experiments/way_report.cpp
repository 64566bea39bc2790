#include <algorithm>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/experiments/report.h"
#include "core/experiments/trial_table.h"

namespace handmap {

namespace {

constexpr std::size_t kRowEvery = 5;  // steps, in the table to read

constexpr auto kWayNotes =
    "\nWhat was known on the way, after each observation; medians over the trials with their "
    "distribution-free 95 % intervals. Map: mean of |x|, |front| and |width| over the buildings, "
    "also those not yet met. Ways end where the shortest trial does. The paper has no such "
    "figure.\n";

Interval intervalAt(const TrialGroup& group, std::size_t step, double TrialStep::*error) {
  std::vector<double> values;
  for (const Trial* trial : group.trials) values.push_back(trial->way[step].*error);
  return medianInterval(values);
}

std::size_t shortestTrial(const TrialGroup& group) {
  std::size_t steps = group.trials.empty() ? 0 : group.trials.front()->way.size();
  for (const Trial* trial : group.trials) steps = std::min(steps, trial->way.size());
  return steps;
}

std::string cell(const Interval& interval) {
  return fmt::format("{:.2f} [{:.2f}–{:.2f}]", interval.value, interval.low, interval.high);
}

ChartSeries curve(const TrialGroup& group, const std::string& name, SeriesLook look,
                  double TrialStep::*error) {
  ChartSeries series{name, look, {}};
  for (std::size_t step = 0; step < shortestTrial(group); ++step) {
    series.points.push_back(
        {static_cast<double>(step) * Trial::stepLength(), intervalAt(group, step, error)});
  }
  return series;
}

void addRows(const TrialGroup& group, Report& report) {
  for (std::size_t step = 0; step < shortestTrial(group); ++step) {
    const double way_m = static_cast<double>(step) * Trial::stepLength();
    const Interval pose = intervalAt(group, step, &TrialStep::pose);
    const Interval odometry = intervalAt(group, step, &TrialStep::odometry);
    const Interval map = intervalAt(group, step, &TrialStep::map);
    report.csv += fmt::format("{},{},{},{}", formatNumber(group.sigma_m), nameOf(group.method),
                              group.trials.size(), formatNumber(way_m));
    for (const Interval& part : {pose, odometry, map}) {
      report.csv += fmt::format(",{:.4f},{:.4f},{:.4f}", part.value, part.low, part.high);
    }
    report.csv += "\n";
    if (step % kRowEvery != 0 && step + 1 != shortestTrial(group)) continue;
    report.markdown += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", formatNumber(group.sigma_m), nameOf(group.method),
        group.trials.size(), formatNumber(way_m), cell(pose), cell(odometry), cell(map));
  }
}

/// The two charts of one σ, once both methods are in them.
void addCharts(const std::vector<TrialGroup>& groups, double sigma_m, Report& report) {
  const std::string sigma = formatNumber(sigma_m);
  Chart pose;
  pose.title = fmt::format("Pose error, drawings off by {} m", sigma);
  pose.y_label = "median error (m) with 95 % interval";
  pose.x_label = "way driven (m)";
  pose.kind = Chart::Kind::Band;
  Chart map = pose;
  map.title = fmt::format("Map error, drawings off by {} m", sigma);
  for (const TrialGroup& group : groups) {
    if (group.sigma_m != sigma_m || group.trials.empty()) continue;
    if (pose.series.empty()) {
      pose.series.push_back(curve(group, "odometry", SeriesLook::Odometry, &TrialStep::odometry));
    }
    const char* name = nameOf(group.method);
    pose.series.push_back(curve(group, name, lookOf(group.method), &TrialStep::pose));
    map.series.push_back(curve(group, name, lookOf(group.method), &TrialStep::map));
  }
  report.charts.emplace_back(fmt::format("way-pose-{}m.png", sigma), pose);
  report.charts.emplace_back(fmt::format("way-map-{}m.png", sigma), map);
}

}  // namespace

void addWay(const std::vector<TrialGroup>& groups, Report& report) {
  report.markdown +=
      "\n| sigma m | method | trials | way m | pose m | odometry m | map m |\n"
      "|--------:|:-------|-------:|------:|-------:|-----------:|------:|\n";
  report.csv = "sigma_m,method,trials,way_m";
  for (const char* part : {"pose", "odometry", "map"}) {
    report.csv += fmt::format(",{0},{0}_low,{0}_high", part);
  }
  report.csv += "\n";
  for (std::size_t i = 0; i < groups.size(); ++i) {
    addRows(groups[i], report);
    const bool last = i + 1 == groups.size() || groups[i + 1].sigma_m != groups[i].sigma_m;
    if (last) addCharts(groups, groups[i].sigma_m, report);
  }
  report.markdown += kWayNotes;
}

}  // namespace handmap
