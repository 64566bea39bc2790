#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"
#include "core/rendering/tube.h"

namespace handmap {

namespace {

constexpr std::uint32_t kSign = 26;
constexpr std::uint32_t kLamp = 27;
constexpr double kArmLamp_m = 4.5;  // lower ones carry a globe, higher ones an arm

Pose2 frameOf(const Thing& thing) {
  return {thing.footprint.centre.x(), thing.footprint.centre.y(), thing.footprint.heading};
}

Surface metal(const Colour& colour, std::uint32_t seed) {
  Surface look;
  look.material = Material::Plain;
  look.label = Label::Pole;
  look.colour = colour;
  look.seed = seed;
  return look;
}

/// Of a plate that stands upright: the corners around its middle, the first one at the top.
std::vector<Vec3> plateCorners(const Vec3& middle, const Vec3& left, double radius, int count) {
  std::vector<Vec3> corners;
  for (int i = 0; i < count; ++i) {
    const Vec2 round = radius * unitVector(2.0 * kPi * i / count);
    corners.emplace_back(middle + round.x() * Vec3::UnitZ() + round.y() * left);
  }
  return corners;
}

}  // namespace

void addSign(const Thing& sign, std::uint64_t seed, std::uint32_t number, Model& model) {
  RandomStream random(seed, number, 0, kSign);
  const std::uint32_t own = hashOf(static_cast<std::uint32_t>(seed), number, kSign);
  const Pose2 frame = frameOf(sign);
  const double radius = random.uniform(0.33, 0.45);
  const Surface post = metal({0.34F, 0.35F, 0.36F}, own);
  const double top = sign.height - 0.3 * radius;
  addTube(frame, {{0, 0, 0, 0.035, 0.035}, {0, 0, top, 0.035, 0.035}}, 6, post, model);

  constexpr int kShapes[] = {3, 4, 6, 6, 6};
  const int corners = kShapes[random.index(5)];
  const Vec2 ahead = unitVector(frame.heading);
  const Vec3 out(ahead.x(), ahead.y(), 0.0);
  const Vec3 left(-ahead.y(), ahead.x(), 0.0);
  const Vec3 post_top(frame.x, frame.y, sign.height - radius);
  const Vec3 middle = post_top + 0.05 * out;
  Surface front = surfaceOf(plateCorners(middle, left, radius, corners), Material::Sign,
                            Label::Sign, Colour::Zero(), own);
  front.origin = middle;
  front.along = Vec3::UnitZ();
  front.up = left;
  front.length = static_cast<float>(radius);
  model.surfaces.push_back(front);
  model.surfaces.push_back(surfaceOf(plateCorners(post_top + 0.04 * out, -left, radius, corners),
                                     Material::Plain, Label::Sign, post.colour, own));
}

void addLamp(const Thing& lamp, std::uint64_t seed, Model& model) {
  RandomStream random(seed, 0, 0, kLamp);  // all of a world look alike
  const Colour colour =
      random.uniform() < 0.5 ? Colour(0.36F, 0.37F, 0.37F) : Colour(0.035F, 0.05F, 0.045F);
  const Surface iron = metal(colour, hashOf(static_cast<std::uint32_t>(seed), 0, kLamp));
  const Pose2 frame = frameOf(lamp);
  const double top = lamp.height;
  Surface glass = iron;
  glass.colour = {0.7F, 0.7F, 0.66F};
  if (top < kArmLamp_m) {
    addTube(frame, {{0, 0, 0, 0.08, 0.08}, {0, 0, 0.6, 0.05, 0.05}, {0, 0, top - 0.4, 0.04, 0.04}},
            8, iron, model);
    addTube(frame,
            {{0, 0, top - 0.42, 0.1, 0.1},
             {0, 0, top - 0.3, 0.2, 0.2},
             {0, 0, top - 0.15, 0.2, 0.2},
             {0, 0, top, 0.08, 0.08}},
            8, glass, model);
    return;
  }
  addTube(frame, {{0, 0, 0, 0.09, 0.09}, {0, 0, 1.2, 0.07, 0.07}, {0, 0, top - 0.1, 0.045, 0.045}},
          8, iron, model);
  addTube(frame, {{0.6, 0, top - 0.14, 0.65, 0.03}, {0.6, 0, top - 0.06, 0.65, 0.03}}, 4, iron,
          model);
  addTube(frame, {{1.3, 0, top - 0.2, 0.3, 0.1}, {1.3, 0, top - 0.12, 0.36, 0.13}}, 6, glass,
          model);
  addTube(frame, {{1.3, 0, top - 0.12, 0.36, 0.13}, {1.3, 0, top, 0.2, 0.07}}, 6, iron, model);
}

}  // namespace handmap
