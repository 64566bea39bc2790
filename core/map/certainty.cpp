#include "core/map/certainty.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/text.h"

namespace handmap {

namespace {

constexpr auto kSigmas = "wall_sigma_m";
constexpr auto kSeen = "walls_seen";
constexpr auto kDoubtful = "doubtful";

/// As a file that was read and written again has it.
std::string rounded(double value, double steps) {
  return formatNumber(std::round(value * steps) / steps);
}

/// The four values of a JSON array of plain ones; nullopt for anything else.
std::optional<std::array<std::string_view, 4>> fourOf(const Building& building, const char* key) {
  const auto member = building.unknown.find(key);
  if (member == building.unknown.end()) return std::nullopt;
  const std::string_view text = trimmed(member->second);
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  const auto fields = splitFields(text.substr(1, text.size() - 2), ',');
  if (fields.size() != 4) return std::nullopt;
  return std::array{fields[0], fields[1], fields[2], fields[3]};
}

std::optional<Sides> toldSides(const Building& building) {
  const auto sigmas = fourOf(building, kSigmas);
  const auto seen = fourOf(building, kSeen);
  if (!sigmas || !seen) return std::nullopt;
  Sides sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto sigma = parseFinite((*sigmas)[k]);
    if (!sigma || *sigma < 0.0) return std::nullopt;
    sides[k] = {*sigma, (*seen)[k] == "true"};
  }
  return sides;
}

}  // namespace

Sides sidesOf(const Building& building) {
  if (!building.estimate) return {};
  if (const auto told = toldSides(building)) return *told;
  const Estimate& estimate = *building.estimate;
  const Vec2 along = unitVector(building.box().heading);
  const Vec2 sigma(estimate.sigma_x, estimate.sigma_y);
  const bool seen = estimate.observations > 0;
  const SideEstimate ahead{std::hypot(sigma.cwiseProduct(along).norm(), 0.5 * estimate.sigma_width),
                           seen};
  // Of two opposite sides that are off each for itself.
  const SideEstimate aside{std::numbers::sqrt2 * sigma.cwiseProduct(perpendicular(along)).norm(),
                           seen};
  return {ahead, aside, ahead, aside};
}

void setSides(Building& building, const Sides& sides) {
  std::array<std::string, 4> sigmas;
  std::array<bool, 4> seen{};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    sigmas[k] = rounded(sides[k].sigma, 1e3);
    seen[k] = sides[k].seen;
  }
  building.unknown[kSigmas] = fmt::format("[{}]", fmt::join(sigmas, ","));
  building.unknown[kSeen] = fmt::format("[{}]", fmt::join(seen, ","));
}

std::vector<SideEstimate> wallsOf(const Building& building) {
  const Polygon footprint = building.footprint();
  const double heading = building.box().heading;
  const Sides sides = sidesOf(building);
  std::vector<SideEstimate> walls;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Vec2 along = footprint[(i + 1) % footprint.size()] - footprint[i];
    walls.push_back(sides[sideFacing(heading, -perpendicular(along))]);
  }
  return walls;
}

std::size_t sideFacing(double heading_rad, const Vec2& outwards) {
  const double turn = std::atan2(outwards.y(), outwards.x()) - heading_rad;
  return static_cast<std::size_t>((std::lround(normalizedAngle(turn) / (kPi / 2.0)) + 4) % 4);
}

double doubtOf(const Building& building) {
  const auto doubtful = building.unknown.find(kDoubtful);
  if (doubtful == building.unknown.end()) return 0.0;
  return parseFinite(doubtful->second).value_or(0.0);
}

void setDoubt(Building& building, double doubt) {
  building.unknown[kDoubtful] = rounded(doubt, 1e2);
}

void copyCertainty(const Building& from, Building& to) {
  forgetCertainty(to);
  for (const char* key : {kSigmas, kSeen, kDoubtful}) {
    const auto member = from.unknown.find(key);
    if (member != from.unknown.end()) to.unknown.insert(*member);
  }
}

void forgetSides(Building& building) {
  for (const char* key : {kSigmas, kSeen}) building.unknown.erase(key);
}

void forgetCertainty(Building& building) {
  forgetSides(building);
  building.unknown.erase(kDoubtful);
}

}  // namespace handmap
