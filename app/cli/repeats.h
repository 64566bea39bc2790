// Messages that come again and again.
#pragma once

#include <map>
#include <string>

namespace handmap {

/// The same message, whatever numbers it has in it, is said three times and then counted.
class Repeats {
 public:
  static constexpr int kSaid = 3;

  /// Whether this one is to be said.
  bool isNews(const std::string& message);
  /// "27 more like: …", a line for each that was counted; they are then forgotten.
  std::string counted();

 private:
  struct Kind {
    std::string first;
    int count = 0;
  };
  std::map<std::string, Kind> kinds_;
};

}  // namespace handmap
