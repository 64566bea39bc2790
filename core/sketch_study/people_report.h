// What several drawings tell of how people draw, for people and for programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sketch_study/people.h"

namespace handmap {

struct PeopleReport {
  std::vector<DrawnErrors> drawings;
  PeopleFigures figures;
  std::vector<FigureRange> intervals;
  std::vector<Foretold> places;
  std::vector<Foretold> sizes;
};

/// Intervals are of 2,000 draws.
PeopleReport peopleReport(std::vector<DrawnErrors> drawings, std::uint64_t seed);

std::string formatText(const PeopleReport& report);
std::string formatJson(const PeopleReport& report);

}  // namespace handmap
