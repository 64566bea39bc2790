// ROS behind a rosbridge server (protocol 2).
#pragma once

#include "drivers/rosbridge/fragments.h"
#include "drivers/rosbridge/ros_client.h"
#include "drivers/rosbridge/ros_schema.h"

namespace handmap {

/// As what messages are asked for; all are understood. Raw: as ROS 2 has them, in CBOR: nobody
/// takes them apart but we.
enum class RosbridgeForm { Json, Cbor, Raw };

struct RosbridgeOptions {
  QUrl url;  ///< ws://host:9090
  RosVersion ros = RosVersion::Ros2;
  RosbridgeForm form = RosbridgeForm::Raw;
};

/// Asks for raw messages, and where the server does not know them, for CBOR.
class RosbridgeClient : public RosClient {
  Q_OBJECT
 public:
  /// Throws BadInput for a URL that is not ws:// or wss:// with a host.
  explicit RosbridgeClient(RosbridgeOptions options, std::uint64_t seed = 1);

  void publish(const QString& topic, const QCborMap& message) override;

 private:
  void greet() override;
  void ask(const QString& topic, const Subscription& subscription) override;
  void askNoMore(const QString& topic) override;
  void announce(const QString& topic, const Advertised& what) override;
  void take(const QByteArray& message, bool is_text) override;
  void takeMessage(const QCborMap& message, bool is_text);
  RosValue messageOf(const QCborMap& message, const QString& topic);
  void askForLess();
  void send(const QCborMap& message);

  RosbridgeForm wanted_;
  RosbridgeForm form_;  ///< of this connection
  Fragments fragments_;
  std::map<QString, RosSchema> schemas_;  ///< by topic
};

}  // namespace handmap
