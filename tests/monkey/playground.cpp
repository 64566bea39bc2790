#include "tests/monkey/playground.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <thread>

#include <unistd.h>

#include "app/gui/run/result_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/window/application.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "widgets/actions/action_set.h"
#include "widgets/background/background.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {

namespace {

constexpr auto kPatience = std::chrono::seconds(60);
constexpr int kSettleMs = 300;
constexpr int kObservations = 6;  // of the recording
constexpr int kLarge = 2'000;     // buildings

template <typename Values>
auto chosen(const Values& values, std::uint32_t value) {
  return values[static_cast<decltype(std::size(values))>(value % std::size(values))];
}

Map largeMap() {
  Map map;
  map.start = Pose2{};
  for (int i = 0; i < kLarge; ++i) {
    Building building;
    building.id = std::to_string(i);
    const int row = i / 50;
    building.shape = Rectangle{{20.0 * (i % 50), 15.0 + 30.0 * row}, 15.0, 10.0, 0.0};
    map.buildings.push_back(building);
  }
  return map;
}

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
    qFatal("%s cannot be written", qPrintable(path));
  }
}

}  // namespace

/// Answers at once, as the step at work says.
class Playground::Answers : public Dialogs {
 public:
  explicit Answers(const Playground& playground) : playground_(playground) {}

  QString fileToOpen(const File&) override {
    return choose({"saved.handmap", "large.handmap", "empty.handmap", "locked/locked.handmap",
                   "torn.handmap", "gone.handmap", "photo.png", "torn.png"});
  }
  QString fileToSave(const File& file) override {
    if (playground_.value_ % 5 == 0) return QStringLiteral("/proc/none/x.") + file.suffix;
    return choose({"saved." + file.suffix, "new." + file.suffix, "below/new." + file.suffix,
                   "locked/new." + file.suffix});
  }
  QString folderToOpen(const QString&, const QString&) override {
    return choose({"recording", "nowhere", "."});
  }
  int choose(const Question& question) override {
    const auto answers = static_cast<std::uint32_t>(question.answers.size());
    return static_cast<int>(playground_.value_ % (answers + 1)) - 1;
  }
  QList<double> numbers(const QString&, const QList<Number>& lines) override {
    QList<double> values;
    if (playground_.value_ % 3 == 0) return values;
    for (const Number& line : lines) values << line.value;
    return values;
  }
  QString typedOrKnown(const QString&, const QString&, const QStringList&) override {
    return choose(QStringList{"photo.png", "gone.avi"});
  }

 private:
  QString choose(const QStringList& names) const {
    const QString name = chosen(names + QStringList{{}}, playground_.value_);
    return name.isEmpty() ? QString() : playground_.path(name);
  }

  const Playground& playground_;
};

Playground::Playground() : settings_(path("settings.ini"), QSettings::IniFormat) {
  qputenv("HOME", folder_.path().toUtf8());  // that of root is out of reach, see makeLockedFile()
  QObject::connect(&Application::instance(), &Application::failed, &Application::instance(),
                   [this](const QString& message) { thrown_ << message; });
}

Playground::~Playground() {
  Application::instance().disconnect();
  static_cast<void>(seteuid(getuid()));  // for the folder to be removed
}

void Playground::makeFiles() {
  const World world = twoRowWorld(3);
  writeMap(perturbed(world.map, 3.0, 3), path("saved.handmap").toStdString());
  writeMap({}, path("empty.handmap").toStdString());
  write(path("torn.handmap"), "{\"format\": \"handmap\",");
  QFile::remove(path("new.handmap"));
  if (QFile::exists(path("recording"))) return;
  QImage(300, 200, QImage::Format_RGB32).save(path("photo.png"));
  write(path("torn.png"), "\x89PNG\r\n");
  makeLockedFile();
  writeMap(largeMap(), path("large.handmap").toStdString());
  auto source = simulate(world, {}, 3);
  RecordingWriter writer(path("recording").toStdString(), source->info());
  for (int i = 0; i < kObservations; ++i) writer.add(source->next().value());
}

/// To be read only; root may write everywhere, so the program does not go on as root.
void Playground::makeLockedFile() {
  constexpr ::uid_t kNobody = 65534;
  QDir().mkpath(path("locked"));
  writeMap(twoRowWorld(4).map, path("locked/locked.handmap").toStdString());
  QFile::setPermissions(path("locked/locked.handmap"), QFile::ReadOwner | QFile::ReadOther);
  QFile::setPermissions(path("locked"),
                        QFile::ReadOwner | QFile::ExeOwner | QFile::ReadOther | QFile::ExeOther);
  if (geteuid() != 0) return;
  for (const QString& name : {QStringLiteral("."), QStringLiteral("saved.handmap"),
                              QStringLiteral("empty.handmap"), QStringLiteral("torn.handmap")}) {
    if (chown(qPrintable(path(name)), kNobody, kNobody) != 0) qFatal("chown %s", qPrintable(name));
  }
  if (setegid(kNobody) != 0 || seteuid(kNobody) != 0) qFatal("root stays root");
}

