#include "drivers/emulators/ptu_emulator.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::size_t kMostHeard = 1000;
constexpr std::size_t kMostWaiting = 100;
constexpr std::size_t kLongestWord = 64;
constexpr int kTick_ms = 4;

}  // namespace

bool PtuEmulator::Axis::advance(double seconds) {
  const double left = target - position;
  // The speed from which it can still brake in time.
  const double most_speed = std::min(speed, std::sqrt(2.0 * acceleration * std::abs(left)));
  const double wanted = std::copysign(most_speed, left);
  const double change = acceleration * seconds;
  velocity = std::clamp(wanted, velocity - change, velocity + change);
  const double step = velocity * seconds;
  double next = position + step;
  if (std::abs(left) <= std::max(std::abs(step), 0.5)) next = target;
  if (obstacle && (position - *obstacle) * (next - *obstacle) <= 0.0 && position != *obstacle) {
    position = target = *obstacle;
    velocity = 0.0;
    return true;
  }
  position = next;
  if (position == target) velocity = 0.0;
  return false;
}

PtuEmulator::PtuEmulator(EmulatedPort::Kind kind, double haste, std::uint64_t seed)
    : port_(kind, seed), haste_(haste) {
  axes_[1].least = -907;
  axes_[1].most = 604;
  connect(&port_, &EmulatedPort::received, this, &PtuEmulator::hear);
  connect(&timer_, &QTimer::timeout, this, &PtuEmulator::work);
  clock_.start();
  timer_.start(kTick_ms);
}

std::vector<std::string> PtuEmulator::takeCommands() {
  std::vector<std::string> commands(heard_.begin(), heard_.end());
  heard_.clear();
  return commands;
}

void PtuEmulator::hear(const QByteArray& bytes) {
  if (dead_) return;
  for (const char byte : bytes) {
    if (echo_) port_.write({&byte, 1});
    if (byte != ' ' && byte != '\r' && byte != '\n') {
      if (word_.size() < kLongestWord) word_ += static_cast<char>(std::toupper(byte));
      continue;
    }
    if (word_.empty()) continue;
    heard_.push_back(word_);
    if (heard_.size() > kMostHeard) heard_.pop_front();
    if (word_ == "H" || (!awaiting_ && !resetting_)) {
      obey(word_);
    } else if (waiting_.size() < kMostWaiting) {
      waiting_.push_back(word_);
    }
    word_.clear();
  }
}

void PtuEmulator::work() {
  const double seconds = static_cast<double>(clock_.restart()) * 1e-3 * haste_;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i].moving() && axes_[i].advance(seconds)) port_.write(i == 0 ? "!P" : "!T");
  }
  if (axes_[0].moving() || axes_[1].moving()) return;
  if (resetting_) say("");
  if (awaiting_) say("");
  resetting_ = awaiting_ = false;
  while (!waiting_.empty() && !awaiting_ && !resetting_) {
    const std::string command = waiting_.front();
    waiting_.pop_front();
    obey(command);
  }
}

void PtuEmulator::obey(const std::string& command) {
  if (command == "A") {
    awaiting_ = true;
  } else if (command == "H") {
    halt();
  } else if (command == "R") {
    port_.write("!T!T!P!P");
    for (Axis& axis : axes_) {
      if (!axis.obstacle_stays) axis.obstacle.reset();
      axis.target = 0.0;
    }
    resetting_ = true;
  } else if (!obeySetting(command) && !obeyAxis(command)) {
    port_.write("! Illegal command\r\n");
  }
}

bool PtuEmulator::obeySetting(const std::string& command) {
  if (command == "V") {
    say("Pan-Tilt Controller v2.12.1d1(C14/E), emulated");
    return true;
  }
  if (command == "ED" || command == "EE") {
    echo_ = command == "EE";
  } else if (command == "FT" || command == "FV") {
    verbose_ = command == "FV";
  } else if (command != "CI" && command != "LE" && command != "I" && command != "DS") {
    return false;
  }
  say("");
  return true;
}

bool PtuEmulator::obeyAxis(const std::string& command) {
  if (command.size() < 2 || (command[0] != 'P' && command[0] != 'T')) return false;
  const char* name = command[0] == 'P' ? "Pan" : "Tilt";
  Axis& axis = axes_[command[0] == 'P' ? 0 : 1];
  const std::string argument = command.substr(2);
  const auto value = parseInteger(argument);
  if (!argument.empty()) {
    if (!value || std::abs(*value) > 1'000'000) return false;
    if (command[1] == 'P') return moveTo(axis, name, static_cast<int>(*value)), true;
    if (command[1] != 'S') return false;
    if (*value < axis.slowest || *value > axis.fastest) return false;
    axis.speed = static_cast<double>(*value);
    return say(""), true;
  }
  const auto answer = [&](const char* what, double number) {
    query(fmt::format("{} {} is", name, what), formatNumber(number));
    return true;
  };
  switch (command[1]) {
    case 'P':
      return answer("position", std::round(axis.position));
    case 'R':
      if (!verbose_) return answer("resolution", axis.resolution_arcsec);
      return say(formatNumber(axis.resolution_arcsec) + " seconds arc per position"), true;
    case 'N':
      return answer("minimum position", axis.least);
    case 'X':
      return answer("maximum position", axis.most);
    case 'L':
      return answer("lower speed limit", axis.slowest);
    case 'U':
      return answer("upper speed limit", axis.fastest);
    case 'S':
      return answer("speed", axis.speed);
    default:
      return false;
  }
}

void PtuEmulator::moveTo(Axis& axis, const char* name, int position) {
  if (position > axis.most || position < axis.least) {
    const bool over = position > axis.most;
    port_.write(fmt::format("! {} allowable {} position is {}\r\n", over ? "Maximum" : "Minimum",
                            name, over ? axis.most : axis.least));
    return;
  }
  axis.target = position;
  say("");
}

void PtuEmulator::query(const std::string& words, const std::string& value) {
  say(verbose_ ? words + ' ' + value : value);
}

void PtuEmulator::say(const std::string& text) {
  port_.write(text.empty() ? "*\r\n" : "* " + text + "\r\n");
}

void PtuEmulator::halt() {
  for (Axis& axis : axes_) {
    axis.position = axis.target = std::round(axis.position);
    axis.velocity = 0.0;
  }
  say("");
}

}  // namespace handmap
