#include "drivers/camera/frame_grabber.h"

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/device/reconnect.h"

namespace handmap {

FrameGrabber::FrameGrabber(std::string name, OpenImageDevice open, std::uint64_t seed,
                           FrameListener on_frame, StateListener on_state)
    : name_(std::move(name)),
      open_(std::move(open)),
      seed_(seed),
      on_frame_(std::move(on_frame)),
      on_state_(std::move(on_state)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void FrameGrabber::work(const std::stop_token& stop) {
  Reconnect reconnect(seed_);
  while (!stop.stop_requested()) {
    on_state_(State::Opening, name_);
    const Outcome outcome = grabAll(stop);
    if (stop.stop_requested()) return;
    if (outcome == Outcome::AtEnd) {
      return on_state_(State::AtEnd, phrase("{}: the video is at its end", name_));
    }
    if (outcome == Outcome::Delivered) reconnect.succeeded();
    waitFor(std::chrono::duration<double>(reconnect.nextDelay()).count(), stop);
  }
}

FrameGrabber::Outcome FrameGrabber::grabAll(const std::stop_token& stop) {
  Outcome outcome = Outcome::Nothing;
  try {
    const auto device = open_();
    while (!stop.stop_requested()) {
      auto frame = device->next(stop);
      if (!frame) break;
      if (outcome == Outcome::Nothing) on_state_(State::Delivering, name_);
      outcome = Outcome::Delivered;
      on_frame_(std::move(*frame));
    }
    if (stop.stop_requested()) return outcome;
    if (outcome == Outcome::Delivered && device->hasEnd()) return Outcome::AtEnd;
    on_state_(State::Lost, phrase("{}: no more images come", name_));
  } catch (const Error& error) {
    on_state_(State::Lost, error.what());
  } catch (const std::exception& error) {
    on_state_(State::Lost, name_ + ": " + error.what());
  }
  return outcome;
}

}  // namespace handmap
