// Finds out, in a thread of its own, why a wall stands where it does.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <utility>

#include "core/explain/wall_story.h"
#include "core/tape/tape.h"
#include "widgets/background/background.h"

namespace handmap {

class StoryTeller : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(StoryTeller)
 public:
  /// Copies of all that the answer needs.
  struct Question {
    Map drawing;
    Map refined;
    std::vector<StampedPose> trajectory;
    std::shared_ptr<const Tape> tape;  ///< nullptr: nothing that was seen is kept
    std::size_t building;
    std::size_t wall;
  };
  explicit StoryTeller(QObject* parent = nullptr);
  ~StoryTeller() override;

  /// While one is being answered only the latest other one waits.
  void ask(Question question);
  void forget();

 Q_SIGNALS:
  /// To the latest question. `kept`: what was seen is still there.
  void told(const std::shared_ptr<const handmap::WallStory>& story, bool kept);

 private:
  void begin(Question question);

  int request_ = 0;  ///< counts the walls; an answer about another one is dropped
  std::optional<std::pair<std::size_t, std::size_t>> wall_;  ///< building and wall of the latest
  bool busy_ = false;
  std::optional<Question> waiting_;
  std::shared_ptr<Lifeline<StoryTeller>> self_;  ///< shared with the thread
};

}  // namespace handmap
