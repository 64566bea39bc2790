#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr std::uint32_t kCar = 24;

constexpr Reflectance kPaint[] = {
    {0.62F, 0.62F, 0.61F}, {0.36F, 0.37F, 0.38F}, {0.15F, 0.155F, 0.16F}, {0.03F, 0.03F, 0.035F},
    {0.32F, 0.03F, 0.03F}, {0.04F, 0.08F, 0.22F}, {0.05F, 0.13F, 0.09F},  {0.25F, 0.22F, 0.16F}};

/// The profile, as shares of the length: forward is positive.
struct Profile {
  double hood_begin;  // foot of the windscreen
  double roof_begin;
  double roof_end;
  double rear_end;  // foot of the rear window
  double belt;      // share of the height
  double nose;
};

class CarModel {
 public:
  CarModel(const Thing& car, std::uint64_t seed, std::uint32_t number, Model& model)
      : model_(model),
        frame_{car.footprint.centre.x(), car.footprint.centre.y(), car.footprint.heading},
        half_(car.footprint.width / 2.0),
        side_(car.footprint.depth / 2.0),
        height_(car.height),
        seed_(hashOf(static_cast<std::uint32_t>(seed), number, kCar)) {
    RandomStream random(seed, number, 0, kCar);
    paint_ = colourOf(kPaint[random.index(8)]);
    const bool van = car.height > 1.7;
    profile_ = van ? Profile{0.34, 0.20, -0.46, -0.49, 0.52, 0.45}
                   : Profile{0.22, 0.05, random.uniform(-0.40, -0.22), random.uniform(-0.47, -0.38),
                             0.59, 0.44};
  }

  void add() {
    addSide(1.0);
    addSide(-1.0);
    const double length = 2.0 * half_;
    const double belt = profile_.belt * height_;
    const double nose = profile_.nose * height_;
    const double tail = 0.96 * belt;
    const double inset = side_ - 0.14;
    const Profile& p = profile_;
    addEnd(half_, nose, 1.0);
    addEnd(-half_, tail, -1.0);
    addAcross(half_, side_, nose, p.hood_begin * length, side_, belt, paint_ * 1.1F);
    addAcross(p.hood_begin * length, side_ - 0.03, belt, p.roof_begin * length, inset, height_,
              kGlass);
    addAcross(p.roof_begin * length, inset, height_, p.roof_end * length, inset, height_,
              paint_ * 1.15F);
    addAcross(p.roof_end * length, inset, height_, p.rear_end * length, side_ - 0.03, belt, kGlass);
    addAcross(p.rear_end * length, side_, belt, -half_, side_, tail, paint_ * 1.1F);
  }

 private:
  inline static const Colour kGlass{0.03F, 0.035F, 0.04F};

  Vec3 at(double x, double y, double z) const {
    const Vec2 flat = frame_.toOuter({x, y});
    return {flat.x(), flat.y(), z};
  }

  void put(const std::vector<Vec3>& corners, Material material, const Colour& colour,
           double height) {
    Surface surface = surfaceOf(corners, material, Label::Car, colour, seed_);
    surface.height = static_cast<float>(height);
    model_.surfaces.push_back(surface);
  }

  /// From one line across the car back to another: bonnet, screens, roof.
  void addAcross(double x0, double y0, double z0, double x1, double y1, double z1,
                 const Colour& colour) {
    put({at(x0, -y0, z0), at(x0, y0, z0), at(x1, y1, z1), at(x1, -y1, z1)}, Material::Plain, colour,
        0.0);
  }

  void addEnd(double x, double top, double turn) {
    put({at(x, -turn * side_, 0.0), at(x, turn * side_, 0.0), at(x, turn * side_, top),
         at(x, -turn * side_, top)},
        Material::CarEnd, paint_, turn * top);
  }

  /// `turn` 1: the right side. The left one is the same seen in a mirror: corners turn round.
  void addSide(double turn) {
    const double length = 2.0 * half_;
    const double belt = profile_.belt * height_;
    const double y = -turn * side_;
    const double top = -turn * (side_ - 0.14);
    const Profile& p = profile_;
    std::vector<Vec3> body{at(-half_, y, 0.0),
                           at(half_, y, 0.0),
                           at(half_, y, p.nose * height_),
                           at(p.hood_begin * length, y, belt),
                           at(p.rear_end * length, y, belt),
                           at(-half_, y, 0.96 * belt)};
    std::vector<Vec3> cabin{at(p.rear_end * length, y, belt), at(p.hood_begin * length, y, belt),
                            at(p.roof_begin * length, top, height_),
                            at(p.roof_end * length, top, height_)};
    if (turn < 0.0) {
      body = {body[1], body[0], body[5], body[4], body[3], body[2]};
      cabin = {cabin[1], cabin[0], cabin[3], cabin[2]};
    }
    put(body, Material::CarSide, paint_, belt);
    put(cabin, Material::CarCabin, paint_, height_ - belt);
  }

  Model& model_;
  Pose2 frame_;
  double half_;
  double side_;
  double height_;
  std::uint32_t seed_;
  Colour paint_;
  Profile profile_{};
};

}  // namespace

void addCar(const Thing& car, std::uint64_t seed, std::uint32_t number, Model& model) {
  CarModel(car, seed, number, model).add();
}

}  // namespace handmap
