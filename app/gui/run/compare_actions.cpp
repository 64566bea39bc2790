#include "app/gui/run/compare_actions.h"

#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <algorithm>
#include <chrono>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/shell/docks.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "widgets/actions/action_set.h"
#include "widgets/background/failure.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/comparing/comparison_panel.h"
#include "widgets/comparing/error_arrows_item.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

constexpr auto kTruthFolderKey = "compare/folder";
constexpr auto kCompareTopic = "compare";
constexpr auto kUpdateAfter = std::chrono::milliseconds(300);  // of a change, and those after it
constexpr int kFewestInCommon = 3;

int inCommon(const std::vector<SketchPair>& pairs) {
  return static_cast<int>(
      std::ranges::count_if(pairs, [](const SketchPair& pair) { return pair.drawn.has_value(); }));
}

}  // namespace

CompareActions::CompareActions(const Shell& shell, MapDocument& document, MapCanvas& canvas,
                               FileActions& files, const SourceActions& sources, RunController& run,
                               QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      files_(files),
      sources_(sources),
      run_(run),
      arrows_(new ErrorArrowsItem),
      panel_(new ComparisonPanel) {
  const QDockWidget& dock = shell_.docks.add(
      {"comparison", tr("Comparison"), Docks::Group::Drawing, Docks::When::Now}, panel_);
  connect(dock.toggleViewAction(), &QAction::toggled, this, [this](bool shown) {
    if (!shown && shell_.docks.isOpen()) end();  // closed, not folded away
  });
  connect(panel_, &ComparisonPanel::saveRequested, this, &CompareActions::save);
  connect(panel_, &ComparisonPanel::otherTruthRequested, this, &CompareActions::ask);
  constexpr double kAboveTheRun = 50.0;
  arrows_->setZValue(kOverlayZ + kAboveTheRun);
  canvas.scene()->addItem(arrows_);
  soon_.setSingleShot(true);
  soon_.setInterval(kUpdateAfter);
  connect(&soon_, &QTimer::timeout, this, &CompareActions::update);
  connect(&document_, &MapDocument::mapChanged, this, &CompareActions::updateSoon);
  connect(&run_, &RunController::newsArrived, this, &CompareActions::updateSoon);
  connect(&run_, &RunController::stateChanged, this, &CompareActions::updateSoon);
  connect(&files_, &FileActions::drawingReplaced, this, &CompareActions::end);
  shell_.actions.on("file.compare", this, [this] { begin(); });
}

void CompareActions::begin() {
  const auto& robot = sources_.robot();
  if (robot && robot->truth_map)
    return compare(*robot->truth_map, tr("the truth of the simulator"));
  const QString beside = robot && !robot->folder.isEmpty()
                             ? robot->folder + QStringLiteral("/truth.handmap")
                             : QString();
  if (!beside.isEmpty() && QFile::exists(beside)) return open(beside);
  ask();
}

void CompareActions::ask() {
  const QString path = shell_.dialogs.fileToOpen(
      {tr("Open the true map"),
       shell_.settings.value(kTruthFolderKey, QFileInfo(document_.filePath()).path()).toString(),
       FileActions::mapFilter(),
       {},
       {}});
  if (path.isEmpty()) return;
  shell_.settings.setValue(kTruthFolderKey, QFileInfo(path).path());
  open(path);
}

void CompareActions::open(const QString& path) {
  try {
    compare(readMap(QFile::encodeName(path).toStdString()),
            tr("“%1”").arg(QFileInfo(path).fileName()));
  } catch (const Error& error) {
    const Failure failure = failureOf(error);
    shell_.messages.show(MessageBar::Kind::Error, failure.message, failure.hint, kCompareTopic);
  }
}

void CompareActions::compare(const Map& truth, const QString& name) {
  const int common = inCommon(pairsOf({{}, document_.map(), truth, {}}));
  if (common < kFewestInCommon) {
    shell_.messages
        .show(MessageBar::Kind::Warning,
              tr("The drawing and %1 have too little in common: %n building(s) or landmark(s), and "
                 "three are needed.",
                 nullptr, common)
                  .arg(name),
              tr("They are matched by the id that the file has, not by name."), kCompareTopic)
        .addAction(tr("Another true map…"), [this] { ask(); });
    return;
  }
  shell_.messages.withdraw(kCompareTopic);
  truth_ = truth;
  truth_name_ = name;
  update();
  shell_.docks.setPossible(*panel_, true);
  shell_.docks.show(*panel_);
}

void CompareActions::updateSoon() {
  if (truth_ && !soon_.isActive()) soon_.start();
}

void CompareActions::update() {
  if (!truth_) return;
  const QString path = document_.filePath();
  const std::string name = (path.isEmpty() ? document_.displayName() : path).toStdString();
  const Sketch drawn = sketchOf(name, document_.map(), *truth_);
  std::vector<SketchFigures> columns{figuresOf(drawn)};
  if (const auto result = run_.result()) {
    columns.push_back(figuresOf(sketchOf(name, result->map(), *truth_), "corrected"));
  }
  panel_->setFigures(truth_name_, columns);
  arrows_->setPairs(pairsOf(drawn));
}

void CompareActions::end() {
  truth_.reset();
  arrows_->clear();
  shell_.docks.setPossible(*panel_, false);
}

void CompareActions::save() {
  const QString base = QFileInfo(document_.displayName()).completeBaseName();
  files_.exportAs({tr("Save the figures"), base + tr("-figures") + QStringLiteral(".csv"),
                   tr("Tables (*.csv)"), QStringLiteral("csv"), tr("The table of figures")},
                  [this](const QString& path) {
                    writeFileAtomically(QFile::encodeName(path).toStdString(), panel_->table());
                  });
}

}  // namespace handmap
