#include "app/gui/editing/edit_actions.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "core/base/error.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/editing/arranging.h"
#include "widgets/editing/clipboard.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

namespace {

constexpr auto kRecognizeKey = "draw/recognize";
constexpr auto kArrangedTopic = "arranged";
constexpr auto kSnapGridKey = "draw/snap_grid";
constexpr auto kSnapObjectsKey = "draw/snap_objects";
constexpr double kDuplicatePx = 24.0;  // so far from the original

}  // namespace

EditActions::EditActions(const Shell& shell, MapDocument& document, MapCanvas& canvas,
                         Toolbox& tools, QObject* parent)
    : QObject(parent), shell_(shell), document_(document), canvas_(canvas), tools_(tools) {
  QUndoStack& undo = document_.undoStack();
  const ActionSet& actions = shell_.actions;
  actions.on("edit.undo", &undo, [&undo] { undo.undo(); });
  actions.on("edit.redo", &undo, [&undo] { undo.redo(); });
  actions.on("edit.delete", this, [this] { canvas_.deleteSelected(); });
  actions.on("edit.select_all", this, [this] { document_.selectAll(); });
  actions.on("edit.rename", this, [this] { canvas_.renameSelected(); });
  actions.on("edit.add_corner", this, [this] { tools_.addCorner(); });
  connectClipboard();
  connectArranging();
  connectSnapping();
  connect(&undo, &QUndoStack::indexChanged, this, &EditActions::updateEnabled);
  connect(&document_, &MapDocument::mapChanged, this, &EditActions::updateEnabled);
  connect(&document_, &MapDocument::selectionChanged, this, &EditActions::updateEnabled);
  connect(&canvas_, &MapCanvas::contextMenuRequested, this, &EditActions::showMenu);
  updateEnabled();
}

void EditActions::connectClipboard() {
  const ActionSet& actions = shell_.actions;
  actions.on("edit.copy", this, [this] { copy(); });
  actions.on("edit.cut", this, [this] {
    copy();
    document_.removeSelected();
  });
  actions.on("edit.paste", this, [this] { paste(); });
  actions.on("edit.duplicate", this, [this] { duplicate(); });
}

void EditActions::connectArranging() {
  arrangeBy("arrange.lock", lockToggled);
  arrangeBy("arrange.square",
            [](const Map& map, const QStringList& keys) { return squaredUp(map, keys); });
  arrangeBy("arrange.parallel", madeParallel);
  arrangeBy("arrange.polygon", asPolygons);
  for (const auto& [id, clockwise] :
       {std::pair("edit.rotate_left", false), std::pair("edit.rotate_right", true)})
    arrangeBy(id, [clockwise = clockwise](const Map& map, const QStringList& keys) {
      return turnedByQuarter(map, keys, clockwise);
    });
  for (const auto& [id, along] :
       {std::pair("edit.mirror_x", Along::X), std::pair("edit.mirror_y", Along::Y)})
    arrangeBy(id, [along = along](const Map& map, const QStringList& keys) {
      return mirrored(map, keys, along);
    });
  shell_.actions.on("edit.array", this, [this] { makeArray(); });
  static constexpr std::pair<const char*, Alignment> kAlignments[] = {
      {"arrange.left", Alignment::Left},        {"arrange.right", Alignment::Right},
      {"arrange.top", Alignment::Top},          {"arrange.bottom", Alignment::Bottom},
      {"arrange.centre_x", Alignment::CentreX}, {"arrange.centre_y", Alignment::CentreY}};
  for (const auto& [id, alignment] : kAlignments)
    arrangeBy(id, [alignment = alignment](const Map& map, const QStringList& keys) {
      return aligned(map, keys, alignment);
    });
  for (const auto& [id, along] :
       {std::pair("arrange.distribute_x", Along::X), std::pair("arrange.distribute_y", Along::Y)})
    arrangeBy(id, [along = along](const Map& map, const QStringList& keys) {
      return distributed(map, keys, along);
    });
}

