#include "drivers/emulators/emulated_port.h"

#include <QFile>
#include <QTimer>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include "core/base/error.h"

namespace handmap {

namespace {

[[noreturn]] void failOf(const char* what) {
  throw Error(ErrorCode::RunFailed, fmt::format("no {}: {}", what, std::strerror(errno)));
}

void makeRaw(int descriptor) {
  termios settings{};
  if (tcgetattr(descriptor, &settings) != 0) failOf("pseudo-terminal");
  cfmakeraw(&settings);
  tcsetattr(descriptor, TCSANOW, &settings);
}

}  // namespace

EmulatedPort::EmulatedPort(Kind kind, std::uint64_t seed, QObject* parent)
    : QObject(parent), kind_(kind), random_(seed) {
  connect(&server_, &QTcpServer::newConnection, this, [this] {
    QTcpSocket* socket = server_.nextPendingConnection();
    if (peer_) return socket->deleteLater();  // a serial line has one end
    peer_ = socket;
    connect(socket, &QTcpSocket::readyRead, this, [this, socket] { take(socket->readAll()); });
    connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
      if (peer_ == socket) peer_ = nullptr;
      socket->deleteLater();
    });
  });
  plug();
}

EmulatedPort::~EmulatedPort() {
  server_.disconnect(this);
  blockSignals(true);  // whose port it is may be half gone
  unplug();
}

std::string EmulatedPort::address() const {
  if (kind_ == Kind::Tcp) return fmt::format("tcp://127.0.0.1:{}", tcp_port_);
  return folder_.filePath(QStringLiteral("port")).toStdString();
}

void EmulatedPort::plug() {
  if (isPlugged()) return;
  if (kind_ == Kind::Tcp) {
    plugTcp();
  } else {
    plugTerminal();
  }
}

void EmulatedPort::plugTcp() {
  if (!server_.listen(QHostAddress::LocalHost, tcp_port_)) {
    throw Error(ErrorCode::RunFailed, "no port: " + server_.errorString().toStdString());
  }
  tcp_port_ = server_.serverPort();
}

void EmulatedPort::plugTerminal() {
  terminal_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  char name[128];
  if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0 ||
      ptsname_r(terminal_, name, sizeof name) != 0) {
    failOf("pseudo-terminal");
  }
  own_end_ = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (own_end_ < 0) failOf("pseudo-terminal");
  makeRaw(own_end_);
  if (!QFile::link(QString::fromLocal8Bit(name), QString::fromStdString(address()))) {
    failOf("link to the pseudo-terminal");
  }
  notifier_ = std::make_unique<QSocketNotifier>(terminal_, QSocketNotifier::Read);
  connect(notifier_.get(), &QSocketNotifier::activated, this, &EmulatedPort::readTerminal);
}

void EmulatedPort::unplug() {
  if (!isPlugged()) return;
  late_.clear();
  if (kind_ == Kind::Tcp) {
    server_.close();
    if (QTcpSocket* peer = std::exchange(peer_, nullptr)) peer->abort();
  } else {
    notifier_.reset();
    ::close(std::exchange(own_end_, -1));
    ::close(std::exchange(terminal_, -1));
    QFile::remove(QString::fromStdString(address()));
  }
  Q_EMIT unplugged();
}

void EmulatedPort::readTerminal() {
  char bytes[4096];
  const ssize_t count = ::read(terminal_, bytes, sizeof bytes);
  if (count > 0) take(QByteArray(bytes, count));
}

void EmulatedPort::take(const QByteArray& bytes) {
  const QByteArray arrived = faulty({bytes.constData(), static_cast<std::size_t>(bytes.size())});
  if (!arrived.isEmpty()) Q_EMIT received(arrived);
}

QByteArray EmulatedPort::faulty(std::string_view bytes) {
  QByteArray result;
  for (const char byte : bytes) {
    if (faults_.dropped > 0.0 && random_.uniform() < faults_.dropped) continue;
    result += byte;
    if (faults_.doubled > 0.0 && random_.uniform() < faults_.doubled) result += byte;
  }
  return result;
}

void EmulatedPort::write(std::string_view bytes) {
  if (!isPlugged()) return;
  const QByteArray sent = faulty(bytes);
  if (faults_.delay_ms == 0 && late_.empty()) {
    send({sent.constData(), static_cast<std::size_t>(sent.size())});
    return;
  }
  late_.push_back(sent);
  QTimer::singleShot(faults_.delay_ms, this, &EmulatedPort::sendNextLate);
}

void EmulatedPort::sendNextLate() {
  if (late_.empty()) return;
  const QByteArray bytes = late_.front();
  late_.pop_front();
  send({bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

void EmulatedPort::send(std::string_view bytes) {
  if (peer_) peer_->write(bytes.data(), static_cast<qint64>(bytes.size()));
  if (terminal_ < 0) return;
  // What a full line does not take is lost, as on the wire.
  [[maybe_unused]] const ssize_t written = ::write(terminal_, bytes.data(), bytes.size());
}

}  // namespace handmap
