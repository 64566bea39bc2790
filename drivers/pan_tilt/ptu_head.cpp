#include "drivers/pan_tilt/ptu_head.h"

#include <utility>

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr int kTick_ms = 20;

}  // namespace

PtuHead::PtuHead(PortAddress address, RigClock clock, PtuOptions options, std::uint64_t seed,
                 QObject* parent)
    : PortDevice(std::move(address), std::move(clock), seed, kTick_ms,
                 qPhrase("opening the port of the head"), parent),
      protocol_(options) {}

PtuHead::~PtuHead() { close(); }

void PtuHead::take(const QByteArray& bytes) {
  protocol_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, now_s());
  advance();
}

void PtuHead::watch() {
  protocol_.tick(now_s());
  advance();
}

void PtuHead::begin() {
  protocol_.start(now_s());
  if (wanted_) protocol_.lookAt(*wanted_, now_s());
  advance();
}

void PtuHead::lookAt(double pan, double tilt) {
  wanted_ = Look{pan, tilt};
  protocol_.lookAt(*wanted_, now_s());
  advance();
}

void PtuHead::halt() {
  wanted_.reset();
  protocol_.halt(now_s());
  advance();
}

void PtuHead::advance() {
  port().write(protocol_.takeOutput());
  switch (protocol_.state()) {
    case PtuProtocol::State::Closed:
      break;
    case PtuProtocol::State::Probing:
      tell(DeviceState::Connecting, qPhrase("asking the head what it can do"));
      break;
    case PtuProtocol::State::Ready:
    case PtuProtocol::State::Moving:
      if (!protocol_.trouble().empty()) {
        tell(DeviceState::Degraded, QString::fromStdString(protocol_.trouble()));
        break;
      }
      port().delivers();
      tell(DeviceState::Ready, {});
      break;
    case PtuProtocol::State::LimitHit:
      tell(DeviceState::Degraded, QString::fromStdString(protocol_.detail()));
      break;
    case PtuProtocol::State::Resetting:
      tell(DeviceState::Degraded, QString::fromStdString(protocol_.detail()) +
                                      qPhrase("; it finds its way back at its stops"));
      break;
    case PtuProtocol::State::Failed:
      port().giveUp(QString::fromStdString(protocol_.detail()));
      break;
  }
  if (const auto arrival = protocol_.takeArrival()) {
    wanted_.reset();
    Q_EMIT arrived(arrival->pan, arrival->tilt);
  }
}

}  // namespace handmap