void EditActions::arrangeBy(const char* id, Arranging arranging) {
  QAction& action = shell_.actions[QLatin1String(id)];
  connect(&action, &QAction::triggered, this, [this, &action, arranging = std::move(arranging)] {
    MapDocument& document = document_;
    const Map before = document.map();
    document.apply(arranging(before, document.selection()), action.text().remove(u'&'));
    if (!(document.map() == before)) return shell_.messages.withdraw(kArrangedTopic);
    shell_.messages.show(MessageBar::Kind::Info,
                         tr("“%1” changes nothing: what is selected is so already, or is locked.")
                             .arg(action.iconText()),
                         {}, kArrangedTopic);
  });
}

void EditActions::connectSnapping() {
  const ActionSet& actions = shell_.actions;
  MapCanvas& canvas = canvas_;
  QSettings& settings = shell_.settings;
  const auto show = [this] {
    const SnapModes modes = canvas_.snapModes();
    shell_.actions["view.snap"].setChecked(modes.grid);
    shell_.actions["view.snap_objects"].setChecked(modes.objects);
    shell_.settings.setValue(kSnapGridKey, modes.grid);
    shell_.settings.setValue(kSnapObjectsKey, modes.objects);
  };
  canvas.setSnapModes({settings.value(kSnapGridKey, false).toBool(),
                       settings.value(kSnapObjectsKey, true).toBool()});
  show();
  connect(&canvas, &MapCanvas::snapModesChanged, this, show);
  actions.on("view.snap", this, [&canvas](bool on) {
    canvas.setSnapModes({on, canvas.snapModes().objects});
  });
  actions.on("view.snap_objects", this, [&canvas](bool on) {
    canvas.setSnapModes({canvas.snapModes().grid, on});
  });
  actions.on("view.snap_next", this, [&canvas] { canvas.cycleSnapModes(); });

  const bool recognizing = settings.value(kRecognizeKey, true).toBool();
  tools_.setRecognizing(recognizing);
  actions["draw.recognize"].setChecked(recognizing);
  actions.on("draw.recognize", this, [this, &settings](bool on) {
    tools_.setRecognizing(on);
    settings.setValue(kRecognizeKey, on);
  });
}

void EditActions::copy() {
  const MapDocument& document = document_;
  if (document.selection().isEmpty()) return;
  QGuiApplication::clipboard()->setMimeData(
      clipboardData(document.map(), document.selection()).release());
}

void EditActions::paste() {
  const QMimeData* data = QGuiApplication::clipboard()->mimeData();
  if (!data || !mayHoldObjects(*data)) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("There is nothing on the clipboard to paste"));
    return;
  }
  try {
    insert(centredAt(objectsOf(*data), canvas_.pastePosition()), tr("Paste"));
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Warning, tr("The clipboard holds no part of a drawing"),
                         QString::fromUtf8(error.what()));
  }
}

void EditActions::duplicate() {
  const MapDocument& document = document_;
  const double away = roundedTo({kDuplicatePx / canvas_.pixelsPerMetre(), 0.0}, 0.1).x();
  MapChange objects = selected(document.map(), document.selection());
  insert(moved(std::move(objects), {away, -away}), tr("Duplicate"));
}

/// The gap between neighbours is at first that of a row of houses.
void EditActions::makeArray() {
  constexpr double kGap = 5.0;     // metres
  constexpr double kFar = 1000.0;  // metres
  constexpr double kMost = 50.0;   // in a row: more are hardly drawn by hand
  const MapDocument& document = document_;
  const MapChange objects = selected(document.map(), document.selection());
  Map only;
  only.buildings = objects.buildings;
  only.landmarks = objects.landmarks;
  const auto bounds = boundsOf(only);
  if (!bounds) return;
  const Vec2 size = bounds->high - bounds->low;
  const QString metres = tr(" m");
  const QList<double> answer = shell_.dialogs.numbers(
      tr("Array"), {{tr("Columns"), 3.0, 1.0, kMost},
                    {tr("Rows"), 1.0, 1.0, kMost},
                    {tr("Gap between columns"), kGap, -kFar, kFar, 2, metres},
                    {tr("Gap between rows"), kGap, -kFar, kFar, 2, metres}});
  if (answer.size() != 4) return;
  insert(arrayed(document.map(), document.selection(), static_cast<int>(answer[0]),
                 static_cast<int>(answer[1]), {size.x() + answer[2], size.y() + answer[3]}),
         tr("Array"));
}

