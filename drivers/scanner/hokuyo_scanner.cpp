#include "drivers/scanner/hokuyo_scanner.h"

#include <utility>

#include <fmt/format.h>

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr std::size_t kLongestLine = 300;
constexpr int kHokuyoWatch_ms = 100;
constexpr double kHokuyoPatience_s = 1.0;
constexpr int kHokuyoAttempts = 4;

}  // namespace

HokuyoScanner::HokuyoScanner(PortAddress address, RigClock clock, std::uint64_t seed,
                             QObject* parent)
    : PortDevice(std::move(address), std::move(clock), seed, kHokuyoWatch_ms,
                 qPhrase("opening the port of the scanner"), parent),
      lines_(kLongestLine, true) {}

HokuyoScanner::~HokuyoScanner() { close(); }

void HokuyoScanner::begin() {
  lines_.clear();
  reader_.clear();
  scanner_clock_ = {};
  offset_ = {};
  attempts_ = 0;
  go(Step::Stopping);
}

void HokuyoScanner::take(const QByteArray& bytes) {
  lines_.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())},
              [this](std::string_view line) {
                if (line.ends_with('\r')) line.remove_suffix(1);
                if (const auto answer = reader_.take(line)) take(*answer);
              });
}

void HokuyoScanner::rest() {
  if (step_ != Step::Closed) port().write("QT\n");  // the laser goes out
}

// Stopped first: a scanner that was left while it measured would drown the answers.
void HokuyoScanner::go(Step step) {
  step_ = step;
  step_since_s_ = now_s();
  switch (step) {
    case Step::Closed:
      return;
    case Step::Stopping:
      tell(DeviceState::Connecting, qPhrase("asking the scanner what it can do"));
      return port().write("\nSCIP2.0\nQT\n");
    case Step::Asking:
      return port().write("PP\n");
    case Step::LightingUp:
      return port().write("BM\n");
    case Step::Starting:
      return port().write(
          fmt::format("MD{:04}{:04}01000\n", parameters_->first_step, parameters_->last_step));
    case Step::Scanning:
      last_scan_s_ = step_since_s_;
      return;
  }
}

void HokuyoScanner::take(const ScipAnswer& answer) {
  const std::string command = answer.echo.substr(0, 2);
  const bool well = answer.status == "00";
  if (step_ == Step::Stopping && command == "QT") {
    go(Step::Asking);
  } else if (step_ == Step::Asking && command == "PP" && well) {
    parameters_ = parseScipParameters(answer);
    if (!parameters_) return;
    Q_EMIT reaches(0.001 * parameters_->most_mm);
    go(Step::LightingUp);
  } else if (step_ == Step::LightingUp && command == "BM") {
    // 02: the laser is on already.
    if (well || answer.status == "02") return go(Step::Starting);
    port().giveUp(
        qPhrase("the scanner cannot switch its laser on: it reports status {}", answer.status));
  } else if (command == "MD" && answer.status == "99") {
    if (step_ == Step::Starting) go(Step::Scanning);
    if (step_ == Step::Scanning) takeScan(answer);
  } else if (step_ == Step::Scanning && command == "MD" && !well) {
    port().giveUp(qPhrase("the scanner stopped: it reports status {}", answer.status));
  }
}

void HokuyoScanner::takeScan(const ScipAnswer& answer) {
  const auto scan = parseScipScan(answer, *parameters_);
  if (!scan) return;
  last_scan_s_ = now_s();
  port().delivers();
  tell(DeviceState::Ready, QString::fromStdString(parameters_->model));
  const auto end_s = offset_.rigTime(scanner_clock_.seconds(scan->stamp_ms), last_scan_s_);
  if (end_s)
    Q_EMIT scanned(*end_s - 0.5 * parameters_->scanTime_s(), scipPoints(*scan, *parameters_));
}

void HokuyoScanner::watch() {
  if (step_ == Step::Scanning) {
    if (now_s() - last_scan_s_ > kSilence_s) {
      port().giveUp(qPhrase("the scanner has sent no whole scan for a second"));
    }
  } else if (now_s() - step_since_s_ > kHokuyoPatience_s) {
    if (++attempts_ >= kHokuyoAttempts) {
      return port().giveUp(qPhrase("what is at this port does not answer as a Hokuyo scanner"));
    }
    go(step_ == Step::Starting ? Step::Stopping : step_);
  }
}

}  // namespace handmap
