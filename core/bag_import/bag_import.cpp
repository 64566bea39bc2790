#include "core/bag_import/bag_import.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/bag_import/bag_camera.h"
#include "core/bags/ros_camera.h"
#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/recording.h"
#include "core/recording/sensor_place.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr double kSamePair_s = 0.01;              // cameras that are triggered together
constexpr double kSameTime_s = 1e-3;              // of images and ranges
constexpr std::size_t kMostWaiting = 512u << 20;  // bytes of messages out of order

/// A row to be: which messages of each topic belong to it.
struct Row {
  double time_s = 0.0;
  std::optional<std::size_t> left, right, ranges;
};

std::optional<std::size_t> nearest(const std::vector<std::pair<double, std::size_t>>& stamps,
                                   double time_s, double tolerance_s) {
  auto at = std::ranges::lower_bound(stamps, time_s, {}, &std::pair<double, std::size_t>::first);
  if (at == stamps.end() ||
      (at != stamps.begin() && time_s - std::prev(at)->first < at->first - time_s)) {
    if (at == stamps.begin()) return std::nullopt;
    --at;
  }
  return std::abs(at->first - time_s) <= tolerance_s ? std::optional(at->second) : std::nullopt;
}

std::vector<std::pair<double, std::size_t>> inOrder(const std::vector<double>& stamps) {
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t i = 0; i < stamps.size(); ++i) sorted.emplace_back(stamps[i], i);
  std::ranges::sort(sorted);
  return sorted;
}

std::vector<Row> rowsOf(const BagFacts& facts, bool camera, const Trajectory& odometry) {
  std::vector<Row> rows;
  const auto right = inOrder(facts.right_s);
  const auto ranges = inOrder(facts.ranges_s);
  std::vector<bool> has_images(ranges.size(), false);
  if (camera) {
    for (const auto& [time_s, left] : inOrder(facts.left_s)) {
      const auto other = nearest(right, time_s, kSamePair_s);
      if (!other) continue;
      const auto scan = nearest(ranges, time_s, kSameTime_s);
      if (scan) has_images[*scan] = true;
      rows.push_back({time_s, left, other, scan});
    }
  }
  for (const auto& [time_s, scan] : ranges) {
    if (!has_images[scan]) rows.push_back({time_s, {}, {}, scan});
  }
  std::ranges::stable_sort(rows, {}, &Row::time_s);
  const auto same = [](const Row& a, const Row& b) { return a.time_s == b.time_s; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  if (!odometry.empty()) {
    std::erase_if(rows, [&](const Row& row) { return !odometry.at(row.time_s); });
  }
  return rows;
}

/// Brings what comes in the order of the bag into that of the rows, and writes it.
class BagRecorder {
 public:
  BagRecorder(const Bag& bag, const BagPlan& plan, const BagFacts& facts,
              const std::optional<BagCamera>& camera, std::vector<std::string>& notes)
      : bag_(bag), plan_(plan), camera_(camera), notes_(notes) {
    sensor_ = plan.sensor ? plan.sensor : facts.frames.poseIn(facts.base, facts.ranges_frame);
    if (plan.ranges && !sensor_ && facts.ranges_frame != facts.base) {
      notes.push_back(phrase("nothing tells where \"{}\" is on the robot: taken to be its origin",
                             facts.ranges_frame));
    }
  }

  ImportedBag record(std::vector<Row> rows, const Trajectory& odometry, RecordingWriter& writer,
                     const std::function<void(double)>& progress, const std::stop_token& stop) {
    rows_ = std::move(rows);
    odometry_ = &odometry;
    writer_ = &writer;
    std::vector<bool> wanted(bag_.topics().size(), false);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto belongs = [&](std::optional<std::size_t> topic,
                               std::optional<std::size_t> message) {
        if (!topic || !message) return;
        wanted[*topic] = true;
        row_of_[{*topic, *message}] = i;
        ++missing_[i];
      };
      belongs(plan_.left, rows_[i].left);
      belongs(plan_.right, rows_[i].right);
      belongs(plan_.ranges, rows_[i].ranges);
    }
    bag_.read(
        wanted,
        [&](const BagMessage& message) {
          take(message);
          if (progress) progress(static_cast<double>(next_) / static_cast<double>(rows_.size()));
        },
        stop);
    if (damaged_ > 0 && imported_.pairs + imported_.scans == 0) {
      throw Error(ErrorCode::BadInput, phrase("no message can be read; the first: {}", first_));
    }
    if (damaged_ > 0) {
      notes_.push_back(phrase("{} messages cannot be read; the first: {}", damaged_, first_));
    }
    return imported_;
  }

 private:
  void take(const BagMessage& message) {
    const std::size_t number = seen_[message.topic]++;
    const auto row = row_of_.find({message.topic, number});
    if (row == row_of_.end()) return;
    waiting_bytes_ += message.bytes.size();
    if (waiting_bytes_ > kMostWaiting) {
      throwBadInput(bag_.path().string(), bag_.topics()[message.topic].name,
                    phrase("more than {} bytes out of order", kMostWaiting),
                    phrase("messages about in the order of their times"));
    }
    waiting_[row->second][message.topic] = std::string(message.bytes);
    --missing_[row->second];
    for (; next_ < rows_.size() && missing_[next_] == 0; ++next_) write(next_);
  }

  void write(std::size_t index) {
    const Row& row = rows_[index];
    const auto messages = std::move(waiting_[index]);
    waiting_.erase(index);
    for (const auto& [topic, bytes] : messages) waiting_bytes_ -= bytes.size();
    const auto fields = [&](std::size_t topic) {
      return bag_.fieldsOf({topic, row.time_s, messages.at(topic)});
    };
    View view;
    try {
      if (row.left) {
        view.left = camera_->left(ros::readImage(fields(*plan_.left), bag_.topics()[*plan_.left]));
        view.right =
            camera_->right(ros::readImage(fields(*plan_.right), bag_.topics()[*plan_.right]));
      }
      if (row.ranges) view.points = pointsIn(fields(*plan_.ranges));
    } catch (const Error& error) {
      if (damaged_++ == 0) first_ = error.what();
      return;
    }
    Observation observation;
    observation.frame = static_cast<int>(index);
    observation.time_s = row.time_s;
    if (!odometry_->empty()) observation.odometry = *odometry_->at(row.time_s);
    imported_.pairs += row.left ? 1 : 0;
    imported_.scans += row.ranges ? 1 : 0;
    observation.views.push_back(std::move(view));
    writer_->add(observation);
  }

  std::vector<RangePoint> pointsIn(const FieldReader& fields) const {
    std::vector<RangePoint> points = ros::readPoints(fields, bag_.topics()[*plan_.ranges]).points;
    return sensor_ ? placedOn(*sensor_, std::move(points)) : points;
  }

  const Bag& bag_;
  const BagPlan& plan_;
  const std::optional<BagCamera>& camera_;
  std::vector<std::string>& notes_;
  std::optional<Eigen::Isometry3d> sensor_;  ///< in the robot's frame
  std::vector<Row> rows_;
  const Trajectory* odometry_ = nullptr;
  RecordingWriter* writer_ = nullptr;
  ImportedBag imported_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> row_of_;
  std::map<std::size_t, std::size_t> seen_;                            ///< by topic
  std::map<std::size_t, int> missing_;                                 ///< by row
  std::map<std::size_t, std::map<std::size_t, std::string>> waiting_;  ///< by row, by topic
  std::size_t waiting_bytes_ = 0;
  std::size_t next_ = 0;
  std::size_t damaged_ = 0;
  std::string first_;
};

