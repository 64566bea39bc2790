#include "app/gui/run/story_teller.h"

#include <deque>
#include <utility>

namespace handmap {

namespace {

/// Some 40 MB for a moment. Of an hour every ninth: looks from one metre of the way are one look.
constexpr std::size_t kMostScans = 4096;

struct Answer {
  std::shared_ptr<const WallStory> story;  ///< nullptr: there was no memory for it
  bool kept = false;
};

Answer answerTo(const StoryTeller::Question& question) {
  try {
    std::deque<Scan> kept;
    std::vector<SeenScan> scans;
    const std::size_t end = question.tape ? question.tape->end() : 0;
    for (std::size_t n = question.tape ? question.tape->begin() : 0; n < end;
         n += end / kMostScans + 1) {
      const auto perceived = question.tape->at(n);
      if (!perceived) continue;
      kept.push_back(perceived->percept.scan);
      scans.push_back({perceived->observation.time_s, &kept.back()});
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
