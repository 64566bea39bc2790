#include "drivers/pan_tilt/ptu_head.h"

#include <utility>

namespace handmap {

namespace {

constexpr int kTick_ms = 20;

}  // namespace

PtuHead::PtuHead(PortAddress address, RigClock clock, PtuOptions options, std::uint64_t seed,
                 QObject* parent)
    : PanTiltHead(parent),
      clock_(std::move(clock)),
      port_(std::move(address), seed),
      protocol_(options) {
  connect(&port_, &BytePort::opened, this, &PtuHead::begin);
  connect(&port_, &BytePort::received, this, [this](const QByteArray& bytes) {
    protocol_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, clock_());
    advance();
  });
  connect(&port_, &BytePort::lost, this, [this](const QString& why) {
    timer_.stop();
    protocol_.stop();
    tell(DeviceState::Lost, why);
  });
  connect(&timer_, &QTimer::timeout, this, [this] {
    protocol_.tick(clock_());
    advance();
  });
}

PtuHead::~PtuHead() { PtuHead::close(); }

void PtuHead::open() {
  if (told_.state() != DeviceState::Closed) return;
  tell(DeviceState::Connecting, QStringLiteral("opening the port of the head"));
  port_.open();
}

void PtuHead::close() {
  if (told_.state() == DeviceState::Closed) return;
  halt();
  timer_.stop();
  port_.close();
  protocol_.stop();
  tell(DeviceState::Closed, {});
}

void PtuHead::begin() {
  protocol_.start(clock_());
  if (wanted_) protocol_.lookAt(*wanted_, clock_());
  timer_.start(kTick_ms);
  advance();
}

void PtuHead::lookAt(double pan, double tilt) {
  wanted_ = Look{pan, tilt};
  protocol_.lookAt(*wanted_, clock_());
  advance();
}

void PtuHead::halt() {
  wanted_.reset();
  protocol_.halt(clock_());
  advance();
}

void PtuHead::advance() {
  port_.write(protocol_.takeOutput());
  switch (protocol_.state()) {
    case PtuProtocol::State::Closed:
      break;
    case PtuProtocol::State::Probing:
      tell(DeviceState::Connecting, QStringLiteral("asking the head what it can do"));
      break;
    case PtuProtocol::State::Ready:
    case PtuProtocol::State::Moving:
      port_.delivers();
      tell(DeviceState::Ready, {});
      break;
    case PtuProtocol::State::LimitHit:
      tell(DeviceState::Degraded, QString::fromStdString(protocol_.detail()));
      break;
    case PtuProtocol::State::Resetting:
      tell(DeviceState::Degraded, QString::fromStdString(protocol_.detail()) +
                                      QStringLiteral("; it finds its way back at its stops"));
      break;
    case PtuProtocol::State::Failed:
      port_.giveUp(QString::fromStdString(protocol_.detail()));
      break;
  }
  if (const auto arrival = protocol_.takeArrival()) {
    wanted_.reset();
    Q_EMIT arrived(arrival->pan, arrival->tilt);
  }
}

void PtuHead::tell(DeviceState state, const QString& detail) {
  if (told_.changes(state, detail)) Q_EMIT stateChanged(state, detail);
}

}  // namespace handmap
