// How to talk with a PTU-D46 pan-tilt head (Directed Perception, later FLIR), without any port:
// bytes and time in, bytes out. Times are seconds that never run backwards.
//
// A blank ends a command, so that none stands before an argument ("PP1200 ").
// One command is under way at a time. An answer that does not come, or makes no sense, is a line
// that drops or doubles bytes: then the version is asked, whose answer is like no other, all that
// comes before it is old, and the command is sent again. What matters (limits, positions) is
// believed when it was answered twice the same. Nothing is ever stored in the head (DS).
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/pan_tilt/ptu_axis.h"
#include "drivers/pan_tilt/ptu_replies.h"

namespace handmap {

struct PtuOptions {
  double speed = toRadians(60.0);  ///< of both axes, radians a second; within what the head allows
};

/// Radians, positive to the left and up.
struct Look {
  double pan = 0.0;
  double tilt = 0.0;
};

class PtuProtocol {
 public:
  enum class State { Closed, Probing, Ready, Moving, LimitHit, Resetting, Failed };

  explicit PtuProtocol(PtuOptions options = {}) : options_(options) {}
  ~PtuProtocol() = default;
  PtuProtocol(const PtuProtocol&) = delete;
  PtuProtocol& operator=(const PtuProtocol&) = delete;

  void start(double now_s);  ///< somebody may listen now
  void stop();               ///< nobody does any more; what was wanted is forgotten

  /// As far as the limits allow; once the head is ready. Not finite: ignored.
  void lookAt(const Look& look, double now_s);
  void halt(double now_s);

  void feed(std::string_view bytes, double now_s);
  void tick(double now_s);  ///< a few times a second or more

  std::string takeOutput();
  std::optional<Look> takeArrival();  ///< confirmed by the head
  State state() const { return state_; }
  const std::string& detail() const { return detail_; }  ///< of LimitHit and Failed
  /// What the head last did not answer, or refused, until it answers again; empty where all is
  /// well.
  const std::string& trouble() const { return trouble_; }
  const PtuAxis& pan() const { return pan_; }
  const PtuAxis& tilt() const { return tilt_; }

 private:
  enum class Answer { Any, Plain, Number, Version };
  struct Task {
    std::string command;
    Answer answer = Answer::Plain;
    std::function<void(double)> use{};  ///< the number, or 0
    double patience_s = 0.0;            ///< beyond the usual
    bool twice = false;                 ///< believed when answered twice the same
    int attempts = 0;
    int hearings = 0;
    std::optional<double> heard{};
  };

  void probe();
  void ask(const char* command, double& value);
  void checkHead();
  void settle();
  void move();
  void confirmMove();
  void confirmHalt();
  void interrupt();
  void limitHit(const std::string& axis);
  void reset();
  void fail(const std::string& why);

  void then(Task task) { tasks_.push_back(std::move(task)); }
  void sendNext(double now_s);
  void answered(const PtuReply& reply, double now_s);
  void done(double number, double now_s);
  void tryAgain(const std::string& why, bool behind_version);

  PtuOptions options_;
  State state_ = State::Closed;
  std::string detail_;
  std::string trouble_;
  PtuReplies replies_;
  std::deque<Task> tasks_;  ///< the first is under way where sent_
  bool sent_ = false;
  double sent_s_ = 0.0;
  double idle_since_s_ = 0.0;
  double slowest_answer_s_ = 0.0;
  std::string output_;
  PtuAxis pan_;
  PtuAxis tilt_;
  double pan_position_ = 0.0;
  double tilt_position_ = 0.0;
  std::optional<Look> wanted_;
  int moves_ = 0;            ///< begun for what is wanted
  int limit_hits_ = 0;       ///< on the way to what is wanted
  bool recovering_ = false;  ///< from a limit: it is reset before it moves again
  std::optional<Look> arrival_;
};

}  // namespace handmap
