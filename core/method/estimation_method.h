// What a run asks of a method; the published one and ours answer.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "core/estimation/estimator.h"
#include "core/method/phase.h"
#include "core/method/run_settings.h"
#include "core/method/run_warning.h"
#include "core/method/snapshot.h"
#include "core/perception/perception.h"

namespace handmap {

class EstimationMethod {
 public:
  virtual ~EstimationMethod() = default;

  /// Works in one observation. Returns false and leaves the state as it was when `stop` was
  /// requested. `progress` may be called from any thread.
  virtual bool step(double time_s, const Odometry& odometry, const Percept& percept,
                    const LazyLocalMap& local_map, const std::stop_token& stop,
                    const std::function<void(double)>& progress) = 0;
  /// The steps that follow tell it their phases, where the method has any; nullptr: no longer.
  /// Looking changes nothing.
  virtual void trace(PhaseRecorder* /*recorder*/) {}
  /// After the last observation, as far as `stop` allows. Returns whether the result has changed.
  virtual bool finish(const std::stop_token& /*stop*/,
                      const std::function<void(double)>& /*progress*/) {
    return false;
  }

  /// What went wrong on the way without ending it.
  virtual std::vector<RunWarning> warnings() const { return {}; }
  /// Fills in what the method knows of the last observation.
  virtual void describe(FrameReport& report) const = 0;
  virtual std::vector<ParticleView> particles() const = 0;
  virtual std::vector<BuildingSwarm> swarms() const = 0;
  /// Best so far, map frame.
  virtual SharedList<StampedPose> trajectory() const = 0;
  /// Makes the best map so far, at any time later and in any thread.
  virtual std::function<Map()> refinedMap() const = 0;
};

/// Throws BadInput for a map without buildings or without a start pose.
std::unique_ptr<EstimationMethod> makeMethod(const Map& drawing, const SourceInfo& source,
                                             const RunSettings& settings);

}  // namespace handmap
