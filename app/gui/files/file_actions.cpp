#include "app/gui/files/file_actions.h"

#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSettings>
#include <QUrl>
#include <exception>

#include "app/gui/files/plan_sheet.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/geodata/fleet_map.h"
#include "core/geodata/geo_map.h"
#include "core/geodata/geo_writer.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/recording/recording_files.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

constexpr auto kRecentKey = "files/recent";
constexpr auto kFolderKey = "files/folder";
const QString kExportTopic = QStringLiteral("export");
constexpr int kMostRecent = 8;

}  // namespace

FileActions::FileActions(const Shell& shell, MapDocument& document, MapCanvas& canvas)
    : QObject(&shell.window),
      shell_(shell),
      document_(document),
      canvas_(canvas),
      recent_(new QMenu(tr("Open Re&cent"), &shell.window)),
      self_(std::make_shared<Lifeline<FileActions>>(*this)) {
  connectActions();
  connect(recent_, &QMenu::aboutToShow, this, &FileActions::fillRecentMenu);
}

FileActions::~FileActions() {
  self_->cut();
  for (std::stop_source& one : written_) one.request_stop();
}

template <typename Work>
bool FileActions::guarded(Work work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                         QString::fromStdString(error.hint()));
  } catch (const std::exception& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()));
  }
  return false;
}

void FileActions::connectActions() {
  const ActionSet& actions = shell_.actions;
  actions.on("file.new", this, [this] { replace({}); });
  actions.on("file.new_window", this, [this] { openWindow(); });
  actions.on("file.open", this, [this] {
    const QString path = shell_.dialogs.fileToOpen(
        {tr("Open a drawing"), shell_.settings.value(kFolderKey).toString(), openFilter(), {}, {}});
    if (!path.isEmpty()) open(path);
  });
  actions.on("file.save", this, [this] { save(); });
  actions.on("file.save_as", this, [this] { saveAs(); });
  actions.on("file.export_other", this, [this] { exportToOthers(); });
  actions.on("file.export_png", this, [this] { exportPicture(); });
}

void FileActions::startAgain() {
  QStringList robot = coming_back_();
  const QScopedValueRollback leaving(is_coming_back_, true);
  if (!shell_.window.close()) return;
  shell_.settings.sync();  // the other one reads what this one has just left
  const QString path = document_.filePath();
  if (path.isEmpty()) robot.removeAll(QStringLiteral("--run"));  // there is nothing to run on
  openWindow((path.isEmpty() ? QStringList() : QStringList{path}) + robot);
}

bool FileActions::mayLeave() {
  if (!mayLeaveRun()) return false;
  if (!document_.isModified()) return true;
  constexpr int kSave = 0;
  constexpr int kDiscard = 1;
  const int answer =
      shell_.dialogs.choose({tr("Unsaved changes"),
                             tr("Save the changes to “%1”?").arg(document_.displayName()),
                             {tr("&Save"), tr("&Discard")}});
  return answer == kSave ? save() : answer == kDiscard;
}

bool FileActions::open(const QString& path) {
  if (open_other_(path)) return true;
  if (!mayLeave()) return false;
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const bool is_geographic = isGeoFile(QFile::encodeName(absolute).toStdString());
  if (!guarded([&] { is_geographic ? import(absolute) : document_.open(absolute); })) return false;
  remember(absolute);
  Q_EMIT drawingReplaced();
  if (is_geographic) tellImport(absolute);
  return true;
}

/// A public map becomes a new drawing, which has no file yet.
void FileActions::import(const QString& path) {
  GeoMap geo = readGeoMap(QFile::encodeName(path).toStdString());
  geo.map.name = QFileInfo(path).completeBaseName().toStdString();
  document_.reset(geo.map);
  left_out_ = geo.left_out;
}

void FileActions::tellImport(const QString& path) {
  const auto buildings = static_cast<int>(document_.map().buildings.size());
  shell_.messages.show(
      MessageBar::Kind::Info,
      tr("%n building(s) of “%1” are a new drawing now, and where they lie on earth is kept.",
         nullptr, buildings)
          .arg(QFileInfo(path).fileName()),
      left_out_ == 0 ? QString()
                     : tr("%n outline(s) were left out: they cross themselves or are too large.",
                          nullptr, static_cast<int>(left_out_)));
}

bool FileActions::reload() {
  const QString path = document_.filePath();
  if (path.isEmpty() || !guarded([&] { document_.open(path); })) return false;
  Q_EMIT drawingReplaced();
  return true;
}

bool FileActions::replace(const Map& map) {
  if (!mayLeave()) return false;
  document_.reset(map);
  Q_EMIT drawingReplaced();
  return true;
}

