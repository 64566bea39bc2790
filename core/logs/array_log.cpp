#include "core/logs/array_log.h"

#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/logs/raw_scans.h"

namespace handmap {

namespace {

struct ArrayNames {
  const char* role;
  std::vector<std::string_view> names;
};

const std::vector<ArrayNames>& arrayNames() {
  static const std::vector<ArrayNames> kNames{
      {"ranges", {"ranges", "scans", "scan", "lidar", "laser", "lasers", "range"}},
      {"points", {"points", "clouds", "xyz", "pointclouds"}},
      {"time", {"times", "time", "timestamps", "timestamp", "t", "stamps", "time_s"}},
      {"poses", {"poses", "odometry", "odom", "pose", "trajectory"}},
      {"angles", {"angles", "angle", "bearings", "bearing"}}};
  return kNames;
}

class ArrayLog {
 public:
  ArrayLog(const std::map<std::string, Array>& arrays, std::string file, const LogOptions& options)
      : arrays_(arrays), options_(options) {
    raw_.file = std::move(file);
    for (const auto& [role, names] : arrayNames()) find(role, names);
    if (arrays_.size() == 1 && roles_.empty()) {
      const Array& only = arrays_.begin()->second;
      roles_[only.shape.size() == 3 ? "points" : "ranges"] = &only;
    }
  }

  RawLog read() {
    const Array* ranges = of("ranges");
    const Array* points = of("points");
    const Array* poses = of("poses");
    if (!ranges && !points && !poses) ask();
    if (ranges) {
      readRanges(*ranges);
    } else if (points) {
      readPoints(*points);
    }
    if (poses) readPoses(*poses);
    return std::move(raw_);
  }

 private:
  void find(const char* role, const std::vector<std::string_view>& names) {
    const auto told = options_.columns.find(role);
    for (const auto& [name, array] : arrays_) {
      const bool is_it = told != options_.columns.end()
                             ? told->second == name
                             : std::ranges::find(names, name) != names.end();
      if (is_it) roles_[role] = &array;
    }
  }

  const Array* of(const std::string& role) const {
    const auto found = roles_.find(role);
    return found == roles_.end() ? nullptr : found->second;
  }

  [[noreturn]] void ask() const {
    std::string names;
    for (const auto& [name, array] : arrays_) names += (names.empty() ? "" : " ") + name;
    throw Question("columns",
                   phrase("{}: found the arrays {}, expected to know which hold what", raw_.file,
                          names.empty() ? phrase("none") : names),
                   phrase("ROLE=ARRAY,… of ranges, points, time, poses, angles"));
  }

  [[noreturn]] void failShape(const std::string& role, const Array& array,
                              const std::string& expected) const {
    std::string shape;
    for (const std::size_t extent : array.shape) {
      shape += fmt::format("{}{}", shape.empty() ? "" : " x ", extent);
    }
    throwBadInput(raw_.file, role, phrase("an array of {}", shape), expected);
  }

  double time(std::size_t i, std::size_t count) const {
    if (const Array* times = of("time")) {
      if (times->values.size() != count) failShape("time", *times, phrase("{} times", count));
      return times->values[i];
    }
    if (options_.rate_hz) return static_cast<double>(i) / *options_.rate_hz;
    throw Question("rate", phrase("{}: found no times, expected an array of them", raw_.file),
                   phrase("how many scans a second there are"));
  }

  void readRanges(const Array& ranges) {
    if (ranges.shape.size() != 2) failShape("ranges", ranges, phrase("scans x ranges"));
    const std::size_t width = ranges.shape[1];
    if (const Array* angles = of("angles"); angles && angles->values.size() > 1) {
      if (angles->values.size() != width) {
        failShape("angles", *angles, phrase("{}, one for each range", width));
      }
      raw_.angles =
          RayAngles{angles->values.front(), (angles->values.back() - angles->values.front()) /
                                                static_cast<double>(width - 1)};
    }
    for (std::size_t i = 0; i < ranges.rows(); ++i) {
      const auto begin = ranges.values.begin() + static_cast<std::ptrdiff_t>(i * width);
      raw_.scans.push_back(
          {time(i, ranges.rows()), {begin, begin + static_cast<std::ptrdiff_t>(width)}, {}});
    }
  }

  void readPoints(const Array& points) {
    if (points.shape.size() != 3 || points.shape[2] < 2 || points.shape[2] > 4) {
      failShape("points", points, phrase("scans x points x 2 to 4 (x y z w)"));
    }
    const std::size_t width = points.shape[2];
    for (std::size_t i = 0; i < points.rows(); ++i) {
      RawScan& scan = raw_.scans.emplace_back();
      scan.time = time(i, points.rows());
      for (std::size_t j = 0; j < points.shape[1]; ++j) {
        const double* p = points.values.data() + (i * points.shape[1] + j) * width;
        const auto weight =
            width == 4 && p[3] >= 0.0 && p[3] <= 1.0 ? static_cast<float>(p[3]) : 1.0F;
        scan.points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]),
                               width > 2 ? static_cast<float>(p[2]) : 0.0F, weight});
      }
    }
  }

  void readPoses(const Array& poses) {
    const std::size_t width = poses.shape.size() == 2 ? poses.shape[1] : 0;
    if (width != 3 && width != 4 && width != 8) {
      failShape(
          "poses", poses,
          phrase("N x 3 (x y heading), N x 4 (time first) or N x 8 (time x y z qx qy qz qw)"));
    }
    for (std::size_t i = 0; i < poses.rows(); ++i) {
      const double* p = poses.values.data() + i * width;
      if (width == 3) {
        raw_.poses.push_back({time(i, poses.rows()), p[0], p[1], p[2]});
      } else if (width == 4) {
        raw_.poses.push_back({p[0], p[1], p[2], p[3]});
      } else {
        const double heading = std::atan2(2.0 * (p[7] * p[6] + p[4] * p[5]),
                                          p[7] * p[7] + p[4] * p[4] - p[5] * p[5] - p[6] * p[6]);
        raw_.poses.push_back({p[0], p[1], p[2], heading});
      }
    }
  }

  const std::map<std::string, Array>& arrays_;
  const LogOptions& options_;
  std::map<std::string, const Array*> roles_;
  RawLog raw_;
};

}  // namespace

void addArrays(const std::map<std::string, Array>& arrays, const std::string& file,
               const LogOptions& options, Log& log) {
  addRaw(ArrayLog(arrays, file, options).read(), options, log);
}

}  // namespace handmap
