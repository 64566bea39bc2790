#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/experiments/report.h"
#include "core/experiments/trial_table.h"

namespace handmap {

namespace {

constexpr std::array kMeasures = {"x", "front", "width"};
constexpr std::size_t kBuildings = Trial::kBuildings.size();

constexpr auto kErrorNotes =
    "\nAbsolute errors in metres, as they are (no alignment), mean / median, of the drawing → of "
    "the corrected map. The charts of the buildings show medians with their distribution-free 95 % "
    "intervals, those against sigma the mean of the six. The paper's own Fig. 8 (Matsuo and Miura, "
    "IROS 2012) has the mean absolute errors of x and width of each building; noise up to about "
    "25 % of the widths, and both rise with it. Its numbers are not handed down.\n";

struct Errors {
  std::vector<double> drawn;
  std::vector<double> found;
};

/// `building` = kBuildings: of all.
Errors errorsOf(const TrialGroup& group, std::size_t building, std::size_t measure) {
  Errors errors;
  for (const Trial* trial : group.trials) {
    for (std::size_t i = 0; i < kBuildings; ++i) {
      if (building != kBuildings && i != building) continue;
      errors.drawn.push_back(std::abs(trial->buildings[i].drawn[measure]));
      errors.found.push_back(std::abs(trial->buildings[i].found[measure]));
    }
  }
  return errors;
}

std::string meanAndMedian(const std::vector<double>& values) {
  return fmt::format("{:.2f} / {:.2f}", meanOf(values), medianInterval(values).value);
}

void addRows(const TrialGroup& group, Report& report) {
  for (std::size_t building = 0; building <= kBuildings; ++building) {
    const std::string name = building == kBuildings ? "all" : Trial::kBuildings[building];
    report.markdown += fmt::format("| {} | {} |", name, nameOf(group.method));
    for (std::size_t measure = 0; measure < kMeasures.size(); ++measure) {
      const Errors errors = errorsOf(group, building, measure);
      report.markdown +=
          fmt::format(" {} → {} |", meanAndMedian(errors.drawn), meanAndMedian(errors.found));
      const Interval drawn = medianInterval(errors.drawn);
      const Interval found = medianInterval(errors.found);
      report.csv += fmt::format(
          "{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", formatNumber(group.sigma_m),
          nameOf(group.method), name, kMeasures[measure], group.trials.size(), meanOf(errors.drawn),
          drawn.value, meanOf(errors.found), found.value, found.low, found.high);
    }
    report.markdown += "\n";
  }
}

ChartSeries series(const std::string& name, SeriesLook look) { return {name, look, {}}; }

/// Groups of one σ.
Chart chartOf(const std::vector<const TrialGroup*>& groups, std::size_t measure) {
  Chart chart;
  chart.title = fmt::format("Error of {}, drawings off by {} m", kMeasures[measure],
                            formatNumber(groups.front()->sigma_m));
  chart.x_label = "building";
  chart.y_label = "median absolute error (m) with 95 % interval";
  for (const char* id : Trial::kBuildings) chart.categories.emplace_back(id);
  chart.series.push_back(series("drawn", SeriesLook::Drawing));
  for (const TrialGroup* group : groups) {
    if (group->trials.empty()) continue;
    ChartSeries found = series(nameOf(group->method), lookOf(group->method));
    const bool first = chart.series.size() == 1;
    for (std::size_t building = 0; building < kBuildings; ++building) {
      const Errors errors = errorsOf(*group, building, measure);
      const auto x = static_cast<double>(building);
      if (first) chart.series.front().points.push_back({x, medianInterval(errors.drawn)});
      found.points.push_back({x, medianInterval(errors.found)});
    }
    chart.series.push_back(found);
  }
  return chart;
}

Chart chartAgainstSigma(const std::vector<TrialGroup>& groups, std::size_t measure) {
  Chart chart;
  chart.title = fmt::format("Error of {} against the error of the drawing", kMeasures[measure]);
  chart.x_label = "error of the drawing, sigma (m)";
  chart.y_label = "mean absolute error (m) with 95 % interval";
  chart.series = {series("drawn", SeriesLook::Drawing),
                  series(nameOf(Method::Handmap), SeriesLook::Handmap),
                  series(nameOf(Method::Paper), SeriesLook::Paper)};
  for (const TrialGroup& group : groups) {
    if (group.trials.empty()) continue;
    const Errors errors = errorsOf(group, kBuildings, measure);
    auto& drawn = chart.series.front().points;
    if (drawn.empty() || drawn.back().x != group.sigma_m) {
      drawn.push_back({group.sigma_m, meanInterval(errors.drawn)});
    }
    for (ChartSeries& found : chart.series) {
      if (found.look != lookOf(group.method)) continue;
      found.points.push_back({group.sigma_m, meanInterval(errors.found)});
    }
  }
  std::erase_if(chart.series, [](const ChartSeries& s) { return s.points.empty(); });
  return chart;
}

}  // namespace

void addErrors(const std::vector<TrialGroup>& groups, Report& report) {
  report.csv =
      "sigma_m,method,building,measure,trials,drawn_mean,drawn_median,mean,median,median_low,"
      "median_high\n";
  for (std::size_t begin = 0; begin < groups.size();) {
    std::vector<const TrialGroup*> same;
    for (; begin < groups.size() && (same.empty() || groups[begin].sigma_m == same[0]->sigma_m);
         ++begin) {
      same.push_back(&groups[begin]);
    }
    const std::string sigma = formatNumber(same[0]->sigma_m);
    report.markdown += fmt::format("\n## Drawings off by {} m\n\n", sigma);
    for (const TrialGroup* group : same) {
      report.markdown +=
          fmt::format("{}: {} trials. ", nameOf(group->method), group->trials.size());
    }
    report.markdown +=
        "\n\n| building | method | x m | front m | width m |\n"
        "|:---------|:-------|----:|--------:|--------:|\n";
    for (const TrialGroup* group : same) addRows(*group, report);
    for (std::size_t measure = 0; measure < kMeasures.size(); ++measure) {
      report.charts.emplace_back(fmt::format("fig8-{}-{}m.png", kMeasures[measure], sigma),
                                 chartOf(same, measure));
    }
  }
  for (const std::size_t measure : {std::size_t{0}, std::size_t{2}}) {
    report.charts.emplace_back(fmt::format("fig8-{}.png", kMeasures[measure]),
                               chartAgainstSigma(groups, measure));
  }
  report.markdown += kErrorNotes;
}

}  // namespace handmap
