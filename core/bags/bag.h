// Bags: what robots that run ROS record. ROS 1 (.bag), ROS 2 (.mcap, .db3, or the folder of such).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/bags/field_reader.h"

namespace handmap {

enum class MessageEncoding { Ros1, Cdr, Other };

struct BagTopic {
  std::string name;
  std::string type;  ///< "sensor_msgs/LaserScan", of ROS 2, too
  MessageEncoding encoding = MessageEncoding::Other;
  std::size_t messages = 0;
  double first_s = 0.0;  ///< when they were recorded
  double last_s = 0.0;
};

struct BagMessage {
  std::size_t topic = 0;
  double time_s = 0.0;     ///< when it was recorded
  std::string_view bytes;  ///< until the next one
};

/// Of what is in a file that was cut off, all that is whole is given.
class Bag {
 public:
  using Take = std::function<void(const BagMessage&)>;

  virtual ~Bag() = default;
  const std::filesystem::path& path() const { return path_; }
  /// "ROS 1 bag", "MCAP", "ROS 2 bag (SQLite)"
  const std::string& kind() const { return kind_; }
  const std::vector<BagTopic>& topics() const { return topics_; }
  const std::vector<std::string>& notes() const { return notes_; }

  /// In the order of the file: the messages of the topics that are wanted. Throws BadInput.
  virtual void read(const std::vector<bool>& wanted, const Take& take,
                    const std::stop_token& stop) const = 0;

  /// The fields of a message of a topic. Throws BadInput for one that is in no encoding of ROS.
  FieldReader fieldsOf(const BagMessage& message) const;

 protected:
  Bag(std::filesystem::path path, std::string kind)
      : path_(std::move(path)), kind_(std::move(kind)) {}
  /// The topic of that name and type, new where there is none. Throws BadInput beyond 100,000.
  std::size_t topicOf(const std::string& name, std::string type, MessageEncoding encoding);
  void count(std::size_t topic, double time_s, std::size_t messages = 1);
  void note(std::string text) { notes_.push_back(std::move(text)); }
  void clearCounts();

 private:
  std::filesystem::path path_;
  std::string kind_;
  std::vector<BagTopic> topics_;
  std::vector<std::string> notes_;
};

/// By its ending, or the files in a folder.
bool isBag(const std::filesystem::path& path);
/// Lists what is in it; of packed parts only what their index does not tell is unpacked. Throws
/// BadInput.
std::unique_ptr<Bag> openBag(const std::filesystem::path& path, const std::stop_token& stop = {});

}  // namespace handmap
