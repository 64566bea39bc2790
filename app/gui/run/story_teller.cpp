#include "app/gui/run/story_teller.h"

#include <utility>

namespace handmap {

namespace {

struct Answer {
  std::shared_ptr<const WallStory> story;  ///< nullptr: there was no memory for it
  bool kept = false;
};

Answer answerTo(const StoryTeller::Question& question) {
  try {
    const auto kept =
        question.tape ? question.tape->all() : std::vector<std::shared_ptr<const Perceived>>();
    std::vector<SeenScan> scans;
    for (const auto& perceived : kept) {
      scans.push_back({perceived->observation.time_s, &perceived->percept.scan});
    }
    return {std::make_shared<const WallStory>(storyOf(question.drawing, question.refined,
                                                      question.trajectory, scans, question.building,
                                                      question.wall)),
            !kept.empty()};
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

StoryTeller::StoryTeller(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<StoryTeller>>(*this)) {}

StoryTeller::~StoryTeller() { self_->cut(); }

void StoryTeller::ask(Question question) {
  const std::pair wall(question.building, question.wall);
  if (wall_ != wall) ++request_;
  wall_ = wall;
  if (busy_) {
    waiting_ = std::move(question);
  } else {
    begin(std::move(question));
  }
}

void StoryTeller::forget() {
  ++request_;
  wall_.reset();
  waiting_.reset();
}

void StoryTeller::begin(Question question) {
  busy_ = true;
  startInBackground([self = self_, request = request_, asked = std::move(question)] {
    self->post([request, answer = answerTo(asked)](StoryTeller& teller) {
      teller.busy_ = false;
      if (auto next = std::exchange(teller.waiting_, std::nullopt)) teller.begin(std::move(*next));
      if (request == teller.request_ && answer.story) Q_EMIT teller.told(answer.story, answer.kept);
    });
  });
}

}  // namespace handmap
