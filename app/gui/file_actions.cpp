#include "app/gui/file_actions.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>

#include "app/gui/exports.h"
#include "app/gui/message_bar.h"
#include "app/gui/run_controller.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/map_model.h"
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
    : QObject(&parts.window),
      parts_(parts),
      recovery_(parts.document, parts.settings),
      recent_(new QMenu(tr("Open &Recent"), &parts.window)) {
  connectActions();
  connect(recent_, &QMenu::aboutToShow, this, &FileActions::fillRecentMenu);
}

template <typename Work>
bool FileActions::guarded(Work work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    parts_.messages.show(MessageBar::Kind::Error, QString::fromStdString(error.what()),
                         QString::fromStdString(error.hint()));
    return false;
  }
}

void FileActions::connectActions() {
  const ActionSet& actions = parts_.actions;
  actions.on("file.new", this, [this] { replace({}); });
  actions.on("file.open", this, [this] {
    const QString path =
        QFileDialog::getOpenFileName(&parts_.window, tr("Open a drawing"),
                                     parts_.settings.value(kFolderKey).toString(), mapFilter());
    if (!path.isEmpty()) open(path);
  });
  actions.on("file.save", this, [this] { save(); });
  actions.on("file.save_as", this, [this] { saveAs(); });
  actions.on("file.export_map", this, [this] { exportMap(); });
  actions.on("file.export_geojson", this, [this] { exportGeoJson(); });
  actions.on("file.export_png", this, [this] { exportPicture(); });
  actions.on("file.export_trajectory", this, [this] { exportTrajectory(); });
}

bool FileActions::mayLeave() {
  if (!parts_.document.isModified()) return true;
  const auto answer = QMessageBox::question(
      &parts_.window, tr("Unsaved changes"),
      tr("Save the changes to “%1”?").arg(parts_.document.displayName()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

bool FileActions::open(const QString& path) {
  if (!mayLeave()) return false;
  const QString absolute = QFileInfo(path).absoluteFilePath();
  if (!guarded([&] { parts_.document.open(absolute); })) return false;
  recovery_.clear();
  remember(absolute);
  Q_EMIT drawingReplaced();
  offerRecovery();
  return true;
}

bool FileActions::replace(const Map& map) {
  if (!mayLeave()) return false;
  parts_.document.reset(map);
  recovery_.clear();
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
  recovery_.clear();
  remember(path);
  return true;
}

QString FileActions::askPath(const QString& title, const QString& suggestion, const QString& filter,
                             const QString& suffix) {
  QFileDialog dialog(&parts_.window, title, parts_.settings.value(kFolderKey).toString(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QFileInfo(suggestion).completeBaseName() + QLatin1Char('.') + suffix);
  if (dialog.exec() != QDialog::Accepted) return {};
  QString path = dialog.selectedFiles().value(0);
  if (!path.isEmpty()) parts_.settings.setValue(kFolderKey, QFileInfo(path).path());
  return path;
}

void FileActions::exportMap() {
  const auto result = parts_.run.result();
  if (!result) return;
  const QString path = askPath(tr("Export the refined map"),
                               QFileInfo(parts_.document.displayName()).completeBaseName() +
                                   tr("-refined") + QStringLiteral(".handmap"),
                               mapFilter(), QStringLiteral("handmap"));
  if (path.isEmpty()) return;
  guarded([&] {
    Map map = result->map;
    moveModel(map, parts_.document.filePath().toStdString(), path.toStdString());
    writeMap(map, path.toStdString());
  });
}

void FileActions::exportGeoJson() {
  const auto result = parts_.run.result();
  const Map& map = result ? result->map : parts_.document.map();
  guarded([&] {
    const std::string text = formatGeoJson(map);  // before asking: it may have no georeference
    const QString path = askPath(tr("Export GeoJSON"), parts_.document.displayName(),
                                 tr("GeoJSON (*.geojson)"), QStringLiteral("geojson"));
    if (!path.isEmpty()) writeFileAtomically(path.toStdString(), text);
  });
}

void FileActions::exportPicture() {
  const QImage picture = pictureOf(*parts_.canvas.viewport());
  const QString path = askPath(tr("Export a picture"), parts_.document.displayName(),
                               tr("Pictures (*.png)"), QStringLiteral("png"));
  if (!path.isEmpty()) guarded([&] { writePicture(picture, path); });
}

void FileActions::exportTrajectory() {
  const auto result = parts_.run.result();
  if (!result) return;
  const QString path = askPath(tr("Export the trajectory"), parts_.document.displayName(),
                               tr("Trajectories (*.tum)"), QStringLiteral("tum"));
  if (path.isEmpty()) return;
  guarded([&] { writeFileAtomically(path.toStdString(), formatTum(*result->trajectory)); });
}

void FileActions::offerRecovery() {
  const QStringList files = recovery_.leftBehind();
  if (files.isEmpty()) return;
  const QString& file = files.front();
  parts_.messages.show(MessageBar::Kind::Info,
                       tr("An earlier session ended with unsaved changes to “%1”.")
                           .arg(QFileInfo(file).completeBaseName()));
  parts_.messages.addAction(tr("Recover"), [this, file] {
    if (!mayLeave()) return;
    if (guarded([&] { recovery_.recover(file); })) Q_EMIT drawingReplaced();
  });
  parts_.messages.addAction(tr("Discard"), [this, file] { recovery_.forget(file); });
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
