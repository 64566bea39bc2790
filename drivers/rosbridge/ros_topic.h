// One topic that a device lives on: what it sends, and how well it is.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "core/rig/rig_clock.h"
#include "drivers/device/device.h"
#include "drivers/device/health.h"
#include "drivers/device/told_state.h"
#include "drivers/rosbridge/ros_client.h"

namespace handmap {

class RosTopic : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosTopic)
 public:
  /// What comes; throws Error for what cannot be used. Returns a remark, empty where all is well.
  using Take = std::function<QString(const RosValue& message, double arrival_s)>;

  RosTopic(std::shared_ptr<RosClient> client, QString topic, RosType type, RigClock clock,
           Take take);
  ~RosTopic() override;
  void open();
  void close();

 Q_SIGNALS:
  void stateChanged(handmap::DeviceState state, const QString& detail);

 private:
  void awaitFirst();
  void come(const RosValue& message);
  void watch();
  void tell(DeviceState state, const QString& detail);

  std::shared_ptr<RosClient> client_;
  QString topic_;
  RosType type_;
  RigClock clock_;
  Take take_;
  QTimer timer_;
  Health health_;
  bool heard_ = false;   ///< since it was connected
  double last_s_ = 0.0;  ///< when something came, or it was connected
  bool open_ = false;
  ToldState told_;
};

}  // namespace handmap
