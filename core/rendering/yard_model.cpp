#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"
#include "core/rendering/tube.h"

namespace handmap {

namespace {

constexpr std::uint32_t kFence = 28;
constexpr std::uint32_t kRack = 29;

/// Flat parts that stand upright in planes along or across a thing.
class Upright {
 public:
  /// The plane runs through (x, y) of the frame, turned by `turn` from its heading.
  Upright(const Pose2& frame, double x, double y, double turn, const Surface& look, Model& model)
      : plane_(frame * Pose2{x, y, turn}), look_(look), model_(model) {}

  void put(const std::vector<Vec2>& corners) const {
    std::vector<Vec3> lifted;
    for (const Vec2& corner : corners) lifted.push_back(at(corner));
    model_.surfaces.push_back(
        surfaceOf(lifted, look_.material, look_.label, look_.colour, look_.seed));
  }

  void bar(const Vec2& a, const Vec2& b, double width) const {
    const Vec2 aside = width / 2.0 * perpendicular((b - a).normalized());
    put({a - aside, b - aside, b + aside, a + aside});
  }

  void ring(const Vec2& centre, double radius, double width) const {
    constexpr int kPieces = 14;
    for (int i = 0; i < kPieces; ++i) {
      const Vec2 from = unitVector(2.0 * kPi * i / kPieces);
      const Vec2 to = unitVector(2.0 * kPi * (i + 1) / kPieces);
      put({centre + (radius - width) * from, centre + radius * from, centre + radius * to,
           centre + (radius - width) * to});
    }
  }

 private:
  /// Along the plane and up.
  Vec3 at(const Vec2& point) const {
    const Vec2 flat = plane_.toOuter({point.x(), 0.0});
    return {flat.x(), flat.y(), point.y()};
  }

  Pose2 plane_;
  const Surface& look_;
  Model& model_;
};

Pose2 poseOf(const Thing& thing) {
  return {thing.footprint.centre.x(), thing.footprint.centre.y(), thing.footprint.heading};
}

Surface painted(Label label, const Colour& colour, std::uint32_t seed) {
  Surface look;
  look.material = Material::Plain;
  look.label = label;
  look.colour = colour;
  look.seed = seed;
  return look;
}

void addBicycle(const Upright& plane) {
  constexpr double kWheel_m = 0.34;
  const Vec2 rear(-0.52, kWheel_m);
  const Vec2 front(0.52, kWheel_m);
  const Vec2 pedals(-0.08, 0.3);
  const Vec2 saddle(-0.22, 0.95);
  const Vec2 head(0.38, 0.9);
  plane.ring(rear, kWheel_m, 0.045);
  plane.ring(front, kWheel_m, 0.045);
  plane.bar(rear, pedals, 0.03);
  plane.bar(pedals, saddle, 0.035);
  plane.bar(pedals, head, 0.04);
  plane.bar(Vec2(-0.19, 0.82), head, 0.035);
  plane.bar(rear, Vec2(-0.19, 0.82), 0.025);
  plane.bar(front, Vec2(0.35, 1.05), 0.035);
  plane.bar(saddle - Vec2(0.14, 0.0), saddle + Vec2(0.12, 0.0), 0.06);
}

}  // namespace

void addFence(const Thing& fence, std::uint64_t seed, std::uint32_t number, Model& model) {
  constexpr double kPitch_m = 0.14;
  RandomStream random(seed, 0, 0, kFence);  // all of a world are painted alike
  const Colour colour =
      random.uniform() < 0.6 ? Colour(0.24F, 0.17F, 0.1F) : Colour(0.55F, 0.55F, 0.52F);
  const Surface wood =
      painted(Label::Fence, colour, hashOf(static_cast<std::uint32_t>(seed), number, kFence));
  const Pose2 frame = poseOf(fence);
  const double end = fence.footprint.width / 2.0;
  const double share =
      fence.free_path_m > 0.0 ? 1.0 - std::exp(-fence.footprint.depth / fence.free_path_m) : 1.0;
  for (const double x : {-end, end}) {
    addTube(frame, {{x, 0, 0, 0.05, 0.05}, {x, 0, fence.height, 0.05, 0.05}}, 4, wood, model);
  }
  const Upright rails(frame, 0.0, -0.02, 0.0, wood, model);
  for (const double z : {0.25, fence.height - 0.2}) rails.bar({-end, z}, {end, z}, 0.08);
  const Upright pickets(frame, 0.0, 0.02, 0.0, wood, model);
  for (double x = -end + kPitch_m / 2.0; x < end; x += kPitch_m) {
    pickets.bar({x, 0.06}, {x, fence.height - 0.03}, share * kPitch_m);
  }
}

void addRack(const Thing& rack, std::uint64_t seed, std::uint32_t number, Model& model) {
  constexpr double kPitch_m = 0.65;
  constexpr double kTaken = 0.75;
  const std::uint32_t own = hashOf(static_cast<std::uint32_t>(seed), number, kRack);
  RandomStream random(seed, number, 0, kRack);
  const Pose2 frame = poseOf(rack);
  const Surface steel = painted(Label::Pole, {0.3F, 0.31F, 0.32F}, own);
  const double end = rack.footprint.width / 2.0;
  for (double x = -end + kPitch_m / 2.0; x < end; x += kPitch_m) {
    const Upright hoop(frame, x, 0.0, kPi / 2.0, steel, model);
    hoop.bar({0.25, 0.0}, {0.25, 0.75}, 0.04);
    hoop.bar({0.75, 0.0}, {0.75, 0.75}, 0.04);
    hoop.bar({0.25, 0.75}, {0.75, 0.75}, 0.04);
    const auto shade = [&] { return static_cast<float>(random.uniform(0.03, 0.4)); };
    const Surface paint = painted(Label::Bicyclist, {shade(), shade(), shade()}, own);
    const double aside = 0.1 + random.uniform(-0.05, 0.05);
    const bool turned = random.uniform() < 0.5;
    const double lean = random.normal(0.0, 0.08);
    if (random.uniform() > kTaken) continue;
    addBicycle({frame, x + aside, 0.0, (turned ? -kPi / 2.0 : kPi / 2.0) + lean, paint, model});
  }
}

}  // namespace handmap
