#include <algorithm>

#include "core/base/random.h"
#include "core/rendering/model_parts.h"
#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr std::uint32_t kPlantSize = 21;
constexpr std::uint32_t kPlant = 22;
constexpr std::uint32_t kHedge = 23;
constexpr int kBlobs = 5;  // a crown is a heap of balls

struct Ball {
  Vec3 centre;
  Vec3 radii;
};

Vec3 randomDirection(RandomStream& random) {
  const double z = random.uniform(-1.0, 1.0);
  const Vec2 flat = std::sqrt(1.0 - z * z) * unitVector(random.uniform(0.0, 2.0 * kPi));
  return {flat.x(), flat.y(), z};
}

Colour greenOf(RandomStream& random) {
  const auto shift = [&](double mean, double spread) {
    return static_cast<float>(mean * random.uniform(1.0 - spread, 1.0 + spread));
  };
  return {shift(0.075, 0.45), shift(0.115, 0.25), shift(0.035, 0.4)};
}

class Foliage {
 public:
  Foliage(std::uint64_t seed, std::uint32_t number, std::uint32_t purpose, Model& model)
      : random_(seed, number, 0, purpose),
        model_(model),
        seed_(hashOf(static_cast<std::uint32_t>(seed), number, purpose)),
        green_(greenOf(random_)) {}

  RandomStream& random() { return random_; }

  /// Dark, behind the leaves: one does not see through.
  void core(const Ball& ball) {
    constexpr int kAround = 8;
    constexpr int kUp = 5;
    const auto at = [&](int i, int j) -> Vec3 {
      const double low = kPi * (static_cast<double>(j) / kUp - 0.5);
      const Vec2 flat = std::cos(low) * unitVector(2.0 * kPi * i / kAround);
      const Vec3 direction(flat.x(), flat.y(), std::sin(low));
      return ball.centre + 0.82 * ball.radii.cwiseProduct(direction);
    };
    for (int j = 0; j < kUp; ++j) {
      for (int i = 0; i < kAround; ++i) {
        std::vector<Vec3> corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        if (j == 0) corners.erase(corners.begin() + 1);  // the pole is one point
        if (j == kUp - 1) corners.pop_back();
        put(corners, 0.6F);
      }
    }
  }

  /// `low` … `high`: between the darkest and the lightest leaves.
  void leaf(const Vec3& centre, const Vec3& outwards, double size, double low, double high) {
    const Vec3 normal = (outwards + 0.9 * randomDirection(random_)).normalized();
    const Vec3 a = normal.unitOrthogonal();
    const Vec3 b = normal.cross(a);
    const double turn = random_.uniform(0.0, kPi);
    const double s = size * random_.uniform(0.6, 1.3);
    const Vec3 u = s * (std::cos(turn) * a + std::sin(turn) * b);
    const Vec3 v = s * random_.uniform(0.5, 1.0) * (std::cos(turn) * b - std::sin(turn) * a);
    const double share = std::clamp((centre.z() - low) / (high - low), 0.0, 1.0);
    const double bright = (0.65 + 0.5 * share) * random_.uniform(0.65, 1.3);
    put({centre - u - 0.3 * v, centre + 0.2 * u - v, centre + u + 0.3 * v, centre - 0.2 * u + v},
        static_cast<float>(bright));
  }

  void ball(const Ball& ball, int leaves, double size, double low, double high) {
    core(ball);
    for (int i = 0; i < leaves; ++i) {
      const Vec3 direction = randomDirection(random_);
      const double depth = random_.uniform(0.8, 1.05);
      leaf(ball.centre + depth * ball.radii.cwiseProduct(direction), direction, size, low, high);
    }
  }

  void put(const std::vector<Vec3>& corners, float bright) {
    Surface surface =
        surfaceOf(corners, Material::Foliage, Label::Tree, bright * green_, seed_ + ++count_);
    if (!surface.normal.allFinite()) return;
    model_.surfaces.push_back(surface);
  }

 private:
  RandomStream random_;
  Model& model_;
  std::uint32_t seed_;
  std::uint32_t count_ = 0;
  Colour green_;
};

