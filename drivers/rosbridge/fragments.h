// Messages that a rosbridge sent in pieces.
#pragma once

#include <QByteArray>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "drivers/rosbridge/ros_value.h"

namespace handmap {

/// At most eight messages are under way; a ninth takes the place of the oldest. What is kept stays
/// below the limit in all.
class Fragments {
 public:
  explicit Fragments(qsizetype most_bytes = 32 << 20) : most_bytes_(most_bytes) {}

  /// The whole message when `fragment` (op "fragment": id, num, total, data) was its last piece.
  /// Throws BadInput.
  std::optional<QByteArray> add(const RosValue& fragment);
  int abandoned() const { return abandoned_; }

 private:
  struct Message {
    std::string id;
    std::vector<std::optional<QByteArray>> pieces;
    std::size_t missing = 0;
    qsizetype bytes = 0;
  };
  Message& messageOf(const std::string& id, std::size_t total);

  qsizetype most_bytes_;
  std::list<Message> messages_;  ///< the oldest first
  int abandoned_ = 0;
};

}  // namespace handmap
