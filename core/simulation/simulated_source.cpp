#include "core/simulation/simulated_source.h"

#include "core/base/random.h"
#include "core/base/stopwatch.h"
#include "core/simulation/drive.h"
#include "core/simulation/surroundings.h"

namespace handmap {

namespace {

constexpr std::uint32_t kRays = 6;
constexpr double kLeastRange = 0.3;

class SimulatedSource : public ObservationSource {
 public:
  SimulatedSource(const World& world, const SimulationOptions& options, std::uint64_t seed)
      : options_(options), seed_(seed), surroundings_(world), info_(infoOf(world, options, seed)) {}

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    if (next_ == info_.truth.size()) return std::nullopt;
    const Stopwatch watch;
    Observation observation = observationAt(next_, info_);
    observation.standing = options_.standing;
    View& view = observation.views.emplace_back();
    view.points = scan(info_.truth[next_].pose, static_cast<std::uint32_t>(next_));
    ++next_;
    observation.read_ms = watch.ms();
    return observation;
  }

 private:
  std::vector<RangePoint> scan(const Pose2& pose, std::uint32_t frame) const {
    const Vec2 eye = pose.position();
    const Surroundings around = surroundings_.within(options_.range_limit_m, eye);
    RandomStream random(seed_, frame, 0, kRays);
    std::vector<RangePoint> points;
    for (int ray = 0; ray < options_.rays; ++ray) {
      const double bearing = 2.0 * kPi * ray / options_.rays;
      if (std::abs(normalizedAngle(bearing)) > options_.view_rad / 2.0) continue;
      const SensorRay looks{eye, unitVector(pose.heading + bearing), options_.sensor_height_m};
      const Hit hit = measured(around.cast(looks, random), random);
      if (hit.distance < kLeastRange || hit.distance > options_.range_limit_m) continue;
      const Vec2 point = hit.distance * unitVector(bearing);
      const double recognised =
          hit.on == Hit::On::Wall ? 1.0 - options_.unrecognised : options_.obstacles_mistaken;
      points.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()),
                        static_cast<float>(options_.sensor_height_m),
                        random.uniform() < recognised ? 1.0F : 0.0F});
    }
    return points;
  }

  /// An outlier looks like a wall: a false match is most likely where the texture repeats.
  Hit measured(Hit hit, RandomStream& random) const {
    if (random.uniform() < options_.outliers) {
      return {random.uniform(kLeastRange, options_.range_limit_m), Hit::On::Wall};
    }
    if (hit.distance > options_.range_limit_m) return Hit{};
    const double share = hit.distance / options_.range_limit_m;
    if (options_.lost > 0.0 && random.uniform() < options_.lost * share * share) return Hit{};
    const double sigma =
        options_.sigma_offset_m + options_.sigma_quadratic * hit.distance * hit.distance;
    hit.distance += random.normal(0.0, sigma);
    return hit;
  }

  SimulationOptions options_;
  std::uint64_t seed_;
  Surroundings surroundings_;
  SourceInfo info_;
  std::size_t next_ = 0;
};

}  // namespace

SimulationOptions laserOnTheMove(double step_m) {
  SimulationOptions options = atStep({}, step_m);
  options.standing = false;
  options.range_limit_m = 60.0;
  options.sigma_offset_m = 0.03;
  options.sigma_quadratic = 0.0001;
  options.outliers = 0.002;
  options.unrecognised = 0.0;
  options.obstacles_mistaken = 1.0;
  return options;
}

SimulationOptions losingReturns(SimulationOptions options) {
  options.lost = 0.4;
  return options;
}

std::unique_ptr<ObservationSource> simulate(const World& world, const SimulationOptions& options,
                                            std::uint64_t seed) {
  return std::make_unique<SimulatedSource>(world, options, seed);
}

}  // namespace handmap
