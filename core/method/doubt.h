// How probably a corrected building is wrong: another one, or none, is where it is shown.
#pragma once

#include "core/map/map.h"

namespace handmap {

/// Turns what labels and rays say of the buildings (doubtOf() as the method gives it) and what
/// nobody should take over unseen (concernsOf()) into how often buildings of which the same was
/// said were wrong. Of those that a run may move.
void stateDoubt(const Map& drawing, Map& refined);

}  // namespace handmap
