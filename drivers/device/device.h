// The devices of a rig: they come, go and come back while a run goes on. All live in the thread of
// the rig, which has an event loop; none blocks it.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/pose2.h"
#include "core/recording/observation.h"
#include "core/recording/rectifier.h"
#include "core/rig/device_state.h"
#include "core/rig/odometry_frames.h"

namespace handmap {

class Device : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Returns at once. Tries, and tries again when it was lost, until close().
  virtual void open() = 0;
  /// Leaves the hardware at rest: the head stands, the laser is off.
  virtual void close() = 0;

 Q_SIGNALS:
  /// `detail`: plain words for a person, never those of a parser alone.
  void stateChanged(handmap::DeviceState state, const QString& detail);
  /// What it tells next was measured at `time_s` of the rig, which the robot's own clock, seconds
  /// since 1970, called `stamp_s`.
  void stamped(double time_s, double stamp_s);
};

// Times are seconds of the rig's clock (steady, 0 when the rig began) at which it was measured.

class OdometrySensor : public Device {
  Q_OBJECT
 public:
  using Device::Device;
 Q_SIGNALS:
  /// In the odometry frame.
  void moved(double time_s, const handmap::Pose2& pose);
  /// Whenever it changes, before what is moved() in it.
  void framed(const handmap::OdometryFrames& frames);
  /// The robot stands, and asks its head to look around.
  void lookAsked();
};

class RangeSensor : public Device {
  Q_OBJECT
 public:
  using Device::Device;
 Q_SIGNALS:
  /// In the sensor's frame: x forward, y left, z up, origin at the sensor.
  void scanned(double time_s, const std::vector<handmap::RangePoint>& points);
  /// By the scanner's own word, before its first scan: it measures nothing farther.
  void reaches(double range_m);
};

class PairCamera : public Device {
  Q_OBJECT
 public:
  using Device::Device;
 Q_SIGNALS:
  /// By its own word, once and maybe late: how its pairs are rectified, and the camera behind them.
  void described(const std::shared_ptr<const handmap::Rectifier>& rectifier);
  /// Taken at the same moment; as the camera gives them, before any rectification.
  void pairTaken(double time_s, const cv::Mat& left, const cv::Mat& right);
};

class PanTiltHead : public Device {
  Q_OBJECT
 public:
  using Device::Device;
  /// Radians, positive to the left and up. Beyond the limits of the head: as far as they allow.
  virtual void lookAt(double pan, double tilt) = 0;
  /// At once, wherever it is.
  virtual void halt() = 0;
 Q_SIGNALS:
  /// It stands there, by its own word.
  void arrived(double pan, double tilt);
};

}  // namespace handmap
