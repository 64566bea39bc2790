#include "core/bag_import/bag_plan.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/bags/ros_messages.h"
#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/sensor_place.h"

namespace handmap {

namespace {

using Test = bool (*)(const BagTopic&);

/// How the images of a pair are told apart by name.
struct Sides {
  std::string_view left;
  std::string_view right;
};
constexpr std::array kSides = {Sides{"left", "right"}, Sides{"infra1", "infra2"},
                               Sides{"image_00", "image_01"}, Sides{"cam0", "cam1"},
                               Sides{"camera0", "camera1"}};
constexpr std::array<std::string_view, 6> kTruthWords = {"truth", "ground", "/gt",
                                                         "_gt",   "mocap",  "vrpn"};

bool holds(const std::string& name, std::string_view word) {
  return name.find(word) != std::string::npos;
}

bool isTruthName(const BagTopic& topic) {
  return std::any_of(kTruthWords.begin(), kTruthWords.end(),
                     [&](std::string_view word) { return holds(topic.name, word); });
}

class Planner {
 public:
  Planner(const Bag& bag, const ToldTopics& told) : bag_(bag), told_(told) {}

  BagPlan plan() const {
    BagPlan plan;
    if (const auto place = told_.find("sensor"); place != told_.end()) {
      plan.sensor = parseSensorPlace(place->second);
    }
    planCamera(plan);
    const auto scan = chosen("scan", ros::isScan, [](const BagTopic&) { return 0; });
    const auto cloud = chosen("points", ros::isPointCloud, [](const BagTopic& topic) {
      return holds(topic.name, "map") ? -1 : 0;
    });
    const bool told_cloud = told_.contains("points") && cloud;
    if (told_cloud && told_.contains("scan") && scan) {
      throw Error(ErrorCode::Usage, phrase("{} and {}: found both, expected one of them",
                                           bag_.topics()[*scan].name, bag_.topics()[*cloud].name));
    }
    plan.ranges = scan && !told_cloud ? scan : cloud;
    plan.odometry = chosen("odometry", ros::isPose, [](const BagTopic& topic) {
      if (isTruthName(topic) || topic.type != "nav_msgs/Odometry") return -1;
      return holds(topic.name, "odom") ? 1 : 0;
    });
    plan.truth = chosen("truth", ros::isPose,
                        [](const BagTopic& topic) { return isTruthName(topic) ? 0 : -1; });
    plan.frames = best(ros::isTransforms,
                       [](const BagTopic& topic) { return holds(topic.name, "static") ? -1 : 0; });
    plan.fixed_frames = best(ros::isTransforms, [](const BagTopic& topic) {
      return holds(topic.name, "static") ? 0 : -1;
    });
    return plan;
  }

 private:
  /// The topic with the highest score, then with the most messages; none below 0.
  template <typename Score>
  std::optional<std::size_t> best(Test serves, const Score& score) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const BagTopic& topic = bag_.topics()[i];
      const bool is_readable = topic.messages > 0 && topic.encoding != MessageEncoding::Other;
      if (!is_readable || !serves(topic) || score(topic) < 0) continue;
      const auto rank = [&](const BagTopic& t) { return std::pair(score(t), t.messages); };
      if (!found || rank(topic) > rank(bag_.topics()[*found])) found = i;
    }
    return found;
  }

  template <typename Score>
  std::optional<std::size_t> chosen(const std::string& role, Test serves,
                                    const Score& score) const {
    const auto name = told_.find(role);
    if (name == told_.end()) return best(serves, score);
    if (name->second == "none") return std::nullopt;
    std::string others;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const BagTopic& topic = bag_.topics()[i];
      if (!serves(topic)) continue;
      if (topic.name == name->second) return i;
      others += (others.empty() ? "" : ", ") + topic.name;
    }
    throwBadInput(bag_.path().string(), "--" + role, name->second,
                  others.empty() ? phrase("none: there is no topic that could serve") : others);
  }

  void planCamera(BagPlan& plan) const {
    plan.left = chosen("left", ros::isImage, [&](const BagTopic& topic) {
      if (holds(topic.name, "depth") || !other(topic.name)) return -1;
      return holds(topic.name, "rect") ? 1 : 0;
    });
    plan.right = chosen("right", ros::isImage, [&](const BagTopic& topic) {
      const auto right = plan.left ? other(bag_.topics()[*plan.left].name) : std::nullopt;
      return right && topic.name == bag_.topics()[*right].name ? 0 : -1;
    });
    if (plan.left) plan.left_info = infoOf(bag_.topics()[*plan.left].name);
    if (plan.right) plan.right_info = infoOf(bag_.topics()[*plan.right].name);
  }

  std::optional<std::size_t> named(const std::string& name, Test serves) const {
    const auto& topics = bag_.topics();
    const auto found = std::ranges::find_if(topics, [&](const BagTopic& topic) {
      return topic.name == name && serves(topic) && topic.messages > 0;
    });
    return found == topics.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - topics.begin()));
  }

  /// The image to the right of one.
  std::optional<std::size_t> other(std::string name) const {
    for (const Sides& sides : kSides) {
      const std::size_t at = name.rfind(sides.left);
      if (at == std::string::npos) continue;
      return named(name.replace(at, sides.left.size(), sides.right), ros::isImage);
    }
    return std::nullopt;
  }

  /// /stereo/left/camera_info of /stereo/left/image_raw/compressed
  std::optional<std::size_t> infoOf(std::string image) const {
    while (true) {
      const std::size_t slash = image.rfind('/');
      if (slash == std::string::npos) return std::nullopt;
      image.resize(slash);
      if (const auto info = named(image + "/camera_info", ros::isCameraInfo)) return info;
    }
  }

  const Bag& bag_;
  const ToldTopics& told_;
};

}  // namespace

bool canServe(const BagTopic& topic, const std::string& role) {
  if (topic.messages == 0 || topic.encoding == MessageEncoding::Other) return false;
  if (role == "left" || role == "right") return ros::isImage(topic);
  if (role == "scan") return ros::isScan(topic);
  return role == "points" ? ros::isPointCloud(topic) : ros::isPose(topic);
}

std::string BagPlan::roleOf(std::size_t topic, const Bag& bag) const {
  if (topic == ranges) return ros::isScan(bag.topics()[topic]) ? "scan" : "points";
  if (topic == odometry) return "odometry";
  if (topic == truth) return "truth";
  if (topic == frames || topic == fixed_frames) return "frames";
  if (!hasCamera()) return {};
  if (topic == left) return "left";
  if (topic == right) return "right";
  return topic == left_info || topic == right_info ? "camera" : "";
}

BagPlan planOf(const Bag& bag, const ToldTopics& told) { return Planner(bag, told).plan(); }

}  // namespace handmap
