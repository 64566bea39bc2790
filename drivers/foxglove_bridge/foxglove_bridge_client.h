// ROS behind a Foxglove bridge (foxglove.sdk.v1 and foxglove.websocket.v1): it tells the fields of
// what it sends, and sends it as ROS has it.
#pragma once

#include "drivers/rosbridge/ros_client.h"
#include "drivers/rosbridge/ros_schema.h"

namespace handmap {

class FoxgloveBridgeClient : public RosClient {
  Q_OBJECT
 public:
  static constexpr int kPort = 8765;

  /// Whether it is "foxglove://host" or "foxgloves://host", which is encrypted.
  static bool isAddress(const QUrl& url);
  /// Throws BadInput for another one.
  explicit FoxgloveBridgeClient(const QUrl& url, std::uint64_t seed = 1);

  /// To ROS 2 alone.
  void publish(const QString& topic, const QCborMap& message) override;

 private:
  struct Channel {
    std::uint32_t id = 0;
    QString encoding;
    std::string type;
    std::string schema;
  };
  struct Asked {
    QString topic;
    std::uint32_t channel = 0;
    RosSchema schema;
  };
  struct Told {
    std::uint32_t id = 0;
    RosSchema schema;
  };

  void greet() override;
  void ask(const QString& topic, const Subscription& subscription) override;
  void askNoMore(const QString& topic) override;
  void announce(const QString& topic, const Advertised& what) override;
  void take(const QByteArray& message, bool is_text) override;
  QWebSocketHandshakeOptions handshake() const override;
  void takeInfo(const RosValue& info);
  void takeChannels(const RosValue& channels);
  void forgetChannels(const RosValue& ids);
  void takeFrame(const QByteArray& frame);
  void send(const QCborMap& message);

  bool is_informed_ = false;  ///< the server has told what it can
  bool takes_messages_ = false;
  std::uint32_t last_id_ = 0;
  std::map<QString, Channel> channels_;   ///< by topic
  std::map<std::uint32_t, Asked> asked_;  ///< by the subscription's number
  std::map<QString, Told> told_;          ///< by topic
};

}  // namespace handmap