/// What it holds, for who expected more.
[[noreturn]] void refuseBlind(const Bag& bag, const BagPlan& plan) {
  std::string found;
  for (const BagTopic& topic : bag.topics()) {
    if (found.size() > 300) break;
    found += (found.empty() ? "" : ", ") + topic.name + " (" + topic.type + ")";
  }
  const bool has_images = plan.left && plan.right;
  throw Error(ErrorCode::BadInput,
              phrase("{}: found nothing that sees, expected scans, points or a pair of images with "
                     "camera infos; it holds {}",
                     bag.path().string(), found.empty() ? phrase("nothing") : found),
              has_images ? phrase("the images have no camera_info beside them") : "");
}

}  // namespace

ImportedBag importBag(const Bag& bag, const BagPlan& plan, const fs::path& folder,
                      const std::string& name, std::vector<std::string>& notes,
                      const std::function<void(double)>& progress, const std::stop_token& stop) {
  for (const std::string& note : bag.notes()) notes.push_back(note);
  if (!plan.seesAnything()) refuseBlind(bag, plan);
  const BagFacts facts = factsOf(bag, plan, notes, stop);
  std::optional<BagCamera> camera;
  if (plan.hasCamera()) {
    const bool rectified = ros::namesRectified(bag.topics()[*plan.left].name);
    try {
      camera.emplace(facts, plan, rectified, bag.path().string(), notes);
    } catch (const Error& error) {
      if (!plan.ranges) throw;
      notes.emplace_back(error.what());
    }
  }
  const Trajectory odometry(facts.odometry, name);
  std::vector<Row> rows = rowsOf(facts, camera.has_value(), odometry);
  if (rows.empty()) {
    throw Error(
        ErrorCode::BadInput,
        phrase("{}: found no image or scan at a time that the odometry knows, expected some",
               bag.path().string()));
  }
  SourceInfo info;
  info.name = name;
  info.without_odometry = true;  // the bag's own, at its rate, is written below
  info.range_limit_m =
      facts.reach_m > 0.0 ? std::clamp(facts.reach_m, kLeastReach_m, kMostReach_m) : kUsualReach_m;
  if (camera) info.camera = camera->camera();
  RecordingWriter writer(folder, info);
  ImportedBag imported = BagRecorder(bag, plan, facts, camera, notes)
                             .record(std::move(rows), odometry, writer, progress, stop);
  imported.poses = facts.odometry.size();
  if (odometry.empty()) {
    notes.push_back(phrase("no poses: the scans are to tell the motion"));
  } else {
    writeFileAtomically(folder / "odometry.tum", formatTum(facts.odometry));
  }
  if (!facts.truth.empty()) writeFileAtomically(folder / "truth.tum", formatTum(facts.truth));
  return imported;
}

}  // namespace handmap
