// A connection to a bridge behind which ROS is, shared by all devices that live on it, made again
// when it is lost.
#pragma once

#include <QCborMap>
#include <QObject>
#include <QTimer>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "drivers/device/reconnect.h"
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

class RosClient : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosClient)
 public:
  /// May throw Error: the message is counted as damaged then.
  using Take = std::function<void(const RosValue& message)>;

  ~RosClient() override;

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
  virtual void publish(const QString& topic, const QCborMap& message) = 0;

  RosVersion version() const { return version_; }

 Q_SIGNALS:
  void connected();
  void lost(const QString& why);
  /// A message that could not be read, or that the server was not content with.
  void troubled(const QString& topic, const QString& why);

 protected:
  struct Subscription {
    RosType type;
    Take take;
  };
  struct Advertised {
    RosType type;
    Keep keep;
  };

  /// Throws BadInput for a URL that is not ws:// or wss:// with a host; `expected` names one.
  RosClient(QUrl url, const std::string& expected, RosVersion version, std::uint64_t seed);

  /// A new connection is there. What is asked and told before it is told by connected().
  virtual void greet() = 0;
  virtual void ask(const QString& topic, const Subscription& subscription) = 0;
  virtual void askNoMore(const QString& topic) = 0;
  virtual void announce(const QString& topic, const Advertised& what) = 0;
  /// A message of the server. Throws Error.
  virtual void take(const QByteArray& message, bool is_text) = 0;
  /// What the handshake asks for.
  virtual QWebSocketHandshakeOptions handshake() const { return {}; }

  /// To whoever has subscribed; what cannot be read is told.
  void deliver(const QString& topic, const std::function<RosValue()>& read);
  /// Asks and announces all there is.
  void askAll();
  void sendText(const QByteArray& text);
  void sendBinary(const QByteArray& bytes);

  const std::map<QString, Subscription>& subscriptions() const { return subscriptions_; }
  const std::map<QString, Advertised>& advertised() const { return advertised_; }

 private:
  void attempt();
  void giveUp(const QString& why);
  void letGo();
  void takeGuarded(const QByteArray& message, bool is_text);
  bool takesMore() const;
  void watch();

  QUrl url_;
  RosVersion version_;
  Reconnect reconnect_;
  int users_ = 0;
  QWebSocket* socket_ = nullptr;
  QTimer retry_;
  QTimer watch_;
  qint64 heard_ms_ = 0;
  qint64 pinged_ms_ = 0;
  std::map<QString, Subscription> subscriptions_;
  std::map<QString, Advertised> advertised_;
};

}  // namespace handmap
