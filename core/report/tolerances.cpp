#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/evaluation/comparison.h"
#include "core/map/certainty.h"
#include "core/map/concerns.h"
#include "core/report/report.h"

namespace handmap {

namespace {

/// What the columns of the tables mean, a line each.
constexpr std::array kColumns = {
    "side: of the building's box, from 0 (where its heading points) counter-clockwise",
    "sigma: across the wall, metres; seen: whether the robot saw it",
    "the last three: probability that the wall is off by no more than so many metres, its building",
    "being the right one or not",
};

std::string columnsAfter(std::string_view mark) {
  std::string text;
  for (const char* line : kColumns) text += fmt::format("{} {}\n", mark, line);
  return text;
}

constexpr double kLeastSigma_m = 1e-3;

std::string quotedForCsv(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string escapedForLatex(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\') {
      safe += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      safe += fmt::format("\\{}{{}}", c);
    } else {
      if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) safe += '\\';
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::vector<WallTolerance> tolerancesOf(const Map& drawing, const Map& refined) {
  std::vector<WallTolerance> walls;
  for (const Building& building : refined.buildings) {
    if (!building.estimate) continue;
    const Building* drawn = drawing.find(building.id);
    const double misfitted = drawn ? misfitProbability(drawing, *drawn, building) : 0.0;
    const double right = 1.0 - std::max(misfitted, building.doubt.value_or(0.0));
    const Sides sides = sidesOf(building);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      WallTolerance wall{building.id, static_cast<int>(k), sides[k].sigma, sides[k].seen, {}};
      const double sigma = std::max(sides[k].sigma, kLeastSigma_m);
      for (std::size_t i = 0; i < kTolerances_m.size(); ++i) {
        wall.within[i] = right * std::erf(kTolerances_m[i] / (std::numbers::sqrt2 * sigma));
      }
      walls.push_back(std::move(wall));
    }
  }
  return walls;
}

double wallOffset(const Building& found, const Building& truth, int side) {
  const auto outwards = [](const Rectangle& box, int of) {
    return unitVector(box.heading + of * kPi / 2.0);
  };
  const auto middle = [&](const Rectangle& box, int of) {
    return Vec2(box.centre + 0.5 * (of % 2 == 0 ? box.width : box.depth) * outwards(box, of));
  };
  const Rectangle box = found.box();
  const Rectangle real = truth.box();
  const double turn = normalizedAngle(box.heading - real.heading);
  const int there = (side + static_cast<int>(std::lround(turn / (kPi / 2.0))) + 4) % 4;
  return std::abs((middle(box, side) - middle(real, there)).dot(outwards(real, there)));
}

Survey surveyOf(const Map& drawing, const Map& refined, const Map& truth) {
  Survey survey;
  survey.buildings = static_cast<int>(truth.buildings.size());
  for (const BuildingError& error : compareMaps(refined, truth, false).buildings) {
    survey.present += error.overlaps ? 1 : 0;
  }
  for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
    const Building* drawn = drawing.find(wall.building);
    const Building* real = truth.find(wall.building);
    if (!wall.seen || drawn == nullptr || real == nullptr) continue;
    ++survey.walls;
    const double before = wallOffset(*drawn, *real, wall.side);
    const double after = wallOffset(*refined.find(wall.building), *real, wall.side);
    survey.rms_before_m += before * before;
    survey.rms_after_m += after * after;
    for (std::size_t i = 0; i < kTolerances_m.size(); ++i) {
      survey.within_before[i] += before <= kTolerances_m[i] ? 1 : 0;
      survey.within_after[i] += after <= kTolerances_m[i] ? 1 : 0;
    }
  }
  for (double* rms : {&survey.rms_before_m, &survey.rms_after_m}) {
    *rms = std::sqrt(*rms / std::max(1, survey.walls));
  }
  return survey;
}

std::string tolerancesCsv(const Map& drawing, const Map& refined) {
  std::string text =
      columnsAfter("#") + "building,side,sigma_m,seen,within_0.3_m,within_0.6_m,within_1.2_m\n";
  for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
    text += fmt::format("{},{},{:.3f},{},{:.3f},{:.3f},{:.3f}\n", quotedForCsv(wall.building),
                        wall.side, wall.sigma, wall.seen ? 1 : 0, wall.within[0], wall.within[1],
                        wall.within[2]);
  }
  return text;
}

std::string tolerancesLatex(const Map& drawing, const Map& refined) {
  std::string text =
      columnsAfter("%") +
      "\\begin{tabular}{lrrcrrr}\n"
      "building & side & $\\sigma$ (m) & seen & 0.3 m & 0.6 m & 1.2 m \\\\ \\hline\n";
  for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
    text += fmt::format("{} & {} & {:.2f} & {} & {:.2f} & {:.2f} & {:.2f} \\\\\n",
                        escapedForLatex(wall.building), wall.side, wall.sigma,
                        wall.seen ? "yes" : "no", wall.within[0], wall.within[1], wall.within[2]);
  }
  return text + "\\end{tabular}\n";
}

}  // namespace handmap