void EditActions::insert(MapChange objects, const QString& text) {
  MapDocument& document = document_;
  const QStringList keys = document.add(copiesFor(document.map(), std::move(objects)), text);
  if (!keys.isEmpty()) document.setSelection(keys);
}

void EditActions::updateEnabled() {
  const MapDocument& document = document_;
  const ActionSet& actions = shell_.actions;
  const QStringList keys = document.selection();
  QUndoStack& undo = document_.undoStack();
  actions.setEnabled({"edit.undo"}, undo.canUndo(), tr("nothing has been changed"));
  const Map& map = document_.map();
  actions.setEnabled({"edit.select_all"},
                     !map.buildings.empty() || !map.landmarks.empty() || !map.route.empty() ||
                         map.start.has_value(),
                     tr("nothing is drawn yet"));
  actions.setEnabled({"edit.redo"}, undo.canRedo(), tr("nothing has been taken back"));
  const QString nothing = tr("nothing is selected");
  actions.setEnabled({"edit.copy", "edit.duplicate"}, !keys.isEmpty(), nothing);
  actions.setEnabled({"edit.delete", "edit.cut"}, !unlocked(document_.map(), keys).isEmpty(),
                     keys.isEmpty() ? nothing : tr("what is selected is locked"));
  const auto objects = std::ranges::count_if(keys, [](const QString& key) {
    return key != kStartKey && key != kRouteKey && !pictureIndex(key);
  });
  actions.setEnabled({"edit.rename"}, objects == 1 && keys.size() == 1,
                     tr("not one building or landmark is selected"));
  actions.setEnabled({"edit.add_corner"}, tools_.canAddCorner(),
                     tr("no building that is not locked, and no route, is selected"));
  actions.setEnabled(
      {"arrange.lock", "arrange.square", "arrange.parallel", "arrange.polygon", "edit.rotate_left",
       "edit.rotate_right", "edit.mirror_x", "edit.mirror_y", "edit.array"},
      objects > 0, nothing);
  actions.setEnabled({"arrange.left", "arrange.right", "arrange.top", "arrange.bottom",
                      "arrange.centre_x", "arrange.centre_y"},
                     objects > 1, tr("fewer than two buildings or landmarks are selected"));
  actions.setEnabled({"arrange.distribute_x", "arrange.distribute_y"}, objects > 2,
                     tr("fewer than three buildings or landmarks are selected"));
}

void EditActions::addEnabled(QMenu& menu, std::initializer_list<const char*> ids) const {
  menu.addSeparator();
  for (const char* id : ids) {
    QAction& action = shell_.actions[QLatin1String(id)];
    if (action.isEnabled()) menu.addAction(&action);
  }
}

void EditActions::showMenu(QPoint global) {
  auto* menu = new QMenu(&canvas_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setObjectName("canvas_menu");
  addEnabled(*menu, {"run.why", "run.right", "run.not_there"});
  addEnabled(*menu, {"edit.rename", "edit.add_corner", "edit.delete"});
  addEnabled(*menu, {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate"});
  addEnabled(*menu, {"arrange.lock", "arrange.square", "arrange.parallel", "arrange.polygon"});
  addEnabled(*menu,
             {"arrange.left", "arrange.right", "arrange.top", "arrange.bottom", "arrange.centre_x",
              "arrange.centre_y", "arrange.distribute_x", "arrange.distribute_y"});
  if (document_.selection().isEmpty())
    addEnabled(*menu, {"edit.select_all", "view.zoom_fit", "view.grid", "view.snap_next"});
  menu->popup(global);
}

}  // namespace handmap