void addTrunk(const Vec2& place, double radius, double height, std::uint32_t seed, Model& model) {
  constexpr int kSides = 7;
  const auto at = [&](int i, double r, double z) -> Vec3 {
    const Vec2 flat = place + r * unitVector(2.0 * kPi * i / kSides);
    return {flat.x(), flat.y(), z};
  };
  for (int i = 0; i < kSides; ++i) {
    model.surfaces.push_back(
        surfaceOf({at(i, radius, 0.0), at(i + 1, radius, 0.0), at(i + 1, 0.6 * radius, height),
                   at(i, 0.6 * radius, height)},
                  Material::Bark, Label::Tree, {0.11F, 0.085F, 0.06F}, seed));
  }
}

/// How high a plant reaches and how wide it is there.
struct PlantSize {
  bool bush;
  double trunk_m;   ///< radius
  double crown_m;   ///< radius
  double bottom_m;  ///< of the crown
  double top_m;
};

PlantSize sizeOf(const Obstacle& plant, double clear_m, std::uint64_t seed, std::uint32_t number) {
  RandomStream random(seed, number, 0, kPlantSize);
  PlantSize size{};
  size.bush = plant.radius >= Obstacle::kBush_m;
  if (size.bush) {
    size.crown_m = plant.radius;
    size.top_m = plant.radius * random.uniform(1.5, 3.5);
    size.bottom_m = -0.4 * size.top_m;  // widest near the ground, which hides the rest
    return size;
  }
  size.trunk_m = 0.45 * plant.radius;
  size.crown_m = std::max(0.6, std::min(clear_m, random.uniform(1.7, 3.2)));
  size.bottom_m = random.uniform(1.8, 2.5);
  size.top_m = size.bottom_m + std::max(2.5, size.crown_m * random.uniform(1.5, 2.1));
  return size;
}

}  // namespace

void addPlant(const Obstacle& plant, double clear_m, int leaves, std::uint64_t seed,
              std::uint32_t number, Model& model) {
  const PlantSize size = sizeOf(plant, clear_m, seed, number);
  Foliage foliage(seed, number, kPlant, model);
  RandomStream& random = foliage.random();
  const double piece = 0.17 * std::sqrt(900.0 / leaves) * std::sqrt(size.crown_m / 2.0);
  const double half = (size.top_m - size.bottom_m) / 2.0;
  const Vec3 middle(plant.centre.x(), plant.centre.y(), size.bottom_m + half);
  if (size.bush) {
    foliage.ball({middle, {size.crown_m, size.crown_m, half}}, leaves / 2, piece, 0.0, size.top_m);
    return;
  }
  addTrunk(plant.centre, size.trunk_m, size.bottom_m + 1.2 * half,
           hashOf(static_cast<std::uint32_t>(seed), number, 7), model);
  for (int i = 0; i < kBlobs; ++i) {
    const double turn = 2.0 * kPi * (i + random.uniform()) / kBlobs;
    const double up = half * (i == 0 ? 0.4 : random.uniform(-0.4, 0.3));
    const double r = random.uniform(0.5, 0.65);
    const Vec2 aside = (i == 0 ? 0.0 : (1.0 - r) * size.crown_m) * unitVector(turn);
    foliage.ball(
        {middle + Vec3(aside.x(), aside.y(), up), {r * size.crown_m, r * size.crown_m, r * half}},
        leaves / kBlobs, piece, size.bottom_m, size.top_m);
  }
}

void addHedge(const Thing& hedge, std::uint64_t seed, std::uint32_t number, Model& model) {
  Foliage foliage(seed, number, kHedge, model);
  Rectangle inner = hedge.footprint;
  inner.width -= 0.2;
  inner.depth -= 0.2;
  const Polygon corners = inner.corners();
  const double top = hedge.height - 0.08;
  const auto lifted = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % 4];
    const double length = (b - a).norm();
    foliage.put({lifted(a, 0.0), lifted(b, 0.0), lifted(b, top), lifted(a, top)}, 0.7F);
    const Vec2 out = -perpendicular(b - a) / length;
    const int leaves = std::min(1200, static_cast<int>(length * hedge.height * 40.0));
    for (int k = 0; k < leaves; ++k) {
      const double along = foliage.random().uniform();
      const double outwards = foliage.random().uniform(-0.03, 0.12);
      const Vec2 place = a + along * (b - a) + outwards * out;
      const double z = foliage.random().uniform(0.0, hedge.height);
      foliage.leaf(lifted(place, z), lifted(out, 0.3), 0.09, 0.0, hedge.height);
    }
  }
  foliage.put({lifted(corners[0], top), lifted(corners[1], top), lifted(corners[2], top),
               lifted(corners[3], top)},
              0.9F);
}

}  // namespace handmap
