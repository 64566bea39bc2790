#include "core/map/georeference_fit.h"

#include <gtest/gtest.h>

#include "core/map/tangent_plane.h"

namespace handmap {
namespace {

TEST(GeoreferenceFit, TwoPinsGivePlaceAndTurn) {
  const Georeference truth{52.51, 13.38, toRadians(25.0), {}};
  const TangentPlane plane(truth);
  const auto pin = [&plane](const Vec2& at) { return GeoPin{at, plane.longitudeLatitude(at)}; };
  const GeoreferenceFit fit = georeferenceOf(pin({120.0, -40.0}), pin({-200.0, 310.0}));
  EXPECT_NEAR(fit.georeference.latitude, truth.latitude, 1e-7);
  EXPECT_NEAR(fit.georeference.longitude, truth.longitude, 1e-7);
  EXPECT_NEAR(fit.georeference.heading, truth.heading, 1e-4);
  EXPECT_NEAR(fit.scale, 1.0, 1e-4);
}

}  // namespace
}  // namespace handmap