bool FileActions::save() {
  const QString path = document_.filePath();
  return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
  const QString path = askPath(tr("Save the drawing"), document_.displayName(), mapFilter(),
                               QStringLiteral("handmap"));
  return !path.isEmpty() && saveTo(path);
}

bool FileActions::saveTo(const QString& path) {
  const auto work = [&] {
    refuseFileOfRecording(QFile::encodeName(path).toStdString());
    before_save_(path);
    document_.save(path);
  };
  if (!guarded(work)) return false;
  remember(path);
  Q_EMIT saved(path);
  return true;
}

QString FileActions::askPath(const QString& title, const QString& suggestion, const QString& filter,
                             const QString& suffix) {
  const QString ending = suffix.isEmpty() ? QString() : QLatin1Char('.') + suffix;
  QString path =
      shell_.dialogs.fileToSave({title, shell_.settings.value(kFolderKey).toString(), filter,
                                 QFileInfo(suggestion).completeBaseName() + ending, suffix});
  if (!path.isEmpty()) shell_.settings.setValue(kFolderKey, QFileInfo(path).path());
  return path;
}

std::optional<Map> FileActions::chosenMap(QString& what) {
  constexpr int kRefined = 0;
  constexpr int kDrawing = 1;
  const QStringList names = {tr("The corrected map"), tr("The drawing")};
  const std::optional<Map> corrected = corrected_();
  const int choice =
      corrected ? shell_.dialogs.choose({tr("Export"), tr("Which map?"), names}) : kDrawing;
  if (choice < 0) return std::nullopt;
  what = names[choice];
  return choice == kRefined ? *corrected : document_.map();
}

void FileActions::exportAs(const Export& what,
                           const std::function<void(const QString& path)>& write) {
  const QString path = askPath(what.title, what.suggestion, what.filter, what.suffix);
  if (!path.isEmpty()) exportTo(path, what.what, [&] { write(path); });
}

void FileActions::exportTo(const QString& path, const QString& what,
                           const std::function<void()>& write) {
  const auto work = [&] {
    refuseWhatIsRead(path);
    write();
  };
  if (guarded(work)) tellExport(path, what);
}

void FileActions::exportInBackground(const Export& what, LongWrite write) {
  const QString path = askPath(what.title, what.suggestion, what.filter, what.suffix);
  if (path.isEmpty() || !guarded([&] { refuseWhatIsRead(path); })) return;
  if (written_.contains(path)) written_[path].request_stop();
  const std::stop_source stop;
  written_[path] = stop;
  const QString file = QFileInfo(path).fileName();
  // It stays as long as there is something to be stopped.
  shell_.messages.ask(tr("“%1” is being written…").arg(file), {}, kExportTopic + path)
      .addAction(tr("Stop writing"), [stop]() mutable { stop.request_stop(); });
  startInBackground([self = self_, stop, path, name = what.what, write = std::move(write)] {
    std::exception_ptr failure;
    bool whole = false;
    try {
      whole = write(path, stop.get_token());
    } catch (...) {
      failure = std::current_exception();
    }
    self->post([stop, path, name, failure, whole](FileActions& files) {
      if (!(files.written_.value(path) == stop)) return;  // another one goes there
      files.written_.remove(path);
      files.shell_.messages.withdraw(kExportTopic + path);
      const auto rethrow = [&failure] {
        if (failure) std::rethrow_exception(failure);
      };
      if (files.guarded(rethrow) && whole) files.tellExport(path, name);
    });
  });
}

bool FileActions::mayClose() {
  constexpr int kStop = 0;
  if (written_.isEmpty()) return true;
  const QString file = QFileInfo(written_.firstKey()).fileName();
  const int answer = shell_.dialogs.choose({tr("Stop writing?"),
                                            tr("“%1” is not written to its end yet.").arg(file),
                                            {tr("&Stop writing")}});
  if (answer != kStop && !written_.isEmpty()) return false;  // it may be there meanwhile
  for (std::stop_source& one : written_) one.request_stop();
  return true;
}

void FileActions::tellExport(const QString& path, const QString& what) {
  shell_.messages
      .show(MessageBar::Kind::Info, tr("%1 is in “%2”.").arg(what, QFileInfo(path).fileName()),
            path, kExportTopic)
      .addAction(tr("Show in folder"), [path] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath()));
      });
}

