#include "core/simulation/feature_source.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/base/stopwatch.h"
#include "core/simulation/drive.h"
#include "core/simulation/joined_looks.h"
#include "core/simulation/surroundings.h"

namespace handmap {

namespace {

constexpr std::uint32_t kTracks = 45;
constexpr std::uint32_t kTexture = 47;

// "boulevard": 4,723 tracks of 998 frames of a car that drives 1.1 km (KITTI odometry 06).
constexpr double kEye_m = 1.65;                // above the ground, KITTI
constexpr double kView_rad = toRadians(80.0);  // boulevard: −40.8° … 39.8°
constexpr double kLowest_rise = -0.14;         // the ground 12 m away: kNearestBegun_m
constexpr double kHighest_rise = 0.25;         // boulevard: 95 % of 25 m away are below 6.9 m
constexpr double kWallShare = 1.0 / 3.0;       // boulevard: 30 % of what is above 0.8 m
constexpr double kGroundShare = 0.1;           // boulevard: 13 % below 0.3 m, 17 % below 0.8 m
constexpr double kNearestBegun_m = 12.0;  // boulevard: 95 % of the first looks are beyond 14.7 m
constexpr double kNearest_m = 5.0;        // boulevard: no look is nearer than 5.15 m
// In view; boulevard: 5.7 frames of 1.14 m, what leaves it included.
constexpr double kLife_m = 9.0;
constexpr double kStretch_m = 20.0;     // boulevard: correlation of the counts 0.4 after 11 m
constexpr double kTrackNoise = 0.0006;  // σ of 1/d, 1/m; boulevard: far looks of a track are
                                        // off by 0.0007 d² from its nearest look …
constexpr double kLookNoise = 0.0003;   // … and by 0.0003 d² from its middle
constexpr double kAcross_rad = 0.001;   // boulevard: 2 cm 20 m away
constexpr double kBehind_m = 0.3;       // choice: so far behind a surface all is hidden
constexpr int kTriesEach = 40;          // choice: for a track before there is none

/// Mean 1: as the lengths of tracks and the numbers of tracks in a frame are spread in boulevard
/// (quarters at 3, 5, 8 frames, 95 % below 14; 13, 24, 41 tracks, 95 % below 63).
double gammaOfTwo(RandomStream& random) {
  return -0.5 * (std::log(1.0 - random.uniform()) + std::log(1.0 - random.uniform()));
}

class FeatureSource : public ObservationSource {
 public:
  FeatureSource(const World& world, const SimulationOptions& options,
                const FeatureOptions& features, std::uint64_t seed)
      : options_(options),
        features_(features),
        seed_(seed),
        surroundings_(world),
        info_(infoOf(world, options, seed)),
        joined_(features.joined_m) {}

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    if (next_ == info_.truth.size()) return std::nullopt;
    const Stopwatch watch;
    Observation observation = observationAt(next_, info_);
    observation.views.push_back(look(info_.truth[next_].pose, static_cast<std::uint32_t>(next_)));
    if (features_.joined_m > 0.0) {
      observation.views.front() = joined_.add(observation.views.front(), observation.odometry);
    }
    ++next_;
    observation.read_ms = watch.ms();
    return observation;
  }

 private:
  enum class Kind { Wall, Ground, Other };

  struct Track {
    std::uint32_t id;
    Kind kind;
    Vec2 place;
    double height;
    double left_m;     ///< before it is lost
    double off = 0.0;  ///< of 1/d in all of its looks, in σ
  };

  View look(const Pose2& pose, std::uint32_t frame) {
    RandomStream random(seed_, frame, 0, kTracks);
    const Surroundings around = surroundings_.within(options_.range_limit_m, pose.position());
    std::erase_if(tracks_, [&](Track& track) {
      track.left_m -= options_.step_m;
      return track.left_m <= 0.0 || !isSeen(track, pose, around, random);
    });
    const double wanted = tracksWanted();
    const auto missing = wanted - static_cast<double>(tracks_.size());
    for (int i = 0; i < kTriesEach * missing && static_cast<double>(tracks_.size()) < wanted; ++i) {
      if (auto track = found(pose, around, wanted, random)) tracks_.push_back(*track);
    }
    View view;
    view.points.emplace();
    for (const Track& track : tracks_) {
      view.points->push_back(measured(track, pose, random));
      view.ids.push_back(track.id);
    }
    return view;
  }

