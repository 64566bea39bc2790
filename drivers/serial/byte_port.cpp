#include "drivers/serial/byte_port.h"

#include <QDir>
#include <QSerialPort>
#include <QTcpSocket>
#include <utility>

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr qint64 kMostWaiting = 64 * 1024;  // bytes not yet sent
constexpr qint64 kMostUnread = 256 * 1024;  // bytes not yet read
constexpr int kPatience_ms = 5000;

bool isFatal(QSerialPort::SerialPortError error) {
  switch (error) {
    case QSerialPort::NoError:
    case QSerialPort::TimeoutError:
    case QSerialPort::UnsupportedOperationError:  // a pseudo-terminal has no DTR and RTS
      return false;
    default:
      return true;
  }
}

/// The path is told as the person wrote it: QSerialPort leaves out "/dev/". It locks the name
/// first, so that of a device that is not there it can say that another program has it.
QString whyNotOpened(const QSerialPort& serial, const std::string& path) {
  if (!QDir(QStringLiteral("/dev")).exists(QString::fromStdString(path))) {
    return qPhrase("{} is not there: is it plugged in?", path);
  }
  if (serial.error() == QSerialPort::PermissionError) {
    return qPhrase(
        "{} may not be opened: another program has it, or you are not in the group dialout", path);
  }
  return QStringLiteral("%1: %2").arg(QString::fromStdString(path), qReason(serial.errorString()));
}

}  // namespace

BytePort::BytePort(PortAddress address, std::uint64_t seed, QObject* parent)
    : QObject(parent), address_(std::move(address)), reconnect_(seed) {
  retry_.setSingleShot(true);
  patience_.setSingleShot(true);
  connect(&retry_, &QTimer::timeout, this, &BytePort::attempt);
  connect(&patience_, &QTimer::timeout, this,
          [this] { giveUp(qPhrase("nobody answers at {}", formatPortAddress(address_))); });
}

BytePort::~BytePort() { close(); }

void BytePort::open() {
  if (!device_ && !retry_.isActive()) retry_.start(0);
}

void BytePort::close() {
  retry_.stop();
  letGo();
}

bool BytePort::isOpen() const { return device_ && device_->isOpen() && !patience_.isActive(); }

void BytePort::attempt() {
  if (const auto* serial = std::get_if<SerialAddress>(&address_)) {
    openSerial(*serial);
  } else {
    openTcp(std::get<TcpAddress>(address_));
  }
}

void BytePort::openSerial(const SerialAddress& address) {
  auto* serial = new QSerialPort(this);
  device_ = serial;
  serial->setPortName(QString::fromStdString(address.path));
  serial->setBaudRate(address.baud);
  serial->setReadBufferSize(kMostUnread);
  if (!serial->open(QIODevice::ReadWrite)) return giveUp(whyNotOpened(*serial, address.path));
  connect(serial, &QSerialPort::errorOccurred, this,
          [this, serial, path = address.path](QSerialPort::SerialPortError error) {
            if (isFatal(error)) {
              giveUp(qPhrase("{} is gone: {}", path, qReason(serial->errorString()).toStdString()));
            }
          });
  becomeOpen();
}

void BytePort::openTcp(const TcpAddress& address) {
  auto* socket = new QTcpSocket(this);
  device_ = socket;
  socket->setReadBufferSize(kMostUnread);
  connect(socket, &QTcpSocket::connected, this, &BytePort::becomeOpen);
  connect(socket, &QTcpSocket::errorOccurred, this, [this, socket] {
    giveUp(QStringLiteral("%1: %2").arg(QString::fromStdString(formatPortAddress(address_)),
                                        qReason(socket->errorString())));
  });
  patience_.start(kPatience_ms);
  socket->connectToHost(QString::fromStdString(address.host), address.port);
}

void BytePort::becomeOpen() {
  patience_.stop();
  connect(device_, &QIODevice::readyRead, this, &BytePort::read);
  Q_EMIT opened();
}

void BytePort::read() {
  const QByteArray bytes = device_ ? device_->readAll() : QByteArray();
  if (!bytes.isEmpty()) Q_EMIT received(bytes);
}

void BytePort::write(std::string_view bytes) {
  if (!isOpen()) return;
  if (device_->bytesToWrite() + static_cast<qint64>(bytes.size()) > kMostWaiting) {
    return giveUp(qPhrase("{} does not take what is sent", formatPortAddress(address_)));
  }
  device_->write(bytes.data(), static_cast<qint64>(bytes.size()));
}

void BytePort::giveUp(const QString& why) {
  if (!device_) return;
  letGo();
  retry_.start(reconnect_.nextDelay());
  Q_EMIT lost(why);
}

void BytePort::setDataTerminalReady(bool ready) {
  if (auto* serial = qobject_cast<QSerialPort*>(device_)) serial->setDataTerminalReady(ready);
}

void BytePort::letGo() {
  patience_.stop();
  if (!device_) return;
  QIODevice* device = std::exchange(device_, nullptr);
  device->disconnect(this);
  auto* serial = qobject_cast<QSerialPort*>(device);
  auto* socket = qobject_cast<QTcpSocket*>(device);
  if (serial && serial->isOpen()) serial->flush();
  if (socket) socket->flush();
  if (device->isOpen()) device->close();
  device->deleteLater();  // it may be the one that called
}

}  // namespace handmap
