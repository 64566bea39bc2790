#include "app/gui/files/file_actions.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QUrl>

#include "app/gui/files/exports.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/shell/dialogs.h"
#include "app/gui/shell/message_bar.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {

constexpr auto kRecentKey = "files/recent";
constexpr auto kFolderKey = "files/folder";
constexpr int kMostRecent = 8;

QString mapFilter() { return FileActions::tr("Handmap drawings (*.handmap)"); }

}  // namespace

FileActions::FileActions(const Parts& parts)
    : QObject(&parts.window), parts_(parts), recent_(new QMenu(tr("Open Re&cent"), &parts.window)) {
  connectActions();
  connect(recent_, &QMenu::aboutToShow, this, &FileActions::fillRecentMenu);
}

template <typename Work>
bool FileActions::guarded(Work work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    parts_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                         QString::fromStdString(error.hint()));
  } catch (const std::exception& error) {
    parts_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()));
  }
  return false;
}

void FileActions::connectActions() {
  const ActionSet& actions = parts_.actions;
  actions.on("file.new", this, [this] { replace({}); });
  actions.on("file.new_window", this, [this] { openWindow(); });
  actions.on("file.open", this, [this] {
    const QString path = parts_.dialogs.fileToOpen(
        {tr("Open a drawing"), parts_.settings.value(kFolderKey).toString(), mapFilter(), {}, {}});
    if (!path.isEmpty()) open(path);
  });
  actions.on("file.save", this, [this] { save(); });
  actions.on("file.save_as", this, [this] { saveAs(); });
  actions.on("file.export_map", this, [this] { exportMap(); });
  actions.on("file.export_geojson", this, [this] { exportGeoJson(); });
  actions.on("file.export_png", this, [this] { exportPicture(); });
  actions.on("file.export_trajectory", this, [this] { exportTrajectory(); });
}

void FileActions::startAgain() {
  if (!parts_.window.close()) return;
  parts_.settings.sync();  // the other one reads what this one has just left
  openWindow(parts_.document.filePath());
}

bool FileActions::mayLeave() {
  if (!parts_.document.isModified()) return true;
  constexpr int kSave = 0;
  constexpr int kDiscard = 1;
  const int answer =
      parts_.dialogs.choose({tr("Unsaved changes"),
                             tr("Save the changes to “%1”?").arg(parts_.document.displayName()),
                             {tr("&Save"), tr("&Discard")}});
  return answer == kSave ? save() : answer == kDiscard;
}

bool FileActions::open(const QString& path) {
  if (!mayLeave()) return false;
  const QString absolute = QFileInfo(path).absoluteFilePath();
  if (!guarded([&] { parts_.document.open(absolute); })) return false;
  remember(absolute);
  Q_EMIT drawingReplaced();
  return true;
}

bool FileActions::reload() {
  const QString path = parts_.document.filePath();
  if (path.isEmpty() || !guarded([&] { parts_.document.open(path); })) return false;
  Q_EMIT drawingReplaced();
  return true;
}

bool FileActions::replace(const Map& map) {
  if (!mayLeave()) return false;
  parts_.document.reset(map);
  Q_EMIT drawingReplaced();
  return true;
}

bool FileActions::save() {
  const QString path = parts_.document.filePath();
  return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
  const QString path = askPath(tr("Save the drawing"), parts_.document.displayName(), mapFilter(),
                               QStringLiteral("handmap"));
  return !path.isEmpty() && saveTo(path);
}

bool FileActions::saveTo(const QString& path) {
  const auto work = [&] {
    before_save_(path);
    parts_.document.save(path);
  };
  if (!guarded(work)) return false;
  remember(path);
  Q_EMIT saved(path);
  return true;
}

QString FileActions::askPath(const QString& title, const QString& suggestion, const QString& filter,
                             const QString& suffix) {
  QString path = parts_.dialogs.fileToSave(
      {title, parts_.settings.value(kFolderKey).toString(), filter,
       QFileInfo(suggestion).completeBaseName() + QLatin1Char('.') + suffix, suffix});
  if (!path.isEmpty()) parts_.settings.setValue(kFolderKey, QFileInfo(path).path());
  return path;
}

