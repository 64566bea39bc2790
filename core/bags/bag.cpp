#include "core/bags/bag.h"

#include <algorithm>

#include "core/bags/bag_kinds.h"
#include "core/bags/ros_definitions.h"
#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostTopics = 100'000;

bool isBagFile(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".bag" || ending == ".mcap" || ending == ".db3";
}

/// Of the folder of a ROS 2 bag: NAME_2.mcap before NAME_10.mcap.
std::vector<fs::path> partsOf(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (isBagFile(entry.path())) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end(), [](const fs::path& a, const fs::path& b) {
    const std::string one = a.filename().string();
    const std::string other = b.filename().string();
    return one.size() != other.size() ? one.size() < other.size() : one < other;
  });
  return parts;
}

std::unique_ptr<Bag> openBagFile(const fs::path& path, const std::stop_token& stop) {
  const std::string ending = path.extension().string();
  if (ending == ".bag") return openRos1Bag(path, stop);
  if (ending == ".mcap") return openMcap(path, stop);
  if (ending == ".db3") return openSqliteBag(path, stop);
  throwBadInput(path.string(), "", phrase("another ending"), ".bag, .mcap, .db3");
}

}  // namespace

FieldReader Bag::fieldsOf(const BagMessage& message) const {
  const BagTopic& topic = topics_[message.topic];
  std::string source = path_.string() + ": " + topic.name;
  if (topic.encoding == MessageEncoding::Ros1) return {message.bytes, std::move(source)};
  if (topic.encoding == MessageEncoding::Cdr) {
    return FieldReader::cdr(message.bytes, std::move(source));
  }
  throwBadInput(source, "", phrase("messages in another encoding"), "ros1, cdr");
}

std::size_t Bag::topicOf(const std::string& name, std::string type, MessageEncoding encoding) {
  type = rosTypeName(std::move(type));
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    if (topics_[i].name == name && topics_[i].type == type) return i;
  }
  if (topics_.size() == kMostTopics) {
    throwBadInput(path_.string(), "", phrase("one more topic"), phrase("at most {}", kMostTopics));
  }
  topics_.push_back({name, std::move(type), encoding, 0, 0.0, 0.0});
  return topics_.size() - 1;
}

void Bag::count(std::size_t topic, double time_s, std::size_t messages) {
  BagTopic& counted = topics_[topic];
  const bool is_first = counted.messages == 0;
  counted.first_s = is_first ? time_s : std::min(counted.first_s, time_s);
  counted.last_s = is_first ? time_s : std::max(counted.last_s, time_s);
  counted.messages += messages;
}

void Bag::clearCounts() {
  for (BagTopic& topic : topics_) topic.messages = 0;
}

bool isBag(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error) ? !partsOf(path).empty() : isBagFile(path);
}

std::unique_ptr<Bag> openBag(const fs::path& path, const std::stop_token& stop) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return openBagFile(path, stop);
  std::vector<std::unique_ptr<Bag>> parts;
  for (const fs::path& part : partsOf(path)) parts.push_back(openBagFile(part, stop));
  if (parts.empty()) {
    throwBadInput(path.string(), "", phrase("no bag in the folder"), ".bag, .mcap, .db3");
  }
  return parts.size() == 1 ? std::move(parts.front()) : joinedBags(path, std::move(parts));
}

}  // namespace handmap
