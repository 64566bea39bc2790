#include "drivers/pan_tilt/ptu_protocol.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kPatience_s = 1.0;        // a long answer takes 0.1 s at 9600 baud
constexpr double kResetPatience_s = 60.0;  // both axes run to their stops and back
constexpr double kLongestAnswer_s = 4.0;
constexpr double kAskEvery_s = 1.0;  // whether the head is still there
constexpr int kMostAttempts = 5;
constexpr int kMostHearings = 10;
constexpr int kMostMoves = 3;
constexpr double kStandsThere = 1.0;  // position

}  // namespace

void PtuProtocol::start(double now_s) {
  stop();
  idle_since_s_ = now_s;
  probe();
  sendNext(now_s);
}

void PtuProtocol::stop() {
  state_ = State::Closed;
  detail_.clear();
  trouble_.clear();
  replies_.clear();
  tasks_.clear();
  sent_ = false;
  output_.clear();
  wanted_.reset();
  arrival_.reset();
  slowest_answer_s_ = 0.0;
  recovering_ = false;
}

// What a head is set to is asked anew each time: another may be plugged in by now.
void PtuProtocol::probe() {
  state_ = State::Probing;
  then({"ED", Answer::Any});
  then({"FT", Answer::Any});
  then({"V", Answer::Version});
  ask("PR", pan_.resolution_arcsec);
  ask("TR", tilt_.resolution_arcsec);
  ask("PN", pan_.least);
  ask("PX", pan_.most);
  ask("TN", tilt_.least);
  ask("TX", tilt_.most);
  ask("PL", pan_.slowest);
  ask("PU", pan_.fastest);
  ask("TL", tilt_.slowest);
  ask("TU", tilt_.fastest);
  then({"CI", Answer::Plain});  // each axis for itself
  then({"LE", Answer::Plain});  // within the limits
  then({"I", Answer::Plain, [this](double) { checkHead(); }});
}

void PtuProtocol::ask(const char* command, double& value) {
  Task task{command, Answer::Number, [&value](double number) { value = number; }};
  task.twice = true;
  then(std::move(task));
}

void PtuProtocol::checkHead() {
  for (const auto& [name, axis] : {std::pair("pan", &pan_), std::pair("tilt", &tilt_)}) {
    if (const auto fault = axis->fault()) return fail(fmt::format("{}: {}", name, *fault));
  }
  then({fmt::format("PS{:.0f}", pan_.speedOf(options_.speed)), Answer::Plain});
  then({fmt::format("TS{:.0f}", tilt_.speedOf(options_.speed)), Answer::Plain});
  ask("PP", pan_position_);
  ask("TP", tilt_position_);
  tasks_.back().use = [this](double number) {
    tilt_position_ = number;
    settle();
  };
}

void PtuProtocol::settle() {
  recovering_ = false;
  if (wanted_ && limit_hits_ < 2) return move();
  if (wanted_) {
    state_ = State::LimitHit;
    detail_ += phrase(", twice on the same way; it stands until it is asked to look elsewhere");
    wanted_.reset();
    return;
  }
  state_ = State::Ready;
}

void PtuProtocol::move() {
  state_ = State::Moving;
  ++moves_;
  const double pan = pan_.positionOf(wanted_->pan);
  const double tilt = tilt_.positionOf(wanted_->tilt);
  const double longest_s =
      std::max(std::abs(pan - pan_position_) / pan_.speedOf(options_.speed),
               std::abs(tilt - tilt_position_) / tilt_.speedOf(options_.speed));
  then({fmt::format("PP{:.0f}", pan), Answer::Plain});
  then({fmt::format("TP{:.0f}", tilt), Answer::Plain});
  Task wait{"A", Answer::Plain};
  wait.patience_s = 2.0 * longest_s + 1.0;  // it accelerates and brakes
  then(std::move(wait));
  ask("PP", pan_position_);
  ask("TP", tilt_position_);
  tasks_.back().use = [this](double number) {
    tilt_position_ = number;
    confirmMove();
  };
}

void PtuProtocol::confirmMove() {
  const double pan_off = std::abs(pan_position_ - pan_.positionOf(wanted_->pan));
  const double tilt_off = std::abs(tilt_position_ - tilt_.positionOf(wanted_->tilt));
  if (pan_off > kStandsThere || tilt_off > kStandsThere) {
    if (moves_ < kMostMoves) return move();
    return fail(phrase("the head stands at {:.1f}°, {:.1f}° and was sent to {:.1f}°, {:.1f}°",
                       toDegrees(pan_.angleOf(pan_position_)),
                       toDegrees(tilt_.angleOf(tilt_position_)), toDegrees(wanted_->pan),
                       toDegrees(wanted_->tilt)));
  }
  state_ = State::Ready;
  wanted_.reset();
  arrival_ = Look{pan_.angleOf(pan_position_), tilt_.angleOf(tilt_position_)};
}

void PtuProtocol::lookAt(const Look& look, double now_s) {
  if (!std::isfinite(look.pan) || !std::isfinite(look.tilt)) return;
  if (state_ == State::Closed || state_ == State::Failed) return;
  wanted_ = look;
  moves_ = limit_hits_ = 0;
  arrival_.reset();
  if (state_ == State::Probing || state_ == State::Resetting) return;
  if (recovering_) return;
  detail_.clear();
  if (state_ == State::Moving) interrupt();
  move();
  sendNext(now_s);
}

