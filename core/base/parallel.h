// Work divided over threads: by oneTBB, or, in a build with HANDMAP_PLAIN_THREADS, by std::thread.
// The thread sanitizer knows nothing of how a oneTBB that is not built with it orders the work of
// one thread before that of another; of plain threads it sees all, so that its verdict counts.
#pragma once

#include <algorithm>
#include <cstddef>

#ifdef HANDMAP_PLAIN_THREADS
#include "core/base/plain_threads.h"
#else
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace handmap {

#ifdef HANDMAP_PLAIN_THREADS

using Arena = plain::Arena;
template <typename Value>
using PerThread = plain::PerThread<Value>;

#else

/// A value for each thread that asks for its local(); made when it first does.
template <typename Value>
using PerThread = tbb::enumerable_thread_specific<Value>;

/// Where work may be divided over a number of threads.
class Arena {
 public:
  /// 0: as many as the machine has.
  explicit Arena(int threads) : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {}

  /// What `work` divides, it divides over these threads. Gives what it returns.
  template <typename Work>
  auto execute(Work&& work) {
    return arena_.execute(std::forward<Work>(work));
  }

 private:
  tbb::task_arena arena_;
};

#endif

/// body(i) for i = 0 … count − 1, in any order, several at a time. When one throws, the others may
/// be left out, and the exception is passed on.
template <typename Body>
void parallelFor(std::size_t count, const Body& body) {
#ifdef HANDMAP_PLAIN_THREADS
  plain::parallelFor(count, body);
#else
  tbb::parallel_for(std::size_t{0}, count, body);
#endif
}

/// body(begin, end) for 0 … count, cut into stretches of so many; the same as above otherwise.
template <typename Body>
void parallelStretches(int count, int length, const Body& body) {
  const int stretches = (count + length - 1) / length;
  parallelFor(static_cast<std::size_t>(stretches), [&](std::size_t i) {
    const int begin = static_cast<int>(i) * length;
    body(begin, std::min(begin + length, count));
  });
}

}  // namespace handmap
