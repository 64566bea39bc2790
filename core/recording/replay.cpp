#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/recording/recording.h"
#include "core/recording/view_reader.h"

namespace handmap {

namespace {

constexpr std::size_t kSample = 64;  // rows; enough to tell how far a sensor reaches

/// The rows of one stop, or one row of a moving robot.
using RowGroup = std::vector<FrameRow>;

bool hasImages(const FrameRow& row) { return !row.left.empty(); }
bool hasPoints(const FrameRow& row) { return !row.points.empty(); }

SourceKind chosenKind(const Recording& recording, SourceKind kind) {
  if (kind != SourceKind::Auto) return kind;
  const auto& rows = recording.rows;
  return std::any_of(rows.begin(), rows.end(), hasImages) ? SourceKind::Images : SourceKind::Points;
}

std::vector<RowGroup> select(const Recording& recording, const ReplayOptions& options,
                             SourceKind kind) {
  std::vector<RowGroup> groups;
  for (const FrameRow& row : recording.rows) {
    if (kind == SourceKind::Images ? !hasImages(row) : !hasPoints(row)) continue;
    const bool same_stop = !groups.empty() && row.stop && groups.back().front().stop == row.stop;
    if (!same_stop) groups.emplace_back();
    groups.back().push_back(row);
  }
  std::erase_if(groups, [&](const RowGroup& group) {
    const int frame = group.front().frame;
    return frame < options.from || (options.to && frame > *options.to);
  });
  const auto every = static_cast<std::size_t>(options.every);
  std::vector<RowGroup> selected;
  for (std::size_t i = 0; i < groups.size(); i += every) selected.push_back(std::move(groups[i]));
  return selected;
}

/// The first frame that may be used, with what is looked for in it or without.
const FrameRow& startRow(const Recording& recording, const ReplayOptions& options) {
  return *std::find_if(recording.rows.begin(), recording.rows.end(),
                       [&](const FrameRow& row) { return row.frame >= options.from; });
}

/// The odometry must reach from the start to the last selected frame.
void checkCovered(const FrameRow& start, const std::vector<RowGroup>& groups,
                  const Trajectory& odometry, const std::string& source) {
  const auto covered = [&](const RowGroup& group) {
    return odometry.at(group.front().time_s).has_value();
  };
  const auto first = std::find_if(groups.begin(), groups.end(), covered);
  const auto last = std::find_if(groups.rbegin(), groups.rend(), covered);
  const FrameRow& end = groups.back().front();
  const StampedPose& first_pose = odometry.poses().front();
  const StampedPose& last_pose = odometry.poses().back();
  if (!odometry.at(start.time_s) && start.time_s < first_pose.time_s) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: frame {} is at {} s, but the odometry starts late, at {} s", source,
                       start.frame, formatNumber(start.time_s), formatNumber(first_pose.time_s)),
                first == groups.end() ? phrase("the odometry belongs to another time")
                                      : phrase("begin later: --from {}", first->front().frame));
  }
  if (!covered(groups.back())) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: frame {} is at {} s, but the odometry ends at {} s", source, end.frame,
                       formatNumber(end.time_s), formatNumber(last_pose.time_s)),
                last == groups.rend() ? phrase("the odometry belongs to another time")
                                      : phrase("end earlier: --to {}", last->front().frame));
  }
}

/// No farther than anything came back from, whatever is stated: silence says nothing of what is
/// beyond a sensor's reach.
double reachOf(const Recording& recording) {
  std::vector<const FrameRow*> rows;
  for (const FrameRow& row : recording.rows) {
    if (hasPoints(row)) rows.push_back(&row);
  }
  const ViewReader reader(recording);
  const std::size_t step = std::max<std::size_t>(1, rows.size() / kSample);
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < rows.size() && farthest_m < recording.range_limit_m; i += step) {
    View view;
    try {
      reader.readPoints(*rows[i], view);
    } catch (const Error&) {
      continue;  // told where it is its turn
    }
    for (const RangePoint& p : *view.points) {
      if (isMeasured(p)) farthest_m = std::max(farthest_m, double{std::hypot(p.x, p.y)});
    }
  }
  if (farthest_m == 0.0) return recording.range_limit_m;
  return std::min(std::max(1.0, std::ceil(farthest_m)), recording.range_limit_m);
}

