#include "widgets/background/time_left.h"

#include <QCoreApplication>
#include <chrono>
#include <cmath>

namespace handmap {

namespace {
constexpr double kEnough_s = 1.0;  // before, a guess would jump about
constexpr double kEnough = 0.01;
}  // namespace

void TimeLeft::update(double share, double now_s) {
  if (!begin_s_ || share < last_) {
    begin();
    begin_s_ = now_s;
    first_ = share;
  }
  last_ = share;
  const double done = share - first_;
  const double spent_s = now_s - *begin_s_;
  left_s_.reset();
  if (done >= kEnough && spent_s >= kEnough_s) left_s_ = spent_s * (1.0 - share) / done;
}

QString TimeLeft::inWords() const {
  if (!left_s_) return {};
  constexpr double kMinute_s = 60.0;
  const bool in_seconds = *left_s_ < 2.0 * kMinute_s;
  const int n = static_cast<int>(std::ceil(in_seconds ? *left_s_ : *left_s_ / kMinute_s));
  return in_seconds
             ? QCoreApplication::translate("TimeLeft", ", about %n second(s) left", nullptr, n)
             : QCoreApplication::translate("TimeLeft", ", about %n minute(s) left", nullptr, n);
}

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace handmap
