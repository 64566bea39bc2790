#include "drivers/rosbridge/ros_devices.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/bags/ros_camera.h"
#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr double kSameMoment_s = 0.005;
constexpr std::size_t kMostWaiting = 4;  // images for their partner

RosType scanType(RosScanner::Kind kind) {
  return {QStringLiteral("sensor_msgs"), kind == RosScanner::Kind::LaserScan
                                             ? QStringLiteral("LaserScan")
                                             : QStringLiteral("PointCloud2")};
}

QString cameraInfoTopic(const QString& images) {
  return QString::fromStdString(ros::cameraInfoTopic(images.toStdString()));
}

}  // namespace

RosOdometry::RosOdometry(std::shared_ptr<RosClient> client, const QString& topic, QString look,
                         RigClock clock)
    : client_(client),
      look_(std::move(look)),
      topic_(std::move(client), topic, {QStringLiteral("nav_msgs"), QStringLiteral("Odometry")},
             std::move(clock), [this](const RosValue& message, double arrival_s) {
               const RosOdometryMessage read = readOdometry(message);
               const auto told = stream_.take(read.stamp_s, read.pose, arrival_s);
               if (told) {
                 nameFrames(read);
                 Q_EMIT stamped(told->time_s, read.stamp_s);
                 Q_EMIT moved(told->time_s, told->pose);
               }
               return stream_.detail();
             }) {
  connect(&topic_, &RosTopic::stateChanged, this, &Device::stateChanged);
}

void RosOdometry::nameFrames(const RosOdometryMessage& read) {
  OdometryFrames frames;
  if (!read.frame.empty()) frames.odometry = read.frame;
  if (!read.base.empty()) frames.base = read.base;
  frames.origin = stream_.origin();
  if (frames_ == frames) return;
  frames_ = frames;
  Q_EMIT framed(frames);
}

RosOdometry::~RosOdometry() {
  if (!look_.isEmpty()) client_->unsubscribe(look_);
}

void RosOdometry::open() {
  if (!look_.isEmpty()) {
    client_->subscribe(look_, {QStringLiteral("std_msgs"), QStringLiteral("Empty")},
                       [this](const RosValue&) { Q_EMIT lookAsked(); });
  }
  topic_.open();
}

void RosOdometry::close() {
  if (!look_.isEmpty()) client_->unsubscribe(look_);
  topic_.close();
}

RosScanner::RosScanner(std::shared_ptr<RosClient> client, const QString& topic, Kind kind,
                       RigClock clock)
    : topic_(std::move(client), topic, scanType(kind), std::move(clock),
             [this, kind](const RosValue& message, double arrival_s) {
               const RosPointsMessage read =
                   kind == Kind::LaserScan ? readLaserScan(message) : readPointCloud(message);
               const auto time_s = offset_.rigTime(read.stamp_s, arrival_s);
               if (time_s) {
                 if (read.reach_m) Q_EMIT reaches(*read.reach_m);
                 Q_EMIT stamped(*time_s, read.stamp_s);
                 Q_EMIT scanned(*time_s, read.points);
               }
               return QString();
             }) {
  connect(&topic_, &RosTopic::stateChanged, this, &Device::stateChanged);
}

RosCamera::RosCamera(std::shared_ptr<RosClient> client, const QString& left, const QString& right,
                     RigClock clock, Calibration calibration)
    : client_(client),
      infos_{{{cameraInfoTopic(left), {}, {}}, {cameraInfoTopic(right), {}, {}}}},
      are_rectified_(ros::namesRectified(left.toStdString())),
      is_described_(calibration == Calibration::OfRig),
      left_(client, left, {QStringLiteral("sensor_msgs"), QStringLiteral("CompressedImage")}, clock,
            [this](const RosValue& message, double arrival_s) {
              return take(left_images_, right_images_, message, arrival_s);
            }),
      right_(std::move(client), right,
             {QStringLiteral("sensor_msgs"), QStringLiteral("CompressedImage")}, std::move(clock),
             [this](const RosValue& message, double arrival_s) {
               return take(right_images_, left_images_, message, arrival_s);
             }) {
  connect(&left_, &RosTopic::stateChanged, this, [this](DeviceState state, const QString& detail) {
    left_state_.changes(state, detail);
    left_detail_ = detail;
    tell();
  });
  connect(&right_, &RosTopic::stateChanged, this, [this](DeviceState state, const QString& detail) {
    right_state_.changes(state, detail);
    right_detail_ = detail;
    tell();
  });
  connect(client_.get(), &RosClient::troubled, this,
          [this](const QString& about, const QString& why) {
            for (Info& info : infos_) {
              if (info.topic == about) info.trouble = why;
            }
          });
}

