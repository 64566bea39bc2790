#include "drivers/emulators/hokuyo_emulator.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace handmap {

namespace {

constexpr std::size_t kLongestCommand = 100;
constexpr std::size_t kDataCharacters = 64;  // of a line
constexpr std::int64_t kClockTurn = 1 << 24;
constexpr std::size_t kScanCommandSize = 15;
constexpr int kNothing = 1;  // the code for no return

std::string withSum(const std::string& text) { return text + scipSum(text) + '\n'; }

}  // namespace

HokuyoEmulator::HokuyoEmulator(EmulatedPort::Kind kind, RangeFunction range,
                               ScipParameters parameters, std::uint64_t seed)
    : port_(kind, seed), range_(std::move(range)), parameters_(std::move(parameters)) {
  if (parameters_.model.empty()) parameters_.model = "Emulated";
  connect(&port_, &EmulatedPort::received, this, &HokuyoEmulator::hear);
  connect(&port_, &EmulatedPort::unplugged, this, [this] {
    timer_.stop();
    laser_on_ = false;
  });
  connect(&timer_, &QTimer::timeout, this, &HokuyoEmulator::sendScan);
  timer_.setTimerType(Qt::PreciseTimer);
  clock_.start();
}

void HokuyoEmulator::hear(const QByteArray& bytes) {
  if (dead_) return;
  for (const char byte : bytes) {
    if (byte == '\n' || byte == '\r') {
      if (!line_.empty()) obey(std::exchange(line_, {}));
    } else if (line_.size() < kLongestCommand) {
      line_ += byte;
    }
  }
}

void HokuyoEmulator::obey(const std::string& command) {
  const auto answer = [&](const std::string& status) {
    port_.write(command + '\n' + withSum(status) + '\n');
  };
  if (command == "QT") {
    timer_.stop();
    laser_on_ = false;
    answer("00");
  } else if (command == "PP") {
    sendParameters();
  } else if (command == "BM") {
    answer(std::exchange(laser_on_, true) ? "02" : "00");
  } else if (command.starts_with("MD") && command.size() == kScanCommandSize) {
    answer("00");
    scan_command_ = command;
    laser_on_ = true;
    timer_.start(60'000 / parameters_.turns_a_minute);
  } else {
    answer("0E");  // also to "SCIP2.0": it speaks nothing else
  }
}

void HokuyoEmulator::sendParameters() {
  const auto line = [](const std::string& text) { return text + ';' + scipSum(text) + '\n'; };
  const ScipParameters& p = parameters_;
  port_.write(
      "PP\n" + withSum("00") + line("MODL:" + p.model) + line(fmt::format("DMIN:{}", p.least_mm)) +
      line(fmt::format("DMAX:{}", p.most_mm)) + line(fmt::format("ARES:{}", p.steps_a_turn)) +
      line(fmt::format("AMIN:{}", p.first_step)) + line(fmt::format("AMAX:{}", p.last_step)) +
      line(fmt::format("AFRT:{}", p.front_step)) + line(fmt::format("SCAN:{}", p.turns_a_minute)) +
      '\n');
}

void HokuyoEmulator::sendScan() {
  if (dead_) return;
  const std::int64_t stamp = (clock_.elapsed() + clock_offset_ms_) % kClockTurn;
  std::string data;
  for (int step = parameters_.first_step; step <= parameters_.last_step; ++step) {
    const double angle = 2.0 * kPi * (step - parameters_.front_step) / parameters_.steps_a_turn;
    const double range_mm = range_(angle) * 1e3;
    const bool seen = range_mm >= parameters_.least_mm && range_mm <= parameters_.most_mm;
    data += scipEncode(static_cast<std::uint32_t>(seen ? std::lround(range_mm) : kNothing), 3);
  }
  std::string text = scan_command_ + '\n' + withSum("99");
  const std::int64_t positive = (stamp + kClockTurn) % kClockTurn;
  text += withSum(scipEncode(static_cast<std::uint32_t>(positive), 4));
  for (std::size_t i = 0; i < data.size(); i += kDataCharacters) {
    text += withSum(data.substr(i, kDataCharacters));
  }
  port_.write(text + '\n');
}

}  // namespace handmap