/// An export is not the drawing's own file, none that it names, and none of a recording.
void FileActions::refuseWhatIsRead(const QString& path) const {
  const std::filesystem::path target = QFile::encodeName(path).toStdString();
  refuseFileOfRecording(target);
  const std::filesystem::path origin = QFile::encodeName(document_.origin()).toStdString();
  std::vector<std::filesystem::path> read{QFile::encodeName(document_.filePath()).toStdString()};
  for (const Reference& reference : referencesOf(document_.map(), origin)) {
    read.push_back(targetOf(reference, origin));
  }
  std::error_code error;
  for (const std::filesystem::path& file : read) {
    if (!std::filesystem::equivalent(target, file, error)) continue;
    throw Error(ErrorCode::BadInput, tr("%1 belongs to the drawing.").arg(path).toStdString(),
                tr("Choose another name for what is exported.").toStdString());
  }
}

QString FileActions::mapFilter() { return tr("Handmap drawings (*.handmap)"); }

QString FileActions::openFilter() const {
  QStringList endings;
  for (const std::string& ending : geoFileEndings())
    endings << QStringLiteral("*.") + QString::fromStdString(ending);
  const QString geographic = endings.join(u' ');
  return tr("Drawings and public maps (*.handmap %1)").arg(geographic) + QStringLiteral(";;") +
         mapFilter() + QStringLiteral(";;") +
         tr("OpenStreetMap, GeoJSON and others (%1)").arg(geographic) + other_filter_;
}

/// In every form that there is; first those that need nothing that the map has not.
void FileActions::exportToOthers() {
  QString what;
  const std::optional<Map> map = chosenMap(what);
  if (!map) return;
  QStringList on_earth = {tr("GeoJSON (*.geojson)"), tr("OpenStreetMap (*.osm)"), tr("KML (*.kml)"),
                          tr("GeoPackage (*.gpkg)")};
  QStringList in_metres = {tr("DXF for CAD (*.dxf)"), tr("Map of a robot, map_server (*.yaml)"),
                           tr("Building of Open-RMF, for fleets (*.building.yaml)")};
  if (hasRobotMap(*map)) {
    in_metres << tr("Reference coordinates of the robot's map, for fleets (*.fleet.yaml)");
  }
  const QStringList filters = map->georeference ? on_earth + in_metres : in_metres + on_earth;
  const QString path = askPath(
      tr("Export to other programs"), document_.displayName(), filters.join(QStringLiteral(";;")),
      map->georeference ? QStringLiteral("geojson") : QStringLiteral("dxf"));
  if (path.isEmpty()) return;
  const std::filesystem::path file = QFile::encodeName(path).toStdString();
  if (!map->georeference && needsGeoreference(file))
    return askWhereItLies(QFileInfo(path).suffix());
  exportTo(path, what, [&] {
    if (isMapServer(file)) {
      auto picture = file;
      refuseWhatIsRead(QFile::decodeName(picture.replace_extension(".pgm").c_str()));
    }
    writeGeoMap(*map, file);
    if (!isMapServer(file)) return;
    const double cell_m = robotMapCell(*map, file);
    if (cell_m > kRobotMapCell_m)
      what = tr("%1 (in cells of %2 m, it is a large place)").arg(what).arg(cell_m);
  });
}

void FileActions::askWhereItLies(const QString& form) {
  shell_.messages
      .show(MessageBar::Kind::Warning,
            tr("A .%1 file tells where on earth the map lies.").arg(form),
            tr("The drawing does not say so yet: its georeference is the latitude and longitude of "
               "the origin. DXF and maps of robots need none."))
      .addAction(tr("Say where"), [this] { Q_EMIT georeferenceWanted(); });
}

void FileActions::exportPicture() {
  const QString title = QFileInfo(document_.displayName()).completeBaseName();
  const PlanSheet sheet{title, legend_()};
  exportAs({tr("Export a picture"), document_.displayName(),
            tr("Pictures (*.png);;Vector graphics (*.svg);;PDF (*.pdf)"), QStringLiteral("png"),
            tr("The plan")},
           [this, &sheet](const QString& path) { writePlan(canvas_, sheet, path); });
}

void FileActions::remember(const QString& path) {
  QStringList files = shell_.settings.value(kRecentKey).toStringList();
  files.removeAll(path);
  files.prepend(path);
  shell_.settings.setValue(kRecentKey, files.mid(0, kMostRecent));
  shell_.settings.setValue(kFolderKey, QFileInfo(path).path());
}

void FileActions::fillRecentMenu() {
  recent_->clear();
  const QStringList files = shell_.settings.value(kRecentKey).toStringList();
  for (const QString& path : files) {
    QAction* action = recent_->addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    connect(action, &QAction::triggered, this, [this, path] { open(path); });
  }
  if (files.isEmpty()) recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

}  // namespace handmap
