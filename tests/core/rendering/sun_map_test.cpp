#include "core/rendering/sun_map.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

/// From behind the origin and 45° up: shadows fall towards +x, as long as things are high.
const Vec3 kToSun = Vec3(-1.0, 0.0, 1.0).normalized();

Surface upright(const Vec2& a, const Vec2& b, double low, double high) {
  return surfaceOf(
      {{a.x(), a.y(), low}, {b.x(), b.y(), low}, {b.x(), b.y(), high}, {a.x(), a.y(), high}},
      Material::Plain, Label::Building, Colour::Zero(), 1);
}

TEST(SunMap, AWallShadesTheGroundBehindItAndNothingElse) {
  SunMap sun(Vec2::Zero(), kToSun);
  sun.add({upright({2.0, -5.0}, {2.0, 5.0}, 0.0, 3.0)});
  RandomStream random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 place(random.uniform(-4.0, 10.0), random.uniform(-8.0, 8.0), 0.0);
    const double inside = std::min({place.x() - 2.0, 5.0 - place.x(), 5.0 - std::abs(place.y())});
    if (std::abs(inside) < 0.2) continue;
    EXPECT_EQ(sun.sunAt(place, Vec3::UnitZ()), inside > 0.0 ? 0.0F : 1.0F) << place.transpose();
  }
}

TEST(SunMap, ShadowsEndOnWallsWhereTheSunComesOver) {
  SunMap sun(Vec2::Zero(), kToSun);
  sun.add({upright({2.0, -5.0}, {2.0, 5.0}, 0.0, 3.0), upright({4.0, 5.0}, {4.0, -5.0}, 0.0, 9.0)});
  for (double y = -4.5; y < 4.5; y += 0.3) {
    EXPECT_EQ(sun.sunAt({4.0, y, 0.5}, -Vec3::UnitX()), 0.0F);
    for (double z = 1.35; z < 9.0; z += 0.4) {  // 3 m less the 2 m between the walls, and above
      EXPECT_EQ(sun.sunAt({4.0, y, z}, -Vec3::UnitX()), 1.0F) << y << " " << z;
    }
    EXPECT_EQ(sun.sunAt({2.0, y, 1.5}, -Vec3::UnitX()), 1.0F);  // not by itself
  }
}

TEST(SunMap, TheSunShinesUnderWhatHangs) {
  SunMap sun(Vec2::Zero(), kToSun);
  sun.add({upright({2.0, -5.0}, {2.0, 5.0}, 2.0, 3.0)});
  EXPECT_EQ(sun.sunAt({3.0, 0.0, 0.0}, Vec3::UnitZ()), 1.0F);
  EXPECT_EQ(sun.sunAt({4.5, 0.0, 0.0}, Vec3::UnitZ()), 0.0F);
  EXPECT_EQ(sun.sunAt({200.0, 0.0, 0.0}, Vec3::UnitZ()), 1.0F);  // beyond
}

TEST(SunMap, HalfTheSunAtTheEdgeOfAShadow) {
  SunMap sun(Vec2::Zero(), kToSun);
  sun.add({upright({2.0, -5.0}, {2.0, 5.0}, 0.0, 3.0)});
  double sum = 0.0;
  for (int i = 0; i < 100; ++i) {
    sum += static_cast<double>(sun.sunAt({4.5 + 0.01 * i, 0.01 * i, 0.0}, Vec3::UnitZ()));
  }
  EXPECT_NEAR(sum / 100.0, 0.5, 0.08);
}

}  // namespace
}  // namespace handmap
