// Every command in every moment of a run: it does something that one sees, or it is disabled and
// says why.
#include <QClipboard>
#include <QImage>
#include <QSet>
#include <functional>

#include "app/gui/files/file_actions.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/actions/action_set.h"
#include "widgets/actions/action_table.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {
namespace {

constexpr int kObservations = 12;
constexpr int kSoonMs = 2000;

/// What one sees of the program, and what it has done elsewhere.
struct Sight {
  QImage window;
  QStringList others;  ///< windows and menus
  QStringList asked;
  int messages = 0;
  int opened = 0;
  QString clipboard;
  bool operator==(const Sight&) const = default;
};

class Moments : public WindowTest {
 protected:
  Moments() { reopen(); }
  ~Moments() override {
    document_.undoStack().setClean();
    waitForBackground(std::chrono::seconds(30));
  }

  void reopen() {
    window_.reset();
    waitForBackground(std::chrono::seconds(30));
    document_.reset({});
    settings_.clear();
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->resize(1280, 800);
    window_->show();
    window_->files().setWindowOpener([this](const QStringList&) { ++opened_; });
    QObject::connect(&window_->messages(), &MessageBar::shown, window_.get(), [this] { ++told_; });
    RunSetup setup;
    setup.settings.slam.slam_particles = 5;
    setup.settings.slam.pso_particles = 5;
    window_->runPanels().setup.setSetup(setup);
    window_->transport().setSpeed(0.0);
  }

  void draw() {
    world_ = twoRowWorld(3);
    document_.reset(perturbed(world_.map, 3.0, 3));
    Q_EMIT window_->files().drawingReplaced();
  }
  void openRecording() {
    draw();
    if (!QFile::exists(path("drive"))) {
      auto source = simulate(world_, {}, 3);
      RecordingWriter writer(path("drive").toStdString(), source->info());
      for (int i = 0; i < kObservations; ++i) writer.add(*source->next());
    }
    window_->sources().openRecording(path("drive"));
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return window_->sources().robot().has_value(); }, kPatienceMs));
  }
  void pause() {
    openRecording();
    for (int i = 0; i < 2; ++i) {
      action(*window_, "run.step")->trigger();
      ASSERT_TRUE(waitFor(*window_, RunState::Paused));
    }
  }
  void run() {
    pause();
    window_->transport().setSpeed(0.1);
    window_->runs().runOrResume();
    ASSERT_TRUE(waitFor(*window_, RunState::Running));
  }
  void finish() {
    openRecording();
    window_->runs().runOrResume();
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return window_->run().result() && !window_->run().isActive(); }, kPatienceMs));
  }
  void accept() {
    finish();
    action(*window_, "run.accept")->trigger();
  }
  void takeBack() {
    accept();
    action(*window_, "edit.undo")->trigger();
  }

  Sight sight() {
    Sight sight{window_->grab().toImage(),        {}, dialogs_->asked, told_, opened_,
                QApplication::clipboard()->text()};
    for (const ActionSpec& spec : actionTable())  // its tick in the menu
      if (action(*window_, spec.id)->isChecked()) sight.others << spec.id;
    for (const QWidget* widget : QApplication::topLevelWidgets())
      if (widget->isVisible()) sight.others << widget->metaObject()->className();
    sight.others.sort();
    return sight;
  }
  void closeOthers() {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget != window_.get() && widget->isVisible()) widget->close();
    QCoreApplication::processEvents();
  }

  /// The commands that one may give now and of which one sees nothing.
  QStringList silent(const std::function<void()>& moment) {
    static const QSet<QString> kEndsIt{"file.quit", "view.language_ja", "view.language_en",
                                       "view.language_system"};
    QStringList silent;
    reopen();
    moment();
    for (const ActionSpec& spec : actionTable()) {
      const QString id = QLatin1String(spec.id);
      QAction* command = action(*window_, id);
      const bool is_told =
          command->isEnabled() || !command->property("why_not").toString().isEmpty();
      EXPECT_TRUE(is_told) << spec.id;
      const bool is_chosen = command->actionGroup() != nullptr && command->isChecked();
      if (kEndsIt.contains(id) || is_chosen || !command->isEnabled() || !command->isVisible())
        continue;
      const Map drawn = document_.map();
      QUndoStack& undo = document_.undoStack();
      const int steps = undo.index();
      const int run = window_->run().number();
      const RunState state = window_->run().state();
      window_->canvas().zoomToFit();
      window_->canvas().zoomIn();  // so that there is something to fit
      QApplication::clipboard()->clear();
      QCoreApplication::processEvents();
      const Sight before = sight();
      command->trigger();
      if (!QTest::qWaitFor([&] { return sight() != before; }, kSoonMs)) silent << id;
      closeOthers();
      while (undo.index() > steps) undo.undo();
      if (drawn == document_.map() && run == window_->run().number() &&
          state == window_->run().state() && !window_->run().isRevising())
        continue;
      reopen();
      moment();
    }
    return silent;
  }

  World world_;
  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
  int opened_ = 0;
  int told_ = 0;
};

TEST_F(Moments, BeforeADrawing) {
  EXPECT_EQ(silent([] {}).join(", ").toStdString(), "");
}
TEST_F(Moments, WithADrawing) {
  EXPECT_EQ(silent([this] { draw(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WithARecording) {
  EXPECT_EQ(silent([this] { openRecording(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WhileItRuns) {
  EXPECT_EQ(silent([this] { run(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WhileItStandsStill) {
  EXPECT_EQ(silent([this] { pause(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WhenItIsDone) {
  EXPECT_EQ(silent([this] { finish(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WhenItIsAccepted) {
  EXPECT_EQ(silent([this] { accept(); }).join(", ").toStdString(), "");
}
TEST_F(Moments, WhenItIsTakenBack) {
  EXPECT_EQ(silent([this] { takeBack(); }).join(", ").toStdString(), "");
}

}  // namespace
}  // namespace handmap
