#include "core/rendering/rendered_source.h"

#include "core/base/stopwatch.h"
#include "core/simulation/drive.h"

namespace handmap {

namespace {

constexpr double kPans_deg[] = {-150.0, -90.0, -30.0, 30.0, 90.0, 150.0};

class RenderedSource : public ObservationSource {
 public:
  RenderedSource(const World& world, const SimulationOptions& simulation,
                 const RenderOptions& rendering, Looking looking, std::uint64_t seed,
                 TruthListener listener, std::stop_token stop)
      : world_(world),
        renderer_(rendering, seed),
        looking_(looking),
        listener_(std::move(listener)),
        stop_(std::move(stop)),
        info_(infoOf(world, simulation, seed)) {
    info_.camera = renderer_.camera();
    if (looking == Looking::Around) {
      for (const double pan : kPans_deg) pans_.push_back(toRadians(pan));
    } else {
      pans_ = {0.0};
    }
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    if (next_ == info_.truth.size()) return std::nullopt;
    const Stopwatch watch;
    const Pose2 pose = info_.truth[next_].pose;
    Observation observation = observationAt(next_, info_);
    observation.standing = looking_ == Looking::Around;
    const Scene scene = renderer_.sceneAt(world_, pose, observation.time_s);
    for (std::size_t i = 0; i < pans_.size(); ++i) {
      if (stop_.stop_requested()) return std::nullopt;
      StereoImages images = renderer_.images(
          scene, pose, pans_[i], static_cast<std::uint32_t>(next_), static_cast<std::uint32_t>(i));
      observation.views.push_back(
          {pans_[i], std::move(images.left), std::move(images.right), std::nullopt});
    }
    ++next_;
    observation.read_ms = watch.ms();
    if (listener_) tell(scene, pose, observation);
    return observation;
  }

 private:
  void tell(const Scene& scene, const Pose2& pose, const Observation& observation) const {
    std::vector<ImageTruth> truths;
    for (const double pan : pans_) truths.push_back(renderer_.truth(scene, pose, pan));
    listener_(observation, truths);
  }

  World world_;
  Renderer renderer_;
  Looking looking_;
  TruthListener listener_;
  std::stop_token stop_;
  SourceInfo info_;
  std::vector<double> pans_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<ObservationSource> renderedSource(const World& world,
                                                  const SimulationOptions& simulation,
                                                  const RenderOptions& rendering, Looking looking,
                                                  std::uint64_t seed, TruthListener listener,
                                                  std::stop_token stop) {
  return std::make_unique<RenderedSource>(world, simulation, rendering, looking, seed,
                                          std::move(listener), std::move(stop));
}

}  // namespace handmap
