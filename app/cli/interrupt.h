// Ctrl-C as a stop request.
#pragma once

#include <stop_token>
#include <thread>

namespace handmap {

/// From its making on SIGINT and SIGTERM ask for a stop; a second one ends the program at once.
/// To be made before other threads are, so that none of them takes the signals.
class Interrupt {
 public:
  static constexpr int kExitStatus = 130;  ///< 128 + SIGINT, as shells have it

  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  bool requested() const { return stop_.stop_requested(); }

 private:
  std::stop_source stop_;
  std::jthread waiter_;
};

}  // namespace handmap