RosCamera::~RosCamera() { askNoMore(); }

void RosCamera::open() {
  if (!is_described_) askInfos();
  left_.open();
  right_.open();
}

void RosCamera::close() {
  askNoMore();
  left_.close();
  right_.close();
}

void RosCamera::askInfos() {
  for (Info& info : infos_) {
    client_->subscribe(info.topic, {QStringLiteral("sensor_msgs"), QStringLiteral("CameraInfo")},
                       [this, &info](const RosValue& message) {
                         info.told = readCameraInfo(message);
                         describe();
                       });
  }
}

void RosCamera::askNoMore() {
  for (const Info& info : infos_) client_->unsubscribe(info.topic);
}

void RosCamera::describe() {
  if (is_described_ || !infos_[0].told || !infos_[1].told) return;
  const auto rectifier = std::make_shared<const Rectifier>(ros::rectifierOf(
      *infos_[0].told, *infos_[1].told, are_rectified_, infos_[0].topic.toStdString()));
  is_described_ = true;
  askNoMore();
  Q_EMIT described(rectifier);
}

/// What is not known of the cameras; empty where all is.
QString RosCamera::lacking() const {
  if (is_described_) return {};
  for (const Info& info : infos_) {
    if (!info.trouble.isEmpty()) return info.trouble;
    if (info.told) continue;
    return qPhrase("nothing has come of {}, and the rig names no calibration",
                   info.topic.toStdString());
  }
  return {};
}

QString RosCamera::take(Images& own, Images& other, const RosValue& message, double arrival_s) {
  RosImageMessage image = readImage(message);
  while (!other.empty() && other.front().stamp_s < image.stamp_s - kSameMoment_s) {
    other.pop_front();
    ++unpaired_;
  }
  if (other.empty() || other.front().stamp_s > image.stamp_s + kSameMoment_s) {
    own.push_back(std::move(image));
    if (own.size() <= kMostWaiting) return lacking();
    own.pop_front();
    ++unpaired_;
    return qPhrase("the images of one camera find no partner of the same moment");
  }
  const RosImageMessage partner = std::move(other.front());
  other.pop_front();
  const RosImageMessage& left = &own == &left_images_ ? image : partner;
  const RosImageMessage& right = &own == &left_images_ ? partner : image;
  const auto time_s = offset_.rigTime(left.stamp_s, arrival_s);
  if (time_s) {
    Q_EMIT stamped(*time_s, left.stamp_s);
    Q_EMIT pairTaken(*time_s, left.image, right.image);
  }
  return lacking();
}

// As bad as the worse of the two.
void RosCamera::tell() {
  const auto rank = [](DeviceState state) {
    constexpr DeviceState kOrder[] = {DeviceState::Ready, DeviceState::Degraded,
                                      DeviceState::Connecting, DeviceState::Lost,
                                      DeviceState::Closed};
    return std::find(std::begin(kOrder), std::end(kOrder), state) - std::begin(kOrder);
  };
  const bool left_worse = rank(left_state_.state()) >= rank(right_state_.state());
  Q_EMIT stateChanged(left_worse ? left_state_.state() : right_state_.state(),
                      left_worse ? left_detail_ : right_detail_);
}

}  // namespace handmap
