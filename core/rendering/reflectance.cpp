#include "core/rendering/reflectance.h"

#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr float kWheel_m = 0.32F;
constexpr float kRim_m = 0.2F;
constexpr float kSill_m = 0.17F;  // of a car above the road
const Colour kRubber(0.02F, 0.02F, 0.02F);
const Colour kGlass(0.035F, 0.04F, 0.045F);

Colour roofColour(const Surface& roof, const TexturePoint& at) {
  const float pixel = std::max(at.du, at.dv);
  const int row = floorOf(at.v / 0.33F);
  const float own = randomAt(floorOf(at.u / 0.25F), row, roof.seed + 1) - 0.5F;
  const float edge = stripes(at.v, 0.33F, 0.2F, at.dv);
  const float bright = 1.0F + 0.4F * own * visible(0.25F, pixel) - 0.4F * edge +
                       0.2F * grain(at.u, at.v, 0.8F, pixel, roof.seed + 2) +
                       0.15F * grain(at.u, at.v, 3.0F, pixel, roof.seed + 3);
  return roof.colour * std::max(bright, 0.1F);
}

Colour foliageColour(const Surface& leaf, const TexturePoint& at) {
  const float pixel = std::max(at.du, at.dv);
  return leaf.colour * (1.0F + 0.6F * grain(at.u, at.v, 0.05F, pixel, leaf.seed) +
                        0.35F * grain(at.u, at.v, 0.2F, pixel, leaf.seed + 1));
}

Colour barkColour(const Surface& bark, const TexturePoint& at) {
  return bark.colour *
         (1.0F + 0.5F * grain(at.u, 0.2F * at.v, 0.05F, std::max(at.du, at.dv), bark.seed));
}

float disc(float x, float y, float radius, float pixel) {
  return coverage(std::sqrt(x * x + y * y), -1.0F, radius, pixel);
}

Colour mixed(const Colour& a, const Colour& b, float share) { return a + share * (b - a); }

Colour carSideColour(const Surface& side, const TexturePoint& at) {
  const float pixel = std::max(at.du, at.dv);
  const float length = side.length;
  // Paint mirrors the road below and the sky above.
  Colour colour = side.colour * (0.75F + 0.45F * at.v / std::max(side.height, 0.1F)) +
                  0.04F * coverage(at.v, 0.62F * side.height, 0.8F * side.height, at.dv);
  const float door = coverage(at.u, 0.49F * length, 0.49F * length + 0.015F, at.du) *
                     coverage(at.v, 0.25F, 9.0F, at.dv);
  colour = mixed(colour, kRubber, 0.7F * door);
  colour = mixed(colour, kRubber, coverage(at.v, -1.0F, kSill_m, at.dv));
  for (const float share : {0.185F, 0.815F}) {
    const float x = at.u - share * length;
    const float y = at.v - kWheel_m;
    if (std::abs(x) > 0.6F) continue;
    colour = mixed(colour, kRubber, disc(x, y, kWheel_m + 0.07F, pixel));
    const float spokes = 0.75F + 0.25F * std::cos(5.0F * std::atan2(y, x)) * visible(0.2F, pixel);
    colour = mixed(colour, Colour(0.3F, 0.3F, 0.31F) * spokes, disc(x, y, kRim_m, pixel));
  }
  return colour;
}

/// `height` is negative for the rear.
Colour carEndColour(const Surface& end, const TexturePoint& at) {
  const bool front = end.height > 0.0F;
  const float height = std::abs(end.height);
  const float x = at.u - end.length / 2.0F;
  const float aside = std::abs(x);
  const float light_bottom = height - (front ? 0.22F : 0.33F);
  Colour colour = end.colour * 0.9F;
  colour = mixed(colour, kRubber, coverage(at.v, -1.0F, kSill_m, at.dv));
  colour = mixed(colour, end.colour * 0.5F, coverage(at.v, 0.4F, 0.43F, at.dv));
  if (front) {
    const float grille =
        coverage(x, -0.45F, 0.45F, at.du) * coverage(at.v, light_bottom, height - 0.08F, at.dv);
    colour = mixed(colour, kRubber * 1.5F, 0.85F * grille);
  }
  const float lamps = coverage(aside, end.length / 2.0F - 0.38F, end.length / 2.0F - 0.04F, at.du) *
                      coverage(at.v, light_bottom, height - 0.06F, at.dv);
  colour = mixed(colour, front ? Colour(0.6F, 0.6F, 0.58F) : Colour(0.35F, 0.02F, 0.02F), lamps);
  const float plate = coverage(x, -0.26F, 0.26F, at.du) * coverage(at.v, 0.45F, 0.56F, at.dv);
  return mixed(colour, Colour(0.65F, 0.65F, 0.6F), plate);
}

