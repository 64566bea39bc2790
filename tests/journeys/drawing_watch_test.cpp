// A drawing that cannot be what it says, in the window: told at the run, and read as it is meant.
#include <QPushButton>

#include <gtest/gtest.h>

#include "core/simulation/simulated_source.h"
#include "tests/journeys/window_test.h"
#include "widgets/editing/arranging.h"

namespace handmap {
namespace {

class DrawingWatchTest : public WindowTest {
 protected:
  DrawingWatchTest() {
    auto source = simulate(world_, {}, 2);
    RecordingWriter writer(path("drive").toStdString(), source->info());
    while (auto observation = source->next()) writer.add(*observation);
  }
  /// What is said of a run with this drawing; the button is pressed and the run done again.
  QString saidOf(const MapChange& change, const QString& button) {
    document_.reset(world_.map);
    document_.apply(change, "wrong");
    const auto window = open();
    window->sources().openRecording(path("drive"));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return window->sources().robot().has_value(); }, kPatienceMs));
    window->transport().setSpeed(0.0);
    window->runs().runOrResume();
    QPushButton* remedy = nullptr;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          for (auto* found : window->messages().findChildren<QPushButton*>()) {
            if (found->text() == button) remedy = found;
          }
          return remedy != nullptr;
        },
        kPatienceMs));
    const QString said = message(*window);
    if (remedy == nullptr) return said;
    remedy->click();
    EXPECT_TRUE(waitFor(*window, RunState::Idle));
    window->runs().runOrResume();
    QTest::qWait(500);
    EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
    QTest::qWait(50);
    EXPECT_FALSE(message(*window).contains("expected metres")) << message(*window).toStdString();
    EXPECT_FALSE(message(*window).contains("expected y up")) << message(*window).toStdString();
    window->run().discard();
    return said;
  }

  const World world_ = campusWorld(2);
};

TEST_F(DrawingWatchTest, OneInMillimetresIsSaidAndReadSo) {
  const QString said = saidOf(scaled(world_.map, 1000.0), "Read the drawing as millimetres");
  EXPECT_TRUE(said.contains("found half of them longer than")) << said.toStdString();
  const Rectangle box = document_.map().buildings[0].box();
  EXPECT_NEAR(box.width, world_.map.buildings[0].box().width, 1e-6);
  EXPECT_NEAR(document_.map().start->x, world_.map.start->x, 1e-6);
}

TEST_F(DrawingWatchTest, OneWithYDownIsSaidAndMirrored) {
  const QString said =
      saidOf(mirrored(world_.map, allKeys(world_.map), Along::Y), "Mirror the drawing");
  EXPECT_TRUE(said.contains("expected y up")) << said.toStdString();
}

}  // namespace
}  // namespace handmap