  /// Streets have stretches with much to follow and with little.
  double tracksWanted() const {
    const double driven_m = static_cast<double>(next_) * options_.step_m;
    RandomStream random(seed_, static_cast<std::uint32_t>(driven_m / kStretch_m), 0, kTexture);
    return features_.tracks * gammaOfTwo(random);
  }

  bool isSeen(const Track& track, const Pose2& pose, const Surroundings& around,
              RandomStream& random) const {
    const Vec2 own = pose.toOwn(track.place);
    const double distance = own.norm();
    if (distance > options_.range_limit_m || distance < kNearest_m) return false;
    if (std::abs(std::atan2(own.y(), own.x())) > kView_rad / 2.0) return false;
    const SensorRay ray{pose.position(), (track.place - pose.position()) / distance, kEye_m,
                        (track.height - kEye_m) / distance};
    return around.cast(ray, random).distance > distance - kBehind_m;
  }

  /// nullopt where the ray meets nothing or enough is followed of what it meets.
  std::optional<Track> found(const Pose2& pose, const Surroundings& around, double wanted,
                             RandomStream& random) {
    const double bearing = random.uniform(-0.5, 0.5) * kView_rad;
    const SensorRay ray{pose.position(), unitVector(pose.heading + bearing), kEye_m,
                        random.uniform(kLowest_rise, kHighest_rise)};
    const Hit hit = around.cast(ray, random);
    const double ground = ray.rise < 0.0 ? -kEye_m / ray.rise : kNoHit;
    const double distance = std::min(hit.distance, ground);
    if (distance > options_.range_limit_m || distance < kNearestBegun_m) return std::nullopt;
    const Kind kind = ground < hit.distance     ? Kind::Ground
                      : hit.on == Hit::On::Wall ? Kind::Wall
                                                : Kind::Other;
    if (enoughOf(kind, wanted)) return std::nullopt;
    return Track{++last_id_,
                 kind,
                 ray.origin + distance * ray.direction,
                 ray.heightAt(distance),
                 kLife_m * gammaOfTwo(random),
                 random.normal()};
  }

  bool enoughOf(Kind kind, double wanted) const {
    const auto now = std::count_if(tracks_.begin(), tracks_.end(),
                                   [&](const Track& track) { return track.kind == kind; });
    const double share = kind == Kind::Wall     ? kWallShare
                         : kind == Kind::Ground ? kGroundShare
                                                : 1.0 - kWallShare - kGroundShare;
    return static_cast<double>(now) >= share * wanted;
  }

  /// Off in disparity, so along the ray by the square of the distance.
  RangePoint measured(const Track& track, const Pose2& pose, RandomStream& random) const {
    const Vec2 own = pose.toOwn(track.place);
    const double distance = own.norm();
    const double off = kTrackNoise * track.off + random.normal(0.0, kLookNoise);
    const double stretch = 1.0 / std::max(0.5, 1.0 + distance * off);
    const double bearing = std::atan2(own.y(), own.x()) + random.normal(0.0, kAcross_rad);
    const double rise = (track.height - kEye_m) / distance + random.normal(0.0, kAcross_rad);
    const Vec2 point = stretch * distance * unitVector(bearing);
    return {static_cast<float>(point.x()), static_cast<float>(point.y()),
            static_cast<float>(kEye_m + stretch * distance * rise), 1.0F};
  }

  SimulationOptions options_;
  FeatureOptions features_;
  std::uint64_t seed_;
  Surroundings surroundings_;
  SourceInfo info_;
  JoinedLooks joined_;
  std::vector<Track> tracks_;
  std::uint32_t last_id_ = 0;
  std::size_t next_ = 0;
};

}  // namespace

SimulationOptions drivingPastFeatures(double step_m) {
  SimulationOptions options = atStep({}, step_m);
  options.standing = false;
  options.speed_m_s = 10.0;  // boulevard: 1.14 m in 0.104 s
  return options;
}

std::unique_ptr<ObservationSource> simulateFeatures(const World& world,
                                                    const SimulationOptions& options,
                                                    const FeatureOptions& features,
                                                    std::uint64_t seed) {
  return std::make_unique<FeatureSource>(world, options, features, seed);
}

}  // namespace handmap
