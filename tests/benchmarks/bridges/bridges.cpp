// What a bridge to ROS costs: stereo pairs of 1280 × 720 at 30 Hz for SECONDS (10) over each, from
// an emulated one in a process of its own; prints how many pairs came and the processor time of
// this process, in percent of a core.
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <memory>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/rig/rig_clock.h"
#include "drivers/emulators/foxglove_bridge_emulator.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/foxglove_bridge/foxglove_bridge_client.h"
#include "drivers/rosbridge/ros_devices.h"
#include "drivers/rosbridge/rosbridge_client.h"

namespace handmap {
namespace {

const QString kLeft = QStringLiteral("/left");
const QString kRight = QStringLiteral("/right");
constexpr double kRate_hz = 30.0;

cv::Mat street() {
  cv::Mat image(720, 1280, CV_8UC1);
  cv::randu(image, 0, 255);
  cv::GaussianBlur(image, image, {}, 4.0);
  cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  return image;
}

QCborMap jpeg(double stamp_s, const cv::Mat& image) {
  std::vector<unsigned char> file;
  cv::imencode(".jpg", image, file);
  return emulated::compressedImage(
      stamp_s, {reinterpret_cast<const char*>(file.data()), static_cast<qsizetype>(file.size())},
      RosVersion::Ros2);
}

/// Sends until it is ended; says where it listens, then how much it has sent at each pair.
template <typename Bridge>
int serve(Bridge& bridge, bool is_plain) {
  std::printf("%s\n", qPrintable(bridge.url().toString()));
  std::fflush(stdout);
  const cv::Mat image = street();
  const RigClock clock = startedRigClock();
  QCborMap message = is_plain ? emulated::image(0.0, image, RosVersion::Ros2) : jpeg(0.0, image);
  QTimer timer;
  timer.setTimerType(Qt::PreciseTimer);
  int sent = 0;
  QObject::connect(&timer, &QTimer::timeout, &bridge, [&] {
    if (!bridge.hasSubscriber(kRight)) return;
    if (sent < clock() * kRate_hz) {
      QCborMap header = emulated::odometry(1.7e9 + sent / kRate_hz, {}, RosVersion::Ros2);
      message[QLatin1String("header")] = header.take(QLatin1String("header"));
      bridge.publish(kLeft, message);
      bridge.publish(kRight, message);
      ++sent;
    }
  });
  timer.start(5);
  return QCoreApplication::exec();
}

int serve(const QString& kind) {
  const bool is_plain = kind.endsWith(QLatin1String("plain"));
  if (!kind.startsWith(QLatin1String("foxglove"))) {
    RosbridgeEmulator bridge;
    return serve(bridge, is_plain);
  }
  FoxgloveBridgeEmulator bridge;
  for (const QString& topic : {kLeft, kRight}) {
    bridge.offer(topic, is_plain ? "sensor_msgs/msg/Image" : "sensor_msgs/msg/CompressedImage");
  }
  return serve(bridge, is_plain);
}

std::shared_ptr<RosClient> clientOf(const QString& kind, const QUrl& url) {
  if (kind.startsWith(QLatin1String("foxglove")))
    return std::make_shared<FoxgloveBridgeClient>(url);
  const auto form = kind.contains(QLatin1String("json"))   ? RosbridgeForm::Json
                    : kind.contains(QLatin1String("cbor")) ? RosbridgeForm::Cbor
                                                           : RosbridgeForm::Raw;
  return std::make_shared<RosbridgeClient>(RosbridgeOptions{url, RosVersion::Ros2, form});
}

void measure(const QString& kind, int seconds) {
  QProcess server;
  server.start(QCoreApplication::applicationFilePath(), {QStringLiteral("serve"), kind});
  server.waitForReadyRead();
  const QUrl url(QString::fromUtf8(server.readLine().trimmed()));
  RosCamera camera(clientOf(kind, url), kLeft, kRight, startedRigClock());
  int pairs = 0;
  double last_s = 0.0;
  int missed = 0;
  QObject::connect(&camera, &Device::stamped, &camera, [&](double, double stamp_s) {
    if (last_s > 0.0 && stamp_s - last_s > 1.5 / kRate_hz) ++missed;
    last_s = stamp_s;
    ++pairs;
  });
  camera.open();
  while (pairs < 10) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  const std::clock_t begin = std::clock();
  const int before = pairs;
  QElapsedTimer clock;
  clock.start();
  QTimer::singleShot(1000 * seconds, &camera, &QCoreApplication::quit);
  QCoreApplication::exec();  // sleeps where there is nothing to do
  const double wall_s = 1e-3 * static_cast<double>(clock.elapsed());
  const double used_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("%-16s %5.1f pairs/s, %d gaps, %d without partner, %5.1f %% of a core\n",
              qPrintable(kind), (pairs - before) / wall_s, missed, camera.unpaired(),
              100.0 * used_s / wall_s);
  std::fflush(stdout);
  camera.close();
  server.kill();
  server.waitForFinished();
}

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.value(1) == QLatin1String("serve")) return handmap::serve(arguments.value(2));
  const int seconds = arguments.value(1, QStringLiteral("10")).toInt();
  for (const char* kind :
       {"rosbridge-json", "rosbridge-cbor", "rosbridge-raw", "foxglove", "foxglove-plain"}) {
    handmap::measure(QString::fromLatin1(kind), seconds);
  }
  return 0;
}
