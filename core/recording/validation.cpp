#include "core/recording/validation.h"

#include <algorithm>

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
  const auto& rows = recording.rows;
  const bool has_images =
      std::any_of(rows.begin(), rows.end(), [](const FrameRow& row) { return !row.left.empty(); });
  if (recording.odometry.empty() && !has_images) {  // images tell the motion, too
    problems.push_back(recording.folder.string() + ": no odometry");
  }
  return problems;
}

}  // namespace handmap