Colour carCabinColour(const Surface& cabin, const TexturePoint& at) {
  const float height = cabin.height;
  const float window = coverage(at.v, 0.04F, height - 0.07F, at.dv);
  const float pillar = coverage(at.u, 0.46F * cabin.length, 0.46F * cabin.length + 0.09F, at.du);
  const Colour pane = kGlass * (1.0F + 1.2F * at.v / std::max(height, 0.1F));
  return mixed(cabin.colour, mixed(pane, kRubber, pillar), window);
}

Colour clothColour(const Surface& cloth, const TexturePoint& at) {
  const float pixel = std::max(at.du, at.dv);
  return cloth.colour * (1.0F + 0.3F * grain(at.u, at.v, 0.04F, pixel, cloth.seed) +
                         0.35F * grain(at.u, at.v, 0.15F, pixel, cloth.seed + 1));
}

/// How far out a place of a plate is, 1 at its edge. The first corner lies along u: up.
float shareOfPlate(const Surface& plate, const TexturePoint& at) {
  const float distance = std::sqrt(at.u * at.u + at.v * at.v) / plate.length;
  if (plate.count > 4) return 1.1F * distance;  // stands for a round one
  const float side = 2.0F * 3.14159265F / static_cast<float>(plate.count);
  const float angle = std::atan2(at.v, at.u) / side;
  const float from_middle = side * (angle - static_cast<float>(floorOf(angle)) - 0.5F);
  return distance * std::cos(from_middle) / std::cos(side / 2.0F);
}

/// A triangle warns, a square has priority, a round one forbids (red rim) or commands (blue).
Colour signColour(const Surface& plate, const TexturePoint& at) {
  const Colour white(0.72F, 0.72F, 0.70F);
  const Colour red(0.50F, 0.03F, 0.04F);
  const Colour blue(0.03F, 0.10F, 0.38F);
  const float out = shareOfPlate(plate, at);
  const float pixel = std::max(at.du, at.dv) / plate.length;
  const float inside = coverage(out, -1.0F, plate.count == 4 ? 0.8F : 0.7F, pixel);
  if (plate.count == 4) return mixed(white, Colour(0.68F, 0.42F, 0.03F), inside);
  const bool commands = plate.count > 4 && plate.seed % 3U == 0U;
  const Colour face = mixed(commands ? white : red, commands ? blue : white, inside);
  const float symbol = coverage(at.v / plate.length, -0.09F, 0.09F, pixel) *
                       coverage(at.u / plate.length, -0.35F, 0.35F, pixel);
  return mixed(face, commands ? white : Colour(0.03F, 0.03F, 0.03F), symbol);
}

}  // namespace

Colour reflectanceAt(const Surface& surface, const Model& model, const TexturePoint& at) {
  switch (surface.material) {
    case Material::Facade:
      return facadeColour(surface, model.facades[surface.facade], at).max(0.005F);
    case Material::Roof:
      return roofColour(surface, at);
    case Material::Foliage:
      return foliageColour(surface, at);
    case Material::Bark:
      return barkColour(surface, at);
    case Material::CarSide:
      return carSideColour(surface, at);
    case Material::CarEnd:
      return carEndColour(surface, at);
    case Material::CarCabin:
      return carCabinColour(surface, at);
    case Material::Cloth:
      return clothColour(surface, at);
    case Material::Sign:
      return signColour(surface, at);
    case Material::Plain:
      break;
  }
  return surface.colour;
}

}  // namespace handmap
