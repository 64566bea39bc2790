// What the monkey does: a sequence of steps, made from a seed, written as one line of text.
#pragma once

#include <QStringList>
#include <cstdint>
#include <vector>

namespace handmap {

enum class StepKind {
  Action,    ///< of the action table
  Simulate,  ///< an entry of the menu of simulators
  Stroke,    ///< press, move and release on the canvas
  Key,       ///< on the canvas
  Button,    ///< any button in the window
  Drop,      ///< a file or a folder
  Undo,
  Redo,
  Speed,   ///< of the run
  Seek,    ///< on the timeline
  Wait,    ///< a few milliseconds
  Settle,  ///< until the run is idle, not for long
  Sleep,   ///< without looking at events: what the run says piles up
  Close,   ///< the window, and open another
  Count
};

struct Step {
  StepKind kind = StepKind::Wait;
  std::uint32_t value = 0;  ///< chooses among what the kind can do, also the answers to dialogs
};

using Steps = std::vector<Step>;

Steps stepsOf(std::uint32_t seed);
/// E.g. "action:17 wait:3"; parsedSteps() takes it back. Throws std::invalid_argument.
QString inWords(const Steps& steps);
Steps parsedSteps(const QString& text);

}  // namespace handmap
