// How well what a device sends can be used: told as degraded where much of it cannot.
#pragma once

namespace handmap {

class Health {
 public:
  void good() { bad_ *= kMemory; }
  void bad() { bad_ = bad_ * kMemory + 1.0; }
  /// Worse than one in ten lately; good again when it is better than one in fifty.
  bool degraded() {
    if (bad_ > 0.1 / (1.0 - kMemory)) degraded_ = true;
    if (bad_ < 0.02 / (1.0 - kMemory)) degraded_ = false;
    return degraded_;
  }

 private:
  static constexpr double kMemory = 0.98;  // of about fifty messages

  double bad_ = 0.0;
  bool degraded_ = false;
};

}  // namespace handmap