void Playground::openWindow() {
  document_ = std::make_unique<MapDocument>();
  window_ = std::make_unique<MainWindow>(*document_, settings_, std::make_unique<Answers>(*this));
  QObject::connect(document_.get(), &MapDocument::mapChanged, window_.get(),
                   [this] { noteBottom(); });
  window_->show();
  RunSetup setup = window_->runPanels().setup.setup();
  setup.settings.slam.slam_particles = 5;
  setup.settings.slam.pso_particles = 5;
  setup.settings.threads = 1;
  window_->runPanels().setup.setSetup(setup);
  noteBottom();
}

void Playground::noteBottom() {
  if (document_->undoStack().count() == 0) bottom_ = formatMap(document_->map());
}

void Playground::stroke(std::uint32_t value) {
  QWidget* on = window_->canvas().viewport();
  const auto at = [on](std::uint32_t x, std::uint32_t y) {
    return QPoint(static_cast<int>(x) % on->width(), static_cast<int>(y) % on->height());
  };
  const QPoint from = at(value * 7, value * 3);
  const QPoint to = at(value * 7 + value % 211, value * 3 + value % 97);
  const Qt::MouseButton button = value % 9 == 0 ? Qt::RightButton : Qt::LeftButton;
  QTest::mousePress(on, button, {}, from);
  QTest::mouseMove(on, (from + to) / 2);
  QTest::mouseMove(on, to);
  if (value % 7 != 0) QTest::mouseRelease(on, button, {}, to);
  if (value % 11 == 0) QTest::mouseDClick(on, button, {}, to);
}

void Playground::press(std::uint32_t value) {
  QList<QAbstractButton*> buttons;
  for (auto* button : window_->findChildren<QAbstractButton*>()) {
    const auto* tool = qobject_cast<QToolButton*>(button);
    const bool opens_menu = tool != nullptr && (tool->menu() != nullptr ||
                                                tool->objectName() == "qt_toolbar_ext_button");
    // The panel for teaching asks for files by itself.
    if (button->isVisible() && button->isEnabled() && !opens_menu &&
        !window_->teach().isAncestorOf(button)) {
      buttons << button;
    }
  }
  if (!buttons.isEmpty()) chosen(buttons, value)->click();
}

void Playground::drop(const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  QDropEvent event(QPointF(10.0, 10.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &event);
}

void Playground::settle() {
  static_cast<void>(QTest::qWaitFor([this] { return !window_->run().isActive(); }, kSettleMs));
}

void Playground::take(const Step& step) {
  static constexpr int kKeys[] = {Qt::Key_Escape, Qt::Key_Backspace, Qt::Key_Return,
                                  Qt::Key_Delete, Qt::Key_Left,      Qt::Key_Space};
  value_ = step.value;
  switch (step.kind) {
    case StepKind::Action:
      return window_->findChild<QAction*>(QLatin1String(chosen(actionTable(), value_).id))
          ->trigger();
    case StepKind::Simulate:
      return chosen(window_->findChild<QAction*>("run.simulator")->menu()->actions(), value_)
          ->trigger();
    case StepKind::Stroke:
      return stroke(value_);
    case StepKind::Key:
      return QTest::keyClick(&window_->canvas(), static_cast<Qt::Key>(chosen(kKeys, value_)));
    case StepKind::Button:
      return press(value_);
    case StepKind::Drop:
      return drop(path(chosen(QStringList{"recording", "saved.handmap", "locked/locked.handmap",
                                          "torn.handmap", ".", "photo.png", "torn.png"},
                              value_)));
    case StepKind::Undo:
      return document_->undoStack().undo();
    case StepKind::Redo:
      return document_->undoStack().redo();
    case StepKind::Speed:
      return window_->transport().setSpeed(chosen(std::array{0.0, 1.0, 10.0}, value_));
    case StepKind::Seek: {
      Timeline& timeline = window_->transport().timeline();
      constexpr std::uint32_t kBeyond = 3;
      const auto count = static_cast<std::uint32_t>(timeline.maximum()) + kBeyond;
      Q_EMIT timeline.seekWanted(static_cast<int>(value_ % count));
      return;
    }
    case StepKind::Wait:
      return QTest::qWait(static_cast<int>(value_ % 20));
    case StepKind::Settle:
      return settle();
    case StepKind::Sleep:
      return std::this_thread::sleep_for(std::chrono::milliseconds(value_ % 30));
    case StepKind::Close:
      if (!window_->close()) return;
      window_.reset();
      return openWindow();
    case StepKind::Count:
      return;
  }
}

QString Playground::checked() {
  QUndoStack& undo = document_->undoStack();
  const std::string top = formatMap(document_->map());
  const int index = undo.index();
  undo.setIndex(0);
  if (formatMap(document_->map()) != bottom_) return "undo to the bottom gives another map";
  undo.setIndex(index);
  if (formatMap(document_->map()) != top) return "redo to where it was gives another map";
  window_.reset();
  if (!waitForBackground(kPatience)) return "a thread is left";
  QCoreApplication::sendPostedEvents();
  QCoreApplication::processEvents();
  if (!thrown_.isEmpty()) return "thrown by a slot: " + thrown_.join("; ");
  return {};
}

QString Playground::play(const Steps& steps) {
  thrown_.clear();
  makeFiles();
  openWindow();
  for (const Step& step : steps) {
    // By an event, as everything that a person does.
    QMetaObject::invokeMethod(
        qApp, [this, step] { take(step); }, Qt::QueuedConnection);
    QCoreApplication::processEvents();
  }
  return checked();
}

}  // namespace handmap
