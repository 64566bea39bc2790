// What a map file holds beyond the format: members of our own ("handmap:hidden", "walls_seen" …),
// which other readers pass over. For reader and writer alone: everybody else finds fields.
#pragma once

#include "core/map/map.h"

namespace handmap {

// After the file's other members are in `unknown`: what is ours becomes fields. A member that does
// not say what it should counts as absent and stays, so that nothing is lost, but a damaged start
// uncertainty: that throws BadInput "SOURCE: handmap:start_uncertainty…".
void takeOwnMembers(Building& building);
void takeOwnMembers(Landmark& landmark);
void takeOwnMembers(Underlay& underlay);
void takeOwnMembers(Map& map, const std::string& source);

// The unknown members and our own, as a file has them. What was read and says the same as the field
// is written as it came.
UnknownMembers withOwnMembers(const Building& building);
UnknownMembers withOwnMembers(const Landmark& landmark);
UnknownMembers withOwnMembers(const Underlay& underlay);
UnknownMembers withOwnMembers(const Map& map);

}  // namespace handmap
