// The six buildings of the two rows, by keyboard alone and by fingers alone, with every step
// counted.
#include <QMenu>
#include <QPointingDevice>
#include <QToolBar>
#include <QToolButton>
#include <array>

#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {
namespace {

struct Drawn {
  const char* name;
  double left, bottom, width, depth;
};
constexpr std::array<Drawn, 6> kTwoRows = {{{"Library", 2.7, 6.2, 65.8, 21.0},
                                            {"Main hall", 97.4, 3.7, 39.2, 14.3},
                                            {"Workshop", 161.1, 15.3, 45.9, 18.2},
                                            {"Canteen", -6.4, -31.3, 40.6, 22.0},
                                            {"Laboratories", 64.8, -29.6, 55.5, 18.1},
                                            {"Dormitory", 145.6, -25.7, 59.4, 15.0}}};

class DrawingJourney : public WindowTest {
 protected:
  void SetUp() override {
    settings_.setValue("welcome/closed", true);
    window_ = open();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    canvas_ = &window_->canvas();
    canvas_->setFocus();
  }

  // --- Keys, to whatever has the focus
  void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ++steps_;
    QTest::keyClick(QApplication::focusWidget(), static_cast<Qt::Key>(key), modifiers);
  }
  void type(const QString& text) {
    for (const QChar character : text) {
      ++steps_;
      QTest::keyClick(QApplication::focusWidget(), character.toLatin1());
    }
  }
  void number(double value) {
    type(QString::number(std::abs(value)));
    if (value < 0) type("-");
  }
  void numbers(double first, double second) {
    number(first);
    press(Qt::Key_Tab);
    number(second);
    press(Qt::Key_Return);
  }

  // --- Fingers
  QPoint pixels(double x, double y) const {
    return canvas_->viewportTransform().map(QPointF(x, y)).toPoint();
  }
  void stroke(QWidget* on, QPoint from, QPoint to) {
    ++steps_;
    QTest::touchEvent(on, finger_).press(0, from);
    if (from != to) {
      QTest::touchEvent(on, finger_).move(0, (from + to) / 2);
      QTest::touchEvent(on, finger_).move(0, to);
    }
    QTest::touchEvent(on, finger_).release(0, to);
  }
  void tap(QWidget* on) { stroke(on, on->rect().center(), on->rect().center()); }
  void tapCanvas(double x, double y) {
    stroke(canvas_->viewport(), pixels(x, y), pixels(x, y));
    QTest::qWait(450);  // slower than a double tap
  }
  void takeTool(const char* id) {
    for (auto* bar : window_->findChildren<QToolBar*>())
      if (QWidget* button = bar->widgetForAction(action(*window_, id))) return tap(button);
    FAIL() << "no button for " << id;
  }
  void pinch(double factor) {
    ++steps_;
    QWidget* on = canvas_->viewport();
    const QPoint centre = on->rect().center();
    const auto reach = [&](double share) {
      return QPoint(static_cast<int>(200.0 * (1.0 + share * (factor - 1.0))), 0);
    };
    QTest::touchEvent(on, finger_).press(0, centre - reach(0));
    QTest::touchEvent(on, finger_).move(0, centre - reach(0)).press(1, centre + reach(0));
    for (int i = 1; i <= 10; ++i)
      QTest::touchEvent(on, finger_)
          .move(0, centre - reach(i / 10.0))
          .move(1, centre + reach(i / 10.0));
    QTest::touchEvent(on, finger_).release(0, centre - reach(1)).release(1, centre + reach(1));
  }

  const Map& map() const { return document_.map(); }

  std::unique_ptr<MainWindow> window_;
  MapCanvas* canvas_ = nullptr;
  QPointingDevice* finger_ = QTest::createTouchDevice();
  int steps_ = 0;
};

