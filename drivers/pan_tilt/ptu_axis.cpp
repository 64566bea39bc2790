#include "drivers/pan_tilt/ptu_axis.h"

#include "core/base/phrase.h"

namespace handmap {

std::optional<std::string> PtuAxis::fault() const {
  // From the finest gear to a twentieth of a turn; the heads of this family have 11 to 186.
  if (resolution_arcsec < 1.0 || resolution_arcsec > 64800.0) {
    return phrase("found {} arc-seconds a position, expected 1 to 64800", resolution_arcsec);
  }
  const double turn = 2.0 * kPi / radiansPerPosition();
  if (!(least < most) || least < -turn || most > turn) {
    return phrase("found limits {} to {} positions, expected a range within a turn", least, most);
  }
  if (!(slowest <= fastest) || slowest < 0.0 || fastest < 1.0 || fastest > 1e6) {
    return phrase("found speeds {} to {} positions/s, expected a range above 0", slowest, fastest);
  }
  return std::nullopt;
}

}  // namespace handmap
