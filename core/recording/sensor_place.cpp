#include "core/recording/sensor_place.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"

namespace handmap {

Eigen::Isometry3d parseSensorPlace(std::string_view text) {
  constexpr double kMost_m = 50.0;
  constexpr double kMostTurn_deg = 360.0;
  std::vector<double> numbers;
  bool is_good = true;
  for (const std::string_view field : splitFields(text, ',')) {
    const auto number = parseFinite(field);
    const double most = numbers.size() < 3 ? kMost_m : kMostTurn_deg;
    is_good = is_good && number && std::abs(*number) <= most;
    numbers.push_back(number.value_or(0.0));
  }
  if (!is_good || (numbers.size() != 3 && numbers.size() != 4)) {
    throw Error(ErrorCode::Usage,
                phrase("--sensor: found \"{}\", expected X,Y,Z in metres and perhaps a turn to the "
                       "left in degrees",
                       text));
  }
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() << numbers[0], numbers[1], numbers[2];
  if (numbers.size() == 4) {
    place.rotate(Eigen::AngleAxisd(toRadians(numbers[3]), Eigen::Vector3d::UnitZ()));
  }
  return place;
}

std::vector<RangePoint> placedOn(const Eigen::Isometry3d& sensor, std::vector<RangePoint> points) {
  const Eigen::Isometry3f pose = sensor.cast<float>();
  for (RangePoint& p : points) {
    const Eigen::Vector3f at(p.x, p.y, p.z);
    const Eigen::Vector3f moved = pose * at;
    if (isMeasured(p)) {
      p = {moved.x(), moved.y(), moved.z(), p.w};
    } else {  // a direction, seen from the robot as from the scanner
      const Eigen::Vector3f turned = pose.linear() * at;
      p = notMeasured(std::atan2(turned.y(), turned.x()), moved.z());
    }
  }
  return points;
}

}  // namespace handmap
