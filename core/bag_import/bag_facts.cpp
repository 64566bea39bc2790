#include "core/bag_import/bag_facts.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/geometry/pose2.h"

namespace handmap {

namespace {

constexpr std::size_t kMostPoses = 5'000'000;

Pose2 planar(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d turn = pose.linear();
  return {pose.translation().x(), pose.translation().y(), std::atan2(turn(1, 0), turn(0, 0))};
}

void sortByTime(std::vector<StampedPose>& poses) {
  std::ranges::stable_sort(poses, {}, &StampedPose::time_s);
  const auto same = [](const StampedPose& a, const StampedPose& b) { return a.time_s == b.time_s; };
  poses.erase(std::unique(poses.begin(), poses.end(), same), poses.end());
}

class Collector {
 public:
  Collector(const Bag& bag, const BagPlan& plan) : bag_(bag), plan_(plan) {}

  void take(const BagMessage& message) {
    const BagTopic& topic = bag_.topics()[message.topic];
    const FieldReader fields = bag_.fieldsOf(message);
    if (message.topic == plan_.left)
      facts_.left_s.push_back(stampOf(fields, message, facts_.camera_frame));
    if (message.topic == plan_.right) facts_.right_s.push_back(stampOf(fields, message, ignored_));
    if (message.topic == plan_.ranges) takeRanges(fields, message);
    if (message.topic == plan_.odometry) takePose(fields, message, facts_.odometry, true);
    if (message.topic == plan_.truth) takePose(fields, message, facts_.truth, false);
    if (message.topic == plan_.left_info && !facts_.left) {
      facts_.left = ros::readCameraInfo(fields, topic);
    }
    if (message.topic == plan_.right_info && !facts_.right) {
      facts_.right = ros::readCameraInfo(fields, topic);
    }
    if (message.topic == plan_.frames || message.topic == plan_.fixed_frames) {
      takeFrames(ros::readTransforms(fields, topic), message.topic == plan_.frames);
    }
  }

  BagFacts facts() {
    if (!plan_.odometry && !by_frames_.empty()) {
      const auto most = std::ranges::max_element(
          by_frames_, {}, [](const auto& entry) { return entry.second.size(); });
      facts_.odometry = most->second;
      facts_.base = most->first;
    }
    for (const char* usual : {"base_footprint", "base_link"}) {
      if (facts_.base.empty() && facts_.frames.has(usual)) facts_.base = usual;
    }
    // Heights count from the ground, where a frame is there.
    if (facts_.frames.poseIn("base_footprint", facts_.base)) facts_.base = "base_footprint";
    sortByTime(facts_.odometry);
    sortByTime(facts_.truth);
    return std::move(facts_);
  }

 private:
  double stampOf(FieldReader fields, const BagMessage& message, std::string& frame) const {
    ros::Header header = ros::readHeader(fields, bag_.topics()[message.topic].encoding);
    frame = std::move(header.frame);
    return header.stamp_s == 0.0 ? message.time_s : header.stamp_s;
  }

  void takeRanges(const FieldReader& fields, const BagMessage& message) {
    const BagTopic& topic = bag_.topics()[message.topic];
    facts_.ranges_s.push_back(stampOf(fields, message, facts_.ranges_frame));
    if (!ros::isScan(topic)) return;
    const ros::Points scan = ros::readPoints(fields, topic);
    facts_.reach_m = std::max(facts_.reach_m, scan.reach_m);
    if (scan.header.stamp_s > 1.0) facts_.ranges_s.back() = scan.header.stamp_s;  // its middle
  }

  void takePose(const FieldReader& fields, const BagMessage& message,
                std::vector<StampedPose>& poses, bool is_odometry) {
    if (poses.size() == kMostPoses) return;
    ros::Pose pose = ros::readPose(fields, bag_.topics()[message.topic]);
    const double time_s = pose.header.stamp_s == 0.0 ? message.time_s : pose.header.stamp_s;
    poses.push_back({time_s, planar(pose.pose)});
    if (is_odometry && facts_.base.empty()) facts_.base = std::move(pose.child);
  }

  void takeFrames(const std::vector<ros::Pose>& transforms, bool moving) {
    for (const ros::Pose& transform : transforms) {
      const std::string& parent = transform.header.frame;
      const bool is_odometry = moving && parent.find("odom") != std::string::npos;
      if (!is_odometry) {
        facts_.frames.add(parent, transform.child, transform.pose);
      } else if (by_frames_[transform.child].size() < kMostPoses) {
        by_frames_[transform.child].push_back({transform.header.stamp_s, planar(transform.pose)});
      }
    }
  }

  const Bag& bag_;
  const BagPlan& plan_;
  BagFacts facts_;
  std::string ignored_;
  std::map<std::string, std::vector<StampedPose>> by_frames_;  ///< by the robot's frame
};

}  // namespace

BagFacts factsOf(const Bag& bag, const BagPlan& plan, std::vector<std::string>& notes,
                 const std::stop_token& stop) {
  std::vector<bool> wanted(bag.topics().size(), false);
  for (const auto& topic : {plan.left, plan.right, plan.left_info, plan.right_info, plan.ranges,
                            plan.odometry, plan.truth, plan.frames, plan.fixed_frames}) {
    if (topic) wanted[*topic] = true;
  }
  Collector collector(bag, plan);
  std::size_t damaged = 0;
  std::string first;
  bag.read(
      wanted,
      [&](const BagMessage& message) {
        try {
          collector.take(message);
        } catch (const Error& error) {
          if (damaged++ == 0) first = error.what();
        }
      },
      stop);
  if (damaged > 0)
    notes.push_back(phrase("{} messages cannot be read; the first: {}", damaged, first));
  return collector.facts();
}

}  // namespace handmap
