// Logs of other programs: scans and poses, read as what they are likely meant.
//
// A file is one of: a CARMEN log; a table with a header (a row a scan of ranges, a row a point, or
// a row a pose); poses in TUM form; an array or arrays of numpy (.npy, .npz). What cannot be seen
// in it is asked for: see Question.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/recording/observation.h"

namespace handmap {

/// Directions of the ranges of a scan, radians, counter-clockwise from ahead.
struct RayAngles {
  double first = 0.0;
  double step = 0.0;
};

/// What a person says about a log; absent: as it looks.
struct LogOptions {
  /// Role → column: its name, its number from 1, or "A-B". Roles: time scan x y z w heading qx qy
  /// qz qw ranges; of arrays also angles points poses.
  std::map<std::string, std::string> columns = {};
  std::optional<double> metres = {};   ///< a unit of length
  std::optional<double> seconds = {};  ///< a unit of time
  std::optional<double> radians = {};  ///< a unit of angle
  std::optional<RayAngles> angles = {};
  std::optional<double> rate_hz = {};            ///< where there are no times
  std::optional<double> most_range_m = {};       ///< nothing came back from there on
  std::optional<Eigen::Isometry3d> sensor = {};  ///< on the robot; absent: its origin
};

/// "time=1,ranges=2-362". Throws Usage.
void setColumns(std::string_view text, LogOptions& options);
/// "-90:0.5", degrees. Throws Usage.
void setAngles(std::string_view text, LogOptions& options);

struct LoggedScan {
  double time_s = 0.0;
  std::vector<RangePoint> points;
};

struct Log {
  std::vector<LoggedScan> scans;
  std::vector<StampedPose> poses;
  std::optional<double> reach_m = {};   ///< of the sensor
  std::vector<std::string> notes = {};  ///< what was taken for what, and left out; a line each
};

/// Thrown where a log does not tell something and nobody said it.
class Question : public Error {
 public:
  /// `option`: that of the command line, without "--". `text`: what to say there.
  Question(std::string option, const std::string& message, const std::string& text)
      : Error(ErrorCode::BadInput, message, "--" + option + ": " + text),
        option_(std::move(option)),
        text_(text) {}
  const std::string& option() const { return option_; }
  const std::string& text() const { return text_; }

 private:
  std::string option_;
  std::string text_;
};

/// Of the files together, e.g. scans and a table of poses. Throws BadInput, or a Question.
Log readLogs(const std::vector<std::filesystem::path>& files, const LogOptions& options,
             const std::stop_token& stop = {});

/// Makes a recording of it in a new folder. Scans that no pose is known for are left out, and told;
/// without any pose there is no odometry. Gives how many scans it has. Throws BadInput where there
/// is no scan, RunFailed as RecordingWriter does.
std::size_t writeLog(const Log& log, const std::filesystem::path& folder, std::string name,
                     std::vector<std::string>& notes);

}  // namespace handmap
