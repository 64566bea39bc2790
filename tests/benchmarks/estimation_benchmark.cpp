// Success, errors and time of the estimator:
//   estimation_benchmark [trials [first_seed [option=value …]]]
// Options: undrawn, phantom, clutter, turned (degrees), free, sigma (one instead of five),
// street=DIR.
#include <algorithm>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "tests/benchmarks/estimation_trials.h"

namespace handmap {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

struct Errors {
  std::vector<double> x, front, width;
  void add(const std::vector<BuildingError>& errors, const std::vector<std::string>& only = {}) {
    for (const BuildingError& e : errors) {
      if (!only.empty() && std::find(only.begin(), only.end(), e.id) == only.end()) continue;
      x.push_back(std::abs(e.x));
      front.push_back(std::abs(e.front));
      width.push_back(std::abs(e.width));
    }
  }
  std::string text() const {
    return fmt::format("x {:.2f} front {:.2f} width {:.2f}", quantile(x, 0.5), quantile(front, 0.5),
                       quantile(width, 0.5));
  }
};

void table(TrialConditions conditions, const std::vector<double>& sigmas, int trials,
           std::uint64_t first, bool verbose) {
  for (const double sigma : sigmas) {
    conditions.sigma_m = sigma;
    int loose = 0, strict = 0, doubtful = 0;
    Errors as_it_is, aligned;
    std::vector<double> ratios, frame_ms, finish_ms;
    for (int i = 0; i < trials; ++i) {
      const TrialResult r = twoRowTrial(conditions, first + static_cast<std::uint64_t>(i));
      loose += r.loose;
      strict += r.strict;
      doubtful += r.doubtful > 0;
      as_it_is.add(r.as_it_is);
      aligned.add(r.aligned);
      ratios.push_back(r.pose_rms / r.odometry_rms);
      frame_ms.insert(frame_ms.end(), r.frame_ms.begin(), r.frame_ms.end());
      finish_ms.push_back(r.finish_ms);
      if (verbose) {
        Errors one;
        one.add(r.aligned);
        fmt::print("  seed {} loose {} strict {} rms {:.2f}/{:.2f} {}\n",
                   first + static_cast<unsigned>(i), r.loose, r.strict, r.pose_rms, r.odometry_rms,
                   one.text());
        for (const auto& e : r.aligned) {
          fmt::print("      {} x {:.2f} front {:.2f} width {:.2f} iou {:.2f}\n", e.id, e.x, e.front,
                     e.width, e.iou);
        }
      }
    }
    fmt::print(
        "sigma {:>4} loose {}/{} strict {} doubtful {} | aligned {} | as is {} | pose ratio "
        "{:.2f} | ms p50 {:.1f} p95 {:.1f} finish {:.0f}\n",
        sigma, loose, trials, strict, doubtful, aligned.text(), as_it_is.text(),
        quantile(ratios, 0.5), quantile(frame_ms, 0.5), quantile(frame_ms, 0.95),
        quantile(finish_ms, 0.5));
  }
}

void street(const std::filesystem::path& folder, EstimatorOptions options) {
  const Map truth = readMap(folder / "truth.handmap");
  const std::vector<std::string> six = {"L4", "L5", "L6", "R4", "R5", "R6"};
  for (const char* name : {"a", "b", "c"}) {
    const Map drawing = readMap(folder / (std::string("sketch-") + name + ".handmap"));
    ReplayOptions replay_options;
    replay_options.from = 40;
    replay_options.kind = SourceKind::Points;
    const auto source = replay(openRecording(folder), replay_options);
    const TrialResult r = runTrial(drawing, truth, *source, options);
    Errors best;
    best.add(r.aligned, six);
    Errors as_it_is;
    as_it_is.add(r.as_it_is, six);
    fmt::print("{}: aligned {} | as is {} | rms {:.2f}/{:.2f} | ms p95 {:.1f} finish {:.0f} | iou",
               name, best.text(), as_it_is.text(), r.pose_rms, r.odometry_rms,
               quantile(r.frame_ms, 0.95), r.finish_ms);
    for (const auto& e : r.aligned) fmt::print(" {} {:.2f}({:.2f})", e.id, e.iou, e.x);
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  using namespace handmap;
  const int trials = argc > 1 ? std::atoi(argv[1]) : 2;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  TrialConditions conditions;
  std::vector<double> sigmas = {1.0, 5.0, 10.0, 15.0, 25.0};
  bool verbose = false;
  std::string street_folder;
  for (int i = 3; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto equals = argument.find('=');
    const std::string key = argument.substr(0, equals);
    const std::string text = equals == std::string::npos ? "1" : argument.substr(equals + 1);
    const double value = std::atof(text.c_str());
    if (key == "undrawn") conditions.undrawn = value;
    if (key == "phantom") conditions.phantom = true;
    if (key == "clutter") conditions.clutter = value;
    if (key == "turned") conditions.turned_rad = toRadians(value);
    if (key == "free") {
      conditions.free = true;
      conditions.options.assignment.free_scale = conditions.options.assignment.free_turn = true;
    }
    if (key == "sigma") sigmas = {value};
    if (key == "verbose") verbose = true;
    if (key == "street") street_folder = text;
  }
  if (trials > 0) table(conditions, sigmas, trials, first, verbose);
  if (!street_folder.empty()) street(street_folder, conditions.options);
  return 0;
}
