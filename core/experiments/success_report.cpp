#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/experiments/report.h"
#include "core/experiments/trial_table.h"

namespace handmap {

namespace {

/// What is known of the published method in scenes of this kind.
struct KnownSuccess {
  double sigma_m;
  const char* published;  ///< the paper's own Table II
  const char* naive;      ///< of a quick prototype
};
constexpr std::array kKnown = {KnownSuccess{1.0, "5/5", "10/10"}, KnownSuccess{5.0, "5/5", "10/10"},
                               KnownSuccess{10.0, "4/5", "8/10"}, KnownSuccess{12.5, "1/5", "7/10"},
                               KnownSuccess{15.0, "1/5", "5/10"}};

constexpr auto kSuccessNotes =
    "\nLoose: every building of the corrected map overlaps its true one, the paper's measure. "
    "Strict: every one has an IoU of at least 0.5. In brackets Wilson's 95 % interval. "
    "Published: loose success in the paper's own Table II (Matsuo and Miura, IROS 2012; 100 "
    "particles, swarms of 20), as handed down. Naive: that of a quick prototype of the published "
    "method, other seeds.\n";

KnownSuccess knownAt(const TrialGroup& group, Like like) {
  if (group.method == Method::Paper && like == Like::Sigma) {
    for (const KnownSuccess& known : kKnown) {
      if (known.sigma_m == group.sigma_m) return known;
    }
  }
  return {group.sigma_m, "", ""};
}

std::string cell(int successes, const Interval& share) {
  return fmt::format("{} [{:.0f}–{:.0f} %]", successes, 100.0 * share.low, 100.0 * share.high);
}

Interval percent(const Interval& share) {
  return {100.0 * share.value, 100.0 * share.low, 100.0 * share.high};
}

ChartSeries& seriesOf(Method method, Chart& chart) {
  for (ChartSeries& series : chart.series) {
    if (series.look == lookOf(method)) return series;
  }
  chart.series.push_back({nameOf(method), lookOf(method), {}});
  return chart.series.back();
}

}  // namespace

void addSuccess(const std::vector<TrialGroup>& groups, Like like, Report& report) {
  report.markdown +=
      "\n| sigma m | method | trials | loose | strict | published | naive |\n"
      "|--------:|:-------|-------:|------:|-------:|----------:|------:|\n";
  report.csv = "sigma_m,method,trials,loose,loose_low,loose_high,strict,strict_low,strict_high\n";
  const auto new_chart = [](const std::string& title) {
    Chart chart;
    chart.title = title;
    chart.x_label = "error of the drawing, sigma (m)";
    chart.y_label = "success (%) with 95 % interval (Wilson)";
    chart.y_max = 100.0;
    return chart;
  };
  Chart loose_chart = new_chart("Every building overlaps its true one");
  Chart strict_chart = new_chart("Every building has an IoU of at least 0.5");
  for (const TrialGroup& group : groups) {
    const auto count = [&](auto success) {
      return static_cast<int>(std::count_if(group.trials.begin(), group.trials.end(), success));
    };
    const auto trials = static_cast<int>(group.trials.size());
    const int loose = count([](const Trial* trial) { return trial->loose(); });
    const int strict = count([](const Trial* trial) { return trial->strict(); });
    const Interval l = wilsonInterval(loose, trials);
    const Interval s = wilsonInterval(strict, trials);
    const KnownSuccess known = knownAt(group, like);
    report.markdown += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n",
                                   formatNumber(group.sigma_m), nameOf(group.method), trials,
                                   cell(loose, l), cell(strict, s), known.published, known.naive);
    report.csv +=
        fmt::format("{},{},{},{},{:.4f},{:.4f},{},{:.4f},{:.4f}\n", formatNumber(group.sigma_m),
                    nameOf(group.method), trials, loose, l.low, l.high, strict, s.low, s.high);
    if (trials == 0) continue;
    seriesOf(group.method, loose_chart).points.push_back({group.sigma_m, percent(l)});
    seriesOf(group.method, strict_chart).points.push_back({group.sigma_m, percent(s)});
  }
  report.markdown += kSuccessNotes;
  report.charts = {{"table2-loose.png", loose_chart}, {"table2-strict.png", strict_chart}};
}

}  // namespace handmap
