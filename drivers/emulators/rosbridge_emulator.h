// A rosbridge server that is not one: it passes messages between its clients, on the loopback.
#pragma once

#include <QCborMap>
#include <QHash>
#include <QObject>
#include <QSet>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketServer>
#include <map>

#include "drivers/rosbridge/rosbridge_client.h"

namespace handmap {

class RosbridgeEmulator : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RosbridgeEmulator)
 public:
  /// Listens. Throws RunFailed.
  RosbridgeEmulator();
  ~RosbridgeEmulator() override;

  QUrl url() const;  ///< the same after every plug()
  void plug();
  void unplug();

  /// To whoever has subscribed. JSON has no typed arrays: they become lists, bytes become base64.
  void publish(const QString& topic, const QCborMap& message);
  /// As it is, to all: for what no rosbridge should send.
  void sendRaw(const QByteArray& bytes, bool binary);
  /// Messages in JSON come in pieces of so many bytes; 0: whole.
  void setFragmentSize(int bytes) { fragment_bytes_ = bytes; }
  /// Old ones do not know "cbor-raw" and send JSON then.
  void setKnowsRaw(bool knows) { knows_raw_ = knows; }

  bool hasSubscriber(const QString& topic) const;
  /// It was advertised so that who comes later gets the last one.
  bool isKept(const QString& topic) const { return kept_.contains(topic); }
  QString typeOf(const QString& topic) const { return types_.value(topic); }
  RosbridgeForm formOf(const QString& topic) const;  ///< in which somebody gets it

 Q_SIGNALS:
  void published(const QString& topic, const QCborMap& message);

 private:
  struct Client {
    std::map<QString, RosbridgeForm> topics;  ///< in which form it wants them
  };
  void welcome();
  void take(QWebSocket* socket, const QString& text);
  void obey(QWebSocket* socket, const QCborMap& message);
  void sendText(QWebSocket& socket, const QByteArray& text);

  QWebSocketServer server_;
  quint16 port_ = 0;
  std::map<QWebSocket*, Client> clients_;
  QHash<QString, QString> types_;
  QSet<QString> kept_;
  int fragment_bytes_ = 0;
  bool knows_raw_ = true;
  int fragmented_ = 0;
};

}  // namespace handmap