Map FileActions::refinedMap() const {
  Map map = parts_.run.result()->map();
  map.georeference = parts_.document.map().georeference;
  return map;
}

std::optional<Map> FileActions::chosenMap(QString& what) {
  constexpr int kRefined = 0;
  constexpr int kDrawing = 1;
  const QStringList names = {tr("The refined map"), tr("The drawing")};
  const int choice = parts_.run.result() == nullptr
                         ? kDrawing
                         : parts_.dialogs.choose({tr("Export"), tr("Which map?"), names});
  if (choice < 0) return std::nullopt;
  what = names[choice];
  return choice == kRefined ? refinedMap() : parts_.document.map();
}

void FileActions::tellExported(const QString& what, const QString& path) {
  parts_.messages
      .show(MessageBar::Kind::Info, tr("%1 is in “%2”.").arg(what, QFileInfo(path).fileName()),
            path, QStringLiteral("export"))
      .addAction(tr("Show in folder"), [path] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath()));
      });
}

void FileActions::exportMap() {
  if (!parts_.run.result()) return;
  Map map = refinedMap();
  const QString path = askPath(tr("Export the refined map"),
                               QFileInfo(parts_.document.displayName()).completeBaseName() +
                                   tr("-refined") + QStringLiteral(".handmap"),
                               mapFilter(), QStringLiteral("handmap"));
  if (path.isEmpty()) return;
  const auto work = [&] {
    moveReferences(map, parts_.document.origin().toStdString(), path.toStdString());
    writeMap(map, path.toStdString());
  };
  if (guarded(work)) tellExported(tr("The refined map"), path);
}

void FileActions::exportGeoJson() {
  if (!parts_.document.map().georeference) {
    parts_.messages
        .show(MessageBar::Kind::Warning, tr("GeoJSON needs to know where the drawing lies."),
              tr("Its georeference is the latitude and longitude of the origin."))
        .addAction(tr("Say where"), [this] { Q_EMIT georeferenceWanted(); });
    return;
  }
  QString what;
  const std::optional<Map> map = chosenMap(what);
  if (!map) return;
  const QString path = askPath(tr("Export GeoJSON"), parts_.document.displayName(),
                               tr("GeoJSON (*.geojson)"), QStringLiteral("geojson"));
  if (path.isEmpty()) return;
  const auto work = [&] { writeFileAtomically(path.toStdString(), formatGeoJson(*map)); };
  if (guarded(work)) tellExported(what, path);
}

void FileActions::exportPicture() {
  const QImage picture = pictureOf(*parts_.canvas.viewport());
  const QString path = askPath(tr("Export a picture"), parts_.document.displayName(),
                               tr("Pictures (*.png)"), QStringLiteral("png"));
  if (path.isEmpty()) return;
  if (guarded([&] { writePicture(picture, path); })) {
    tellExported(tr("What the canvas shows"), path);
  }
}

void FileActions::exportTrajectory() {
  const auto result = parts_.run.result();
  if (!result) return;
  const QString path = askPath(tr("Export the trajectory"), parts_.document.displayName(),
                               tr("Trajectories (*.tum)"), QStringLiteral("tum"));
  if (path.isEmpty()) return;
  const auto work = [&] {
    writeFileAtomically(path.toStdString(), formatTum(result->last->trajectory.all()));
  };
  if (guarded(work)) tellExported(tr("The way of the robot"), path);
}

void FileActions::remember(const QString& path) {
  QStringList files = parts_.settings.value(kRecentKey).toStringList();
  files.removeAll(path);
  files.prepend(path);
  parts_.settings.setValue(kRecentKey, files.mid(0, kMostRecent));
  parts_.settings.setValue(kFolderKey, QFileInfo(path).path());
}

void FileActions::fillRecentMenu() {
  recent_->clear();
  const QStringList files = parts_.settings.value(kRecentKey).toStringList();
  for (const QString& path : files) {
    QAction* action = recent_->addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    connect(action, &QAction::triggered, this, [this, path] { open(path); });
  }
  if (files.isEmpty()) recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

}  // namespace handmap