TEST_F(DrawingJourney, TheTwoRowsByKeyboardAlone) {
  press(Qt::Key_R);
  for (const Drawn& drawn : kTwoRows) {
    numbers(drawn.left, drawn.bottom);
    numbers(drawn.width, drawn.depth);
    type(drawn.name);
    press(Qt::Key_Return);
  }
  ASSERT_EQ(map().buildings.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Drawn& drawn = kTwoRows[i];
    EXPECT_EQ(map().buildings[i].name, drawn.name);
    const Bounds box = boundsOf(map().buildings[i]);
    EXPECT_LT((box.low - Vec2(drawn.left, drawn.bottom)).norm(), 1e-6) << drawn.name;
    EXPECT_LT((box.high - box.low - Vec2(drawn.width, drawn.depth)).norm(), 1e-6) << drawn.name;
  }
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_Q);
  press(Qt::Key_T);
  numbers(0, 0);
  number(0);
  press(Qt::Key_Return);
  ASSERT_TRUE(map().start);
  EXPECT_EQ(*map().start, (Pose2{0, 0, 0}));
  press(Qt::Key_F);
  RecordProperty("keys", steps_);
  EXPECT_LE(steps_, 250);
  std::printf("six buildings, named, and the start by keyboard: %d keys\n", steps_);
}

TEST_F(DrawingJourney, TheTwoRowsByArrowKeysAlone) {
  press(Qt::Key_R);
  for (const Drawn& drawn : kTwoRows) {
    // From where the cursor is to each corner: ten strides, one, and a tenth.
    for (const Vec2& corner : {Vec2(drawn.left, drawn.bottom),
                               Vec2(drawn.left + drawn.width, drawn.bottom + drawn.depth)}) {
      press(Qt::Key_Right);
      for (int round = 0; round < 400; ++round) {
        const Vec2 way = corner - *canvas_->currentTool().keyboardCursor();
        const int axis = std::abs(way.x()) > std::abs(way.y()) ? 0 : 1;
        if (std::abs(way[axis]) < 0.6) break;
        const int key = axis == 0 ? (way.x() > 0 ? Qt::Key_Right : Qt::Key_Left)
                                  : (way.y() > 0 ? Qt::Key_Up : Qt::Key_Down);
        const double far = std::abs(way[axis]);
        press(key, far >= 10 ? Qt::ShiftModifier : far >= 1 ? Qt::NoModifier : Qt::ControlModifier);
      }
      press(Qt::Key_Return);
    }
    press(Qt::Key_Escape);
    press(Qt::Key_R);
  }
  ASSERT_EQ(map().buildings.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Bounds box = boundsOf(map().buildings[i]);
    EXPECT_LT((box.low - Vec2(kTwoRows[i].left, kTwoRows[i].bottom)).norm(), 1.5);
  }
  std::printf("six buildings by arrow keys: %d keys\n", steps_);
}

TEST_F(DrawingJourney, TheTwoRowsByFingersAlone) {
  pinch(0.25);
  takeTool("draw.rectangle");
  for (const Drawn& drawn : kTwoRows)
    stroke(canvas_->viewport(), pixels(drawn.left, drawn.bottom),
           pixels(drawn.left + drawn.width, drawn.bottom + drawn.depth));
  ASSERT_EQ(map().buildings.size(), 6u)
      << "shown: " << canvas_->visibleMetres().left() << " to " << canvas_->visibleMetres().right()
      << " m, " << canvas_->visibleMetres().top() << " to " << canvas_->visibleMetres().bottom();
  for (std::size_t i = 0; i < 6; ++i) {
    const Bounds box = boundsOf(map().buildings[i]);
    EXPECT_LT((box.low - Vec2(kTwoRows[i].left, kTwoRows[i].bottom)).norm(),
              6.0);  // a finger, and what it snaps to
  }
  takeTool("draw.start");
  stroke(canvas_->viewport(), pixels(0, 0), pixels(20, 0));
  ASSERT_TRUE(map().start);
  EXPECT_LT(std::abs(map().start->heading), toRadians(2.0));
  const int six = steps_;
  // A corner-by-corner building ends with the chip on the canvas.
  takeTool("draw.polygon");
  for (const Vec2& corner : {Vec2(0, 40), Vec2(40, 40), Vec2(40, 60), Vec2(20, 60), Vec2(20, 80)})
    tapCanvas(corner.x(), corner.y());
  tap(canvas_->findChild<QToolButton*>("back_chip"));
  tap(canvas_->findChild<QToolButton*>("done_chip"));
  ASSERT_EQ(map().buildings.size(), 7u);
  EXPECT_EQ(map().buildings[6].footprint().size(), 4u);
  EXPECT_LE(six, 12);
  std::printf("six buildings and the start by fingers: %d strokes and taps\n", six);
}

}  // namespace
}  // namespace handmap
