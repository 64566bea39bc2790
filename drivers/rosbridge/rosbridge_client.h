// A connection to a rosbridge server (protocol 2), shared by all devices that live on it, made
// again when it is lost.
#pragma once

#include <QCborMap>
#include <QObject>
#include <QTimer>
#include <QUrl>
#include <QWebSocket>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "drivers/device/reconnect.h"
#include "drivers/rosbridge/fragments.h"
#include "drivers/rosbridge/ros_value.h"

namespace handmap {

enum class RosVersion { Ros1, Ros2 };

/// "nav_msgs", "Odometry": nav_msgs/Odometry in ROS 1, nav_msgs/msg/Odometry in ROS 2.
struct RosType {
  QString package;
  QString name;
  QString of(RosVersion version) const {
    return package + (version == RosVersion::Ros1 ? "/" : "/msg/") + name;
  }
};

struct RosbridgeOptions {
  QUrl url;  ///< ws://host:9090
  RosVersion ros = RosVersion::Ros2;
  bool cbor = true;  ///< asks for CBOR, a third of JSON's size; both are understood
};

class RosbridgeClient : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosbridgeClient)
 public:
  /// May throw Error: the message is counted as damaged then.
  using Take = std::function<void(const RosValue& message)>;

  /// Throws BadInput for a URL that is not ws:// or wss:// with a host.
  explicit RosbridgeClient(RosbridgeOptions options, std::uint64_t seed = 1);
  ~RosbridgeClient() override;

  /// Each user opens and closes once; the last one closes the connection.
  void open();
  void close();
  bool isConnected() const;

  /// Of one topic one subscriber.
  void subscribe(const QString& topic, const RosType& type, Take take);
  void unsubscribe(const QString& topic);
  /// Keep::Last: who subscribes later gets the last one ("latched", "transient local").
  enum class Keep { Nothing, Last };
  void advertise(const QString& topic, const RosType& type, Keep keep = Keep::Nothing);
  /// Dropped while there is no connection, or when it does not take what is sent.
  void publish(const QString& topic, const QCborMap& message);

  RosVersion version() const { return options_.ros; }

 Q_SIGNALS:
  void connected();
  void lost(const QString& why);
  /// A message that could not be read, or that the server was not content with.
  void troubled(const QString& topic, const QString& why);

 private:
  struct Subscription {
    RosType type;
    Take take;
  };
  void attempt();
  void greet();
  void giveUp(const QString& why);
  void letGo();
  void takeText(const QString& text);
  void takeBinary(const QByteArray& bytes);
  void take(const QCborMap& message);
  template <typename Read>
  void guarded(Read read);
  void send(const QCborMap& message);
  void sendSubscribe(const QString& topic, const Subscription& subscription);
  void watch();

  RosbridgeOptions options_;
  Reconnect reconnect_;
  int users_ = 0;
  QWebSocket* socket_ = nullptr;
  QTimer retry_;
  QTimer watch_;
  qint64 heard_ms_ = 0;
  qint64 pinged_ms_ = 0;
  Fragments fragments_;
  std::map<QString, Subscription> subscriptions_;
  struct Advertised {
    RosType type;
    Keep keep;
  };
  std::map<QString, Advertised> advertised_;
};

}  // namespace handmap
