#include <algorithm>
#include <cmath>

#include "core/sketch_study/heavy_tails.h"
#include "core/sketch_study/people.h"
#include "core/sketch_study/size_line.h"

namespace handmap {

namespace {

/// An error, divided by what it is a share of, and that divisor.
struct Scaled {
  double share;
  double unit;
};
using Errors = std::vector<Scaled>;

Foretold foretell(const char* account, const std::vector<Errors>& fitted,
                  const std::vector<Errors>& left_out) {
  Foretold result{account};
  double count = 0.0;
  for (std::size_t person = 0; person < fitted.size(); ++person) {
    std::vector<double> shares;
    double square = 0.0;
    for (const Scaled& error : fitted[person]) {
      shares.push_back(error.share);
      square += error.share * error.share;
    }
    if (shares.empty()) continue;
    const HeavyTails tails = fitHeavyTails(shares);
    const double sigma = std::sqrt(square / static_cast<double>(shares.size()));
    for (double& share : shares) share = std::abs(share);
    const double bound_68 = quantile(shares, 0.68);
    const double bound_95 = quantile(shares, 0.95);
    for (const Scaled& error : left_out[person]) {
      ++count;
      result.within_68 += std::abs(error.share) <= bound_68;
      result.within_95 += std::abs(error.share) <= bound_95;
      result.normal_score += normalLogDensity(error.share, sigma) - std::log(error.unit);
      result.heavy_score += tails.logDensity(error.share) - std::log(error.unit);
    }
  }
  for (double* sum :
       {&result.within_68, &result.within_95, &result.normal_score, &result.heavy_score}) {
    *sum /= std::max(1.0, count);
  }
  return result;
}

std::vector<DrawnErrors> without(const std::vector<DrawnErrors>& drawings, std::size_t person) {
  std::vector<DrawnErrors> others = drawings;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(person));
  return others;
}

using Unit = double (*)(const DrawnErrors& drawing, const DrawnError& error);

Errors placesIn(const std::vector<DrawnErrors>& drawings, Unit unit) {
  Errors errors;
  for (const DrawnErrors& drawing : drawings) {
    for (const DrawnError& error : drawing.of) {
      if (error.size <= 0.0) continue;
      const double of = unit(drawing, error);
      for (const int axis : {0, 1}) errors.push_back({error.fullOff()[axis] / of, of});
    }
  }
  return errors;
}

Errors sizesIn(const std::vector<DrawnErrors>& drawings, const SizeLine& line) {
  Errors errors;
  for (const DrawnErrors& drawing : drawings) {
    const double middle = middleSize(drawing);
    for (const DrawnError& error : drawing.of) {
      if (!error.log_size) continue;
      errors.push_back({*error.log_size - line.tells(error.size, middle), 1.0});
    }
  }
  return errors;
}

}  // namespace

std::vector<Foretold> foretellPlaces(const std::vector<DrawnErrors>& drawings) {
  const std::pair<const char*, Unit> accounts[] = {
      {"the same everywhere", [](const DrawnErrors&, const DrawnError&) { return 1.0; }},
      {"with the extent", [](const DrawnErrors& d, const DrawnError&) { return d.extent; }},
      {"with the size", [](const DrawnErrors&, const DrawnError& e) { return e.size; }}};
  std::vector<Foretold> told;
  for (const auto& account : accounts) {
    std::vector<Errors> fitted;
    std::vector<Errors> left_out;
    for (std::size_t person = 0; person < drawings.size(); ++person) {
      fitted.push_back(placesIn(without(drawings, person), account.second));
      left_out.push_back(placesIn({drawings[person]}, account.second));
    }
    told.push_back(foretell(account.first, fitted, left_out));
  }
  return told;
}

std::vector<Foretold> foretellSizes(const std::vector<DrawnErrors>& drawings) {
  std::vector<Foretold> told;
  for (const char* account : {"as they are", "times a factor", "pulled to the mean"}) {
    const std::size_t kind = told.size();
    std::vector<Errors> fitted;
    std::vector<Errors> left_out;
    for (std::size_t person = 0; person < drawings.size(); ++person) {
      const std::vector<DrawnErrors> others = without(drawings, person);
      SizeLine line = sizeLine(others);
      if (kind < 2) line.slope = 1.0;
      if (kind < 1) line.bias = 0.0;
      fitted.push_back(sizesIn(others, line));
      left_out.push_back(sizesIn({drawings[person]}, line));
    }
    told.push_back(foretell(account, fitted, left_out));
  }
  return told;
}

}  // namespace handmap
