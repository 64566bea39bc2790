#include <algorithm>

#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr std::uint32_t kFacades = 20;
constexpr double kEaves_m = 0.45;  // overhang of a roof
constexpr double kVerge_m = 0.3;   // and at a gable
constexpr double kCorner_m = 0.6;  // no window nearer to a corner
constexpr double kFascia_m = 0.18;

Vec3 lifted(const Vec2& point, double z) { return {point.x(), point.y(), z}; }

class BuildingModel {
 public:
  BuildingModel(const World& world, std::size_t building, Model& model)
      : model_(model),
        random_(world.seed, static_cast<std::uint32_t>(building), 1, kFacades),
        seed_(hashOf(static_cast<std::uint32_t>(world.seed), static_cast<std::uint32_t>(building),
                     kFacades)),
        look_(appearanceOf(world, building)) {
    box_ = world.map.buildings[building].box();
    if (box_.depth > box_.width) {
      std::swap(box_.width, box_.depth);
      box_.heading += kPi / 2.0;
    }
    frame_ = {box_.centre.x(), box_.centre.y(), box_.heading};
    rise_ = std::tan(look_.roof_pitch_rad) * box_.depth / 2.0;
    corners_ = look_.roof == Appearance::Roof::Flat || !world.walls.empty()
                   ? world.wallsOf(building)
                   : box_.corners();
  }

  void add() {
    for (std::size_t i = 0; i < corners_.size(); ++i) addWall(i);
    if (look_.roof == Appearance::Roof::Flat) return;
    addRoof();
    if (random_.uniform() < 0.6) addChimney();
  }

 private:
  void addWall(std::size_t i) {
    const Vec2& a = corners_[i];
    const Vec2& b = corners_[(i + 1) % corners_.size()];
    const double length = (b - a).norm();
    const double top = look_.eaves_m();
    std::vector<Vec3> outline{lifted(a, 0.0), lifted(b, 0.0), lifted(b, top)};
    const bool gable = look_.roof == Appearance::Roof::Gable && isEnd(a, b);
    if (gable) {
      outline.push_back(lifted((a + b) / 2.0, top + rise_));
    }
    outline.push_back(lifted(a, top));
    Surface wall = surfaceOf(outline, Material::Facade, Label::Building, colourOf(look_.wall),
                             seed_ + static_cast<std::uint32_t>(i) * 977U);
    wall.facade = static_cast<std::uint32_t>(model_.facades.size());
    model_.surfaces.push_back(wall);
    model_.facades.push_back(facadeOf(length));
    model_.facades.back().gable = gable;
  }

  /// Whether the wall is the whole of a short side.
  bool isEnd(const Vec2& a, const Vec2& b) const {
    const Vec2 middle = frame_.toOwn((a + b) / 2.0);
    return std::abs(std::abs(middle.x()) - box_.width / 2.0) < 1e-6 &&
           std::abs((b - a).norm() - box_.depth) < 1e-6;
  }

  Facade facadeOf(double length) {
    Facade facade;
    facade.look = look_;
    facade.eaves_m = static_cast<float>(look_.eaves_m());
    facade.bays = std::max(0, static_cast<int>((length - 2.0 * kCorner_m) / look_.bay_m));
    const bool gable_end = length < 12.0 && length < box_.width - 1e-6;
    if (gable_end && random_.uniform() < 0.3) facade.bays = std::min(facade.bays, 1);
    facade.margin_m = static_cast<float>((length - facade.bays * look_.bay_m) / 2.0);
    if (facade.bays > 0 && random_.uniform() < 0.8) facade.door_bay = random_.index(facade.bays);
    return facade;
  }

  Vec3 at(double x, double y, double z) const { return lifted(frame_.toOuter({x, y}), z); }

  void addPlain(const std::vector<Vec3>& corners, const Reflectance& colour) {
    model_.surfaces.push_back(
        surfaceOf(corners, Material::Plain, Label::Building, colourOf(colour), seed_));
  }

  /// Both halves look alike: `turn` is 1 for the one, -1 for the other.
  void addRoof() {
    const double slope = std::tan(look_.roof_pitch_rad);
    const bool hip = look_.roof == Appearance::Roof::Hip;
    const double x = box_.width / 2.0 + (hip ? kEaves_m : kVerge_m);
    const double y = box_.depth / 2.0 + kEaves_m;
    const double low = look_.eaves_m() - kEaves_m * slope;
    const double high = look_.eaves_m() + rise_;
    const double ridge = hip ? std::max(0.0, x - y) : x;
    const auto tiles = [&](const std::vector<Vec3>& corners) {
      model_.surfaces.push_back(
          surfaceOf(corners, Material::Roof, Label::Building, colourOf(look_.roof_tile), seed_));
    };
    for (const double turn : {1.0, -1.0}) {
      const auto p = [&](double px, double py, double z) { return at(turn * px, turn * py, z); };
      tiles({p(-x, -y, low), p(x, -y, low), p(ridge, 0, high), p(-ridge, 0, high)});
      addPlain(
          {p(-x, -y, low - kFascia_m), p(x, -y, low - kFascia_m), p(x, -y, low), p(-x, -y, low)},
          look_.trim);
      if (hip) {
        tiles({p(x, -y, low), p(x, y, low), p(ridge, 0, high)});
        addPlain({p(x, -y, low - kFascia_m), p(x, y, low - kFascia_m), p(x, y, low), p(x, -y, low)},
                 look_.trim);
        continue;
      }
      for (const double side : {1.0, -1.0}) {  // barge boards along the verge
        std::vector<Vec3> board{p(x, -side * y, low - kFascia_m), p(x, 0, high - kFascia_m),
                                p(x, 0, high), p(x, -side * y, low)};
        addPlain(board, look_.trim);
      }
    }
  }

  void addChimney() {
    const double x = random_.uniform(-0.3, 0.3) * box_.width;
    const double y = random_.uniform(-0.15, 0.15) * box_.depth;
    const Pose2 place = frame_ * Pose2{x, y, 0.0};
    const Polygon corners = Rectangle{place.position(), 0.7, 0.5, place.heading}.corners();
    const double top = look_.eaves_m() + rise_ + random_.uniform(0.4, 0.9);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2& a = corners[i];
      const Vec2& b = corners[(i + 1) % 4];
      const double low = look_.eaves_m();
      addPlain({lifted(a, low), lifted(b, low), lifted(b, top), lifted(a, top)},
               {0.22F, 0.13F, 0.1F});
    }
  }

  Model& model_;
  RandomStream random_;
  std::uint32_t seed_;
  Appearance look_;
  Rectangle box_;  ///< longer along its heading
  Pose2 frame_;
  double rise_ = 0.0;  ///< of the ridge above the eaves
  Polygon corners_;
};

}  // namespace

void addBuilding(const World& world, std::size_t building, Model& model) {
  BuildingModel(world, building, model).add();
}

}  // namespace handmap