void PtuProtocol::halt(double now_s) {
  wanted_.reset();
  arrival_.reset();
  if (state_ == State::Closed || state_ == State::Failed) return;
  if (state_ != State::Ready && state_ != State::Moving) {
    output_ += "H ";  // its answer is passed over
    return;
  }
  state_ = State::Moving;  // until it is known to stand
  interrupt();
  confirmHalt();
  sendNext(now_s);
}

// Not behind the command that is under way: that may be the wait for the end of a motion.
void PtuProtocol::interrupt() {
  tasks_.clear();
  sent_ = false;
  output_ += "H ";
  then({"V", Answer::Version});
}

void PtuProtocol::confirmHalt() {
  const double before = pan_position_;
  const double tilt_before = tilt_position_;
  then({"PP", Answer::Number, [this](double number) { pan_position_ = number; }});
  then({"TP", Answer::Number, [this, before, tilt_before](double number) {
          tilt_position_ = number;
          if (pan_position_ == before && tilt_position_ == tilt_before) {
            state_ = State::Ready;
            return;
          }
          interrupt();
          confirmHalt();
        }});
}

void PtuProtocol::limitHit(const std::string& axis) {
  if (state_ != State::Moving && state_ != State::Ready) return;
  state_ = State::LimitHit;
  recovering_ = true;
  detail_ = phrase("the head ran against its {} limit", axis);
  ++limit_hits_;
  moves_ = 0;
  interrupt();
  // The head has lost count of its steps; it finds them again at its stops.
  tasks_.back().use = [this](double) { reset(); };
}

void PtuProtocol::reset() {
  state_ = State::Resetting;
  Task task{"R", Answer::Plain, [this](double) { probe(); }};
  task.patience_s = kResetPatience_s;
  then(std::move(task));
}

void PtuProtocol::fail(const std::string& why) {
  state_ = State::Failed;
  detail_ = why;
  tasks_.clear();
  sent_ = false;
  wanted_.reset();
}

void PtuProtocol::sendNext(double now_s) {
  if (sent_ || tasks_.empty()) return;
  output_ += tasks_.front().command + ' ';
  sent_ = true;
  sent_s_ = now_s;
}

void PtuProtocol::feed(std::string_view bytes, double now_s) {
  if (state_ == State::Closed || state_ == State::Failed) return;
  for (const PtuReply& reply : replies_.feed(bytes)) {
    if (reply.kind == PtuReply::Kind::PanLimit) {
      limitHit(phrase("pan"));
    } else if (reply.kind == PtuReply::Kind::TiltLimit) {
      limitHit(phrase("tilt"));
    } else if (sent_) {
      answered(reply, now_s);
    }
    sendNext(now_s);
  }
}

void PtuProtocol::answered(const PtuReply& reply, double now_s) {
  const Task& task = tasks_.front();
  const std::optional<double> number = reply.number();
  if (reply.kind == PtuReply::Kind::Refused) {
    if (task.answer != Answer::Version) tryAgain(phrase("the head refuses: {}", reply.text), false);
    return;
  }
  const bool version = !reply.text.empty() && !number;
  switch (task.answer) {
    case Answer::Any:
      return done(0.0, now_s);
    case Answer::Plain:
      if (reply.text.empty()) done(0.0, now_s);
      return;
    case Answer::Number:
      if (number) done(*number, now_s);
      return;
    case Answer::Version:
      if (version) done(0.0, now_s);
      return;
  }
}

void PtuProtocol::done(double number, double now_s) {
  Task& task = tasks_.front();
  if (task.patience_s == 0.0) {
    slowest_answer_s_ = std::clamp(now_s - sent_s_, slowest_answer_s_, kLongestAnswer_s);
  }
  sent_ = false;
  trouble_.clear();
  idle_since_s_ = now_s;
  if (task.twice && task.heard != number) {
    task.heard = number;
    if (++task.hearings > kMostHearings) fail(phrase("the head never answers twice the same"));
    return;
  }
  const Task finished = std::move(task);
  tasks_.pop_front();
  if (finished.use) finished.use(number);
}

void PtuProtocol::tryAgain(const std::string& why, bool behind_version) {
  sent_ = false;
  replies_.clear();
  trouble_ = why;
  if (++tasks_.front().attempts >= kMostAttempts) return fail(why);
  if (behind_version && tasks_.front().answer != Answer::Version) {
    tasks_.push_front({"V", Answer::Version});
  }
}

void PtuProtocol::tick(double now_s) {
  if (state_ == State::Closed || state_ == State::Failed) return;
  if (sent_) {
    const Task& task = tasks_.front();
    const double patience_s =
        std::max(kPatience_s, 2.0 * slowest_answer_s_) * std::exp2(std::min(task.attempts, 2)) +
        task.patience_s;
    if (now_s - sent_s_ > patience_s) {
      tryAgain(phrase("the head does not answer to {}", task.command), true);
    }
  } else if (tasks_.empty() && now_s - idle_since_s_ > kAskEvery_s) {
    then({"PP", Answer::Number, [this](double number) { pan_position_ = number; }});
  }
  sendNext(now_s);
}

std::string PtuProtocol::takeOutput() { return std::exchange(output_, {}); }

std::optional<Look> PtuProtocol::takeArrival() { return std::exchange(arrival_, std::nullopt); }

}  // namespace handmap
