#include "core/recording/validation.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/recording/view_reader.h"

namespace handmap {

std::vector<std::string> problemsOf(const Recording& recording) {
  std::vector<std::string> problems;
  ViewReader reader(recording);
  for (const FrameRow& row : recording.rows) {
    const auto check = [&](auto read) {
      try {
        View view;
        read(view);
      } catch (const Error& error) {
        problems.push_back(fmt::format("frame {}: {}", row.frame, error.what()));
      }
    };
    if (!row.left.empty()) check([&](View& view) { reader.readImages(row, view); });
    if (!row.points.empty()) check([&](View& view) { reader.readPoints(row, view); });
    if (!recording.odometry.empty() && !recording.odometry.at(row.time_s)) {
      problems.push_back(fmt::format("frame {}: no odometry at {} s", row.frame, row.time_s));
    }
  }
  return problems;
}

}  // namespace handmap