class ReplaySource : public ObservationSource {
 public:
  ReplaySource(Recording recording, std::vector<RowGroup> groups, SourceKind kind, double start_s)
      : groups_(std::move(groups)),
        kind_(kind),
        reader_(recording),
        odometry_(std::move(recording.odometry)) {
    info_.name = std::move(recording.name);
    info_.observations = static_cast<int>(groups_.size());
    info_.range_limit_m = kind == SourceKind::Points ? reachOf(recording) : recording.range_limit_m;
    if (kind == SourceKind::Images) info_.camera = recording.camera;
    info_.truth = recording.truth.poses();
    info_.start_odometry = odometryAt(start_s);
    const double end_s = groups_.back().back().time_s;
    for (const StampedPose& stamped : odometry_.poses()) {
      if (stamped.time_s >= start_s && stamped.time_s <= end_s) info_.odometry.push_back(stamped);
    }
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    if (next_ == groups_.size()) return std::nullopt;
    const RowGroup& group = groups_[next_++];
    const FrameRow& first = group.front();
    try {
      return read(group);
    } catch (const Error& error) {
      throw FrameError(first.frame, error.what());
    }
  }

 private:
  Pose2 odometryAt(double time_s) const {
    return odometry_.empty() ? Pose2{} : odometry_.at(time_s).value();
  }

  Observation read(const RowGroup& group) {
    const Stopwatch watch;
    Observation observation;
    observation.frame = group.front().frame;
    observation.time_s = group.front().time_s;
    observation.standing = group.front().stop.has_value();
    observation.odometry = odometryAt(observation.time_s);
    for (const FrameRow& row : group) {
      View& view = observation.views.emplace_back();
      view.pan = row.pan;
      if (kind_ == SourceKind::Images) {
        reader_.readImages(row, view);
      } else {
        reader_.readPoints(row, view);
      }
    }
    observation.read_ms = watch.ms();
    return observation;
  }

  std::vector<RowGroup> groups_;
  SourceKind kind_;
  ViewReader reader_;
  Trajectory odometry_;
  SourceInfo info_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<ObservationSource> replay(Recording recording, const ReplayOptions& options) {
  const std::string source = recording.folder.string();
  if (options.every < 1) {
    throw Error(ErrorCode::Usage, phrase("--every: found {}, expected 1 or more", options.every));
  }
  const SourceKind kind = chosenKind(recording, options.kind);
  std::vector<RowGroup> groups = select(recording, options, kind);
  const std::string what = kind == SourceKind::Images ? phrase("images") : phrase("points");
  if (groups.empty()) {
    throwBadInput(source, "",
                  phrase("no frame with {} from {} to {}", what, options.from,
                         options.to ? std::to_string(*options.to) : phrase("the end")),
                  phrase("at least one"));
  }
  if (kind == SourceKind::Images && !recording.camera) {
    throwBadInput(source, "", phrase("images but no camera"),
                  phrase("the calibration of the camera"));
  }
  const FrameRow& start = startRow(recording, options);
  const double start_s = start.time_s;
  if (options.visual_odometry) {
    if (kind != SourceKind::Images) {
      throwBadInput(source, "", phrase("points chosen to see with"),
                    phrase("images for visual odometry"));
    }
  }
  if (options.visual_odometry || options.without_odometry) {
    recording.odometry = {};
    return std::make_unique<ReplaySource>(std::move(recording), std::move(groups), kind, start_s);
  }
  if (!options.odometry.empty()) recording.odometry = readTum(options.odometry);
  if (recording.odometry.empty()) {
    throw Error(ErrorCode::BadInput, phrase("{}: found no odometry, expected odometry.tum", source),
                phrase("give one: --odometry FILE.tum"));
  }
  checkCovered(start, groups, recording.odometry,
               options.odometry.empty() ? source : options.odometry.string());
  return std::make_unique<ReplaySource>(std::move(recording), std::move(groups), kind, start_s);
}

}  // namespace handmap
