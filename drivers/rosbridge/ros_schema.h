// The fields of a type of message, out of the text that bridges and bags tell of it (ros1msg,
// ros2msg): between the bytes that ROS sends and values by name.
#pragma once

#include <QCborMap>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bags/bag.h"
#include "drivers/rosbridge/ros_value.h"

namespace handmap {

class RosSchema {
 public:
  /// `type`: "nav_msgs/msg/Odometry" or "nav_msgs/Odometry". Throws BadInput for what is no such
  /// text, for a type that it does not tell, and for one that holds itself.
  RosSchema(std::string type, std::string_view definition, MessageEncoding encoding);
  /// Of the messages of ROS 2 that Handmap itself reads and writes.
  static RosSchema known(const std::string& type);

  /// Numbers in lists become typed arrays of RFC 8746, bytes a byte string. `topic` names the
  /// message. Throws BadInput.
  QCborMap read(std::string_view bytes, const std::string& topic) const;
  /// As CDR (ROS 2), little-endian; what a message does not have is 0 or empty. Throws BadInput.
  std::string write(const RosValue& message) const;

 private:
  enum class Kind { Number, Truth, Text, Time, Message };
  enum class Many { One, Fixed, Any };
  struct Field {
    QString key;
    Kind kind = Kind::Number;
    Many many = Many::One;
    unsigned tag = 0;         ///< Number: as of a typed array
    std::size_t message = 0;  ///< Message: which of them
    std::size_t count = 1;    ///< Fixed
  };
  struct Message {
    std::string type;
    std::vector<Field> fields;
  };
  class Parser;
  class Reading;
  class Writing;

  std::string type_;
  MessageEncoding encoding_;
  std::vector<Message> messages_;  ///< the first is the type's own
};

}  // namespace handmap
