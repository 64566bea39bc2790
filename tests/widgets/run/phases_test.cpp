// Going through the phases of an observation, and their words.
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "widgets/run/words/phase_words.h"
#include "widgets/run/worker/phase_stepper.h"

namespace handmap {
namespace {

std::shared_ptr<const Snapshot> withPhases(std::vector<PhaseKind> kinds) {
  auto phases = std::make_shared<std::vector<Phase>>();
  for (const PhaseKind kind : kinds) phases->push_back({kind, {}, {}, {}, {}, {}});
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->phases = std::move(phases);
  return snapshot;
}

struct Listener {
  explicit Listener(PhaseStepper& stepper) {
    QObject::connect(&stepper, &PhaseStepper::shown, &stepper,
                     [this](const Phase& phase, int number, int count) {
                       kinds.push_back(phase.kind);
                       EXPECT_EQ(number, static_cast<int>(kinds.size()));
                       EXPECT_EQ(count, 2);
                     });
    QObject::connect(&stepper, &PhaseStepper::ended, &stepper,
                     [this](const auto& snapshot) { whole = snapshot; });
  }
  std::vector<PhaseKind> kinds;
  std::shared_ptr<const Snapshot> whole;
};

TEST(PhaseStepper, GoesThroughAllOfThemAndEndsWithTheWhole) {
  PhaseStepper stepper;
  Listener heard(stepper);
  const auto snapshot = withPhases({PhaseKind::Way, PhaseKind::Poses});
  stepper.begin(snapshot);
  EXPECT_TRUE(stepper.isActive());
  stepper.next();
  EXPECT_EQ(heard.kinds, (std::vector{PhaseKind::Way, PhaseKind::Poses}));
  EXPECT_FALSE(heard.whole);
  stepper.next();
  EXPECT_EQ(heard.whole, snapshot);
  EXPECT_FALSE(stepper.isActive());
  stepper.next();  // nothing to go through
  EXPECT_EQ(heard.kinds.size(), 2U);
}

TEST(PhaseStepper, WithoutPhasesTheWholeIsShownAtOnce) {
  PhaseStepper stepper;
  Listener heard(stepper);
  const auto snapshot = withPhases({});
  stepper.begin(snapshot);
  EXPECT_EQ(heard.whole, snapshot);
  EXPECT_FALSE(stepper.isActive());
}

TEST(PhaseStepper, IsLeftOnTheWay) {
  PhaseStepper stepper;
  Listener heard(stepper);
  stepper.begin(withPhases({PhaseKind::Way, PhaseKind::Poses}));
  stepper.leave();
  stepper.next();
  EXPECT_EQ(heard.kinds.size(), 1U);
  EXPECT_FALSE(heard.whole);
}

TEST(PhaseWords, NameThePhaseAndWhatItChanged) {
  Phase phase;
  phase.kind = PhaseKind::Swarms;
  phase.facts = {3, 10, 2, 0, 0.42, 0.0, 12.34, false};
  EXPECT_EQ(PhaseWords::name(phase), "Swarms 3/10");
  EXPECT_EQ(PhaseWords::change(phase), "The best outlines moved by up to 0.42 m; score 12.3.");
  phase.kind = PhaseKind::Resampling;
  phase.facts = {0, 0, 31, 100, 0.0, 0.0, 0.0, true};
  EXPECT_EQ(PhaseWords::change(phase), "31 of 100 particles stay, the heavy ones more than once.");
  phase.facts.happened = false;
  EXPECT_EQ(PhaseWords::change(phase), "Not due: enough particles count. All 100 stay.");
}

TEST(PhaseWords, EveryKindHasWordsOfItsOwn) {
  QStringList names;
  QStringList changes;
  for (const PhaseKind kind :
       {PhaseKind::Prediction, PhaseKind::LocalMap, PhaseKind::Swarms, PhaseKind::Weights,
        PhaseKind::Resampling, PhaseKind::Way, PhaseKind::Poses, PhaseKind::Evidence,
        PhaseKind::Detection, PhaseKind::Labels, PhaseKind::Correction}) {
    Phase phase;
    phase.kind = kind;
    names << PhaseWords::name(phase);
    changes << PhaseWords::change(phase);
    EXPECT_FALSE(changes.back().contains('%')) << changes.back().toStdString();
  }
  EXPECT_EQ(names.removeDuplicates(), 0);
  EXPECT_EQ(changes.removeDuplicates(), 0);
}

}  // namespace
}  // namespace handmap
