// Recordings: a folder on disk (recording.json, frames.csv …) or a KITTI odometry sequence folder.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/recording/observation.h"
#include "core/recording/rectifier.h"

namespace handmap {

/// One row of frames.csv. Paths are relative to the folder, empty where there is none.
struct FrameRow {
  int frame = 0;
  double time_s = 0.0;
  std::optional<int> stop;
  double pan = 0.0;  ///< radians
  std::string left;
  std::string right;
  std::string points;  ///< a file, or a part of one: "points/minute-0000.bin@4096+560", bytes
  std::optional<double> right_time_s = {};  ///< where it is not time_s that both were taken at
};

/// How points files are taken that are not as the format says: the axes a b / c d of the plane,
/// then the scale, then the height.
struct PointsReading {
  float xx = 1.0F, xy = 0.0F, yx = 0.0F, yy = 1.0F;
  float scale = 1.0F;    ///< metres a unit of theirs
  float raise_m = 0.0F;  ///< added to z

  RangePoint operator()(const RangePoint& p) const {
    return {scale * (xx * p.x + xy * p.y), scale * (yx * p.x + yy * p.y), scale * p.z + raise_m,
            p.w};
  }
  bool operator==(const PointsReading&) const = default;
};

struct Recording {
  std::filesystem::path folder;
  std::string name;
  double range_limit_m = kUsualReach_m;
  PointsReading points_as;
  std::vector<std::string> strange_keys;       ///< of recording.json: likely misspelt, in words
  std::optional<StereoCamera> camera;          ///< rectified
  std::shared_ptr<const Rectifier> rectifier;  ///< null where the images on disk are rectified
  std::vector<FrameRow> rows;
  Trajectory odometry;  ///< odometry frame; may be empty where only --odometry can give it
  Trajectory truth;     ///< map frame; may be empty
};

/// Reads and checks everything but images and points. Throws BadInput; see throwIfStopped().
Recording openRecording(const std::filesystem::path& folder, const std::stop_token& stop = {});

enum class SourceKind { Auto, Images, Points };

struct ReplayOptions {
  int from = 0;                         ///< first frame number
  std::optional<int> to = {};           ///< last frame number
  int every = 1;                        ///< takes each Nth observation that the chosen kind has
  SourceKind kind = SourceKind::Auto;   ///< Auto: images where there are any, else points
  std::filesystem::path odometry = {};  ///< TUM file instead of the recording's own
  bool visual_odometry = false;         ///< from the images instead: see core/odometry
  bool without_odometry = false;        ///< likewise, from the scans alone: see core/trajectory
};

/// Replays a recording. Rows of one stop make one observation. Throws BadInput when nothing is
/// selected, when there is no odometry, or when it does not cover the selected frames. With
/// `visual_odometry` or `without_odometry` all odometry is left at the origin, for
/// withVisualOdometry() or withScanOdometry() to fill in.
std::unique_ptr<ObservationSource> replay(Recording recording, const ReplayOptions& options);

/// Reads a points file, or the part of one that a row names: little-endian float32 x y z w, or x y
/// z (w = 1). Points that are not finite are left out; no byte is a scan in which nothing came
/// back. Throws BadInput.
std::vector<RangePoint> readPoints(const std::filesystem::path& path);
/// Of a view, with their ids where NAME.ids lies beside NAME.bin: little-endian uint32, one a
/// point.
void readPoints(const std::filesystem::path& path, View& view);

/// Writes this format row by row, so that whatever ends the program leaves a readable recording;
/// what is older than a second is on the disk, whatever ends the machine.
class RecordingWriter {
 public:
  /// Creates the folder. Throws RunFailed when it exists and is not empty.
  RecordingWriter(const std::filesystem::path& folder, const SourceInfo& info);
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// As a replay of what is written gives it: the files round.
  const SourceInfo& info() const;

  /// Appends rows, images (PNG), points (to one file a minute) and the odometry, where there is
  /// one. `truth` where it is known. A view that has neither images nor points leaves no row.
  void add(const Observation& observation, const std::optional<Pose2>& truth = {});

  /// "000012.png", or "000012-3.png" for the third view of a stop.
  static std::string fileName(const Observation& observation, std::size_t view, const char* ending);

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace handmap
