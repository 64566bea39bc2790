// The owner of a run's source, and of the devices behind it, from opening to the last byte closed:
// opened once, kept while one run after another goes on with it, and closed in the background.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <stop_token>

#include "core/tape/tape.h"

namespace handmap {

class RunFeed {
 public:
  /// Called in the thread of a run: opening may take its time, and tells the share done. The source
  /// must not wait for anything once the stop is requested; nullptr when it was requested before
  /// the source was open. Throws handmap::Error.
  using Open = std::function<std::unique_ptr<ObservationSource>(
      std::stop_token, const std::function<void(double)>&)>;
  /// Ready when a source is closed, whatever it held.
  using Closed = std::shared_future<void>;

  /// Opens not before `others` has closed what both may need: a device has one reader.
  RunFeed(Open open, PerceptionOptions perception, Closed others = {});
  /// As end(): nobody waits for a source that is let go.
  ~RunFeed();
  RunFeed(const RunFeed&) = delete;
  RunFeed& operator=(const RunFeed&) = delete;

  /// Opens it the first time. nullptr when the end was asked for before. In the thread of a run.
  std::shared_ptr<Tape> open(const std::function<void(double)>& progress);
  /// nullptr before it is open; what was perceived stays after the end. From any thread; never
  /// waits.
  std::shared_ptr<Tape> tape() const;
  /// Nothing more is waited for, nothing more is perceived; the source is closed in the background.
  /// From any thread; once is enough.
  void end();
  Closed closed() const;

 private:
  struct State;
  std::shared_ptr<State> state_;  ///< shared with the thread that closes it
};

}  // namespace handmap
