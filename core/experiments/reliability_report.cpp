#include <algorithm>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/experiments/reliability.h"

namespace handmap {

namespace {

/// Between the ranges of stated probability that are looked at together.
constexpr std::array kEdges = {0.0, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0};
constexpr double kPercent = 100.0;

constexpr auto kReliabilityNotes =
    "\nStated: mean of what the runs said in that range. True: how often it was so, in brackets "
    "Wilson's 95 % interval as if all were independent; poses of one run, 5 m of way apart, and "
    "walls of one building are not quite. Pose: live, after each observation. Wall within its "
    "sigma: at the end, of buildings that were seen. The paper has no such figure.\n";

struct Subject {
  std::string name;
  std::vector<Statement> statements;
};

std::vector<Subject> subjectsOf(const std::vector<const RunStatements*>& runs) {
  std::vector<Subject> subjects;
  for (std::size_t i = 0; i <= method::kWithin_m.size(); ++i) {
    const bool walls = i == method::kWithin_m.size();
    Subject subject{walls ? "wall within its sigma"
                          : fmt::format("pose within {} m", formatNumber(method::kWithin_m[i])),
                    {}};
    for (const RunStatements* run : runs) {
      const auto& stated = walls ? run->walls : run->pose[i];
      subject.statements.insert(subject.statements.end(), stated.begin(), stated.end());
    }
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

struct Range {
  int count = 0;
  int so = 0;
  double stated = 0.0;  ///< sum, and the mean after summarised()
};

Range summarised(const std::vector<Statement>& statements, double from, double to) {
  Range range;
  for (const Statement& statement : statements) {
    if (statement.stated < from || (statement.stated >= to && to < 1.0)) continue;
    ++range.count;
    range.so += statement.so ? 1 : 0;
    range.stated += statement.stated;
  }
  if (range.count > 0) range.stated /= range.count;
  return range;
}

std::string cells(const Range& range) {
  const Interval share = wilsonInterval(range.so, range.count);
  return fmt::format("{} | {:.0f} % | {:.0f} % [{:.0f}–{:.0f} %]", range.count,
                     kPercent * range.stated, kPercent * share.value, kPercent * share.low,
                     kPercent * share.high);
}

void addRanges(const std::string& world, const Subject& subject, Report& report,
               ChartSeries& series) {
  for (std::size_t i = 0; i + 1 < kEdges.size(); ++i) {
    const Range range = summarised(subject.statements, kEdges[i], kEdges[i + 1]);
    if (range.count == 0) continue;
    const Interval share = wilsonInterval(range.so, range.count);
    report.markdown += fmt::format("| {} | {} | {:.0f}–{:.0f} % | {} |\n", subject.name, world,
                                   kPercent * kEdges[i], kPercent * kEdges[i + 1], cells(range));
    report.csv +=
        fmt::format("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f}\n", subject.name, world, kEdges[i],
                    kEdges[i + 1], range.count, range.stated, share.value, share.low, share.high);
    series.points.push_back(
        {kPercent * range.stated,
         {kPercent * share.value, kPercent * share.low, kPercent * share.high}});
  }
}

void addRuns(const std::vector<RunStatements>& runs, Report& report) {
  report.markdown +=
      "\n| run | subject | statements | stated | true |\n|:----|:--------|-----------:|-------:|"
      "-----:|\n";
  std::vector<std::string> names;
  for (const RunStatements& run : runs) {
    if (std::find(names.begin(), names.end(), run.name) != names.end()) continue;
    names.push_back(run.name);
    std::vector<const RunStatements*> same;
    for (const RunStatements& other : runs) {
      if (other.name == run.name) same.push_back(&other);
    }
    for (const Subject& subject : subjectsOf(same)) {
      if (subject.statements.empty()) continue;
      report.markdown += fmt::format("| {} | {} | {} |\n", run.name, subject.name,
                                     cells(summarised(subject.statements, 0.0, 1.0)));
    }
  }
}

}  // namespace

Report reliabilityReport(const std::vector<RunStatements>& runs) {
  Report report;
  report.markdown =
      "# Reliability: stated against true probability\n"
      "\n| subject | runs | stated between | statements | stated | true |\n"
      "|:--------|:-----|---------------:|-----------:|-------:|-----:|\n";
  report.csv = "subject,runs,from,to,statements,stated,true,true_low,true_high\n";
  for (std::size_t i = 0; i <= method::kWithin_m.size(); ++i) {
    Chart chart;
    chart.x_label = "stated (%)";
    chart.y_label = "true (%) with 95 % interval (Wilson)";
    chart.y_max = kPercent;
    ChartSeries as_stated{"as stated", SeriesLook::Drawing, {}};
    for (const double edge : {0.0, kPercent})
      as_stated.points.push_back({edge, {edge, edge, edge}});
    chart.series.push_back(as_stated);
    for (const bool simulated : {true, false}) {
      std::vector<const RunStatements*> of_world;
      for (const RunStatements& run : runs) {
        if (run.simulated == simulated) of_world.push_back(&run);
      }
      if (of_world.empty()) continue;
      const Subject subject = subjectsOf(of_world)[i];
      ChartSeries series{simulated ? "simulated" : "real",
                         simulated ? SeriesLook::Odometry : SeriesLook::Handmap,
                         {}};
      addRanges(series.name, subject, report, series);
      chart.title = fmt::format("Reliability: {}", subject.name);
      if (!series.points.empty()) chart.series.push_back(series);
    }
    const bool walls = i == method::kWithin_m.size();
    report.charts.emplace_back(
        walls ? "reliability-walls.png"
              : fmt::format("reliability-pose-{}m.png", formatNumber(method::kWithin_m[i])),
        chart);
  }
  addRuns(runs, report);
  report.markdown += kReliabilityNotes;
  for (const auto& [name, chart] : report.charts) {
    report.markdown += fmt::format("\n![{}]({})\n", chart.title, name);
  }
  return report;
}

}  // namespace handmap
