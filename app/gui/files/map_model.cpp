#include "app/gui/files/map_model.h"

#include "app/gui/files/file_actions.h"
#include "core/base/error.h"
#include "core/map/references.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {

namespace {

std::filesystem::path nativePath(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

}  // namespace

MapModel::MapModel(const Shell& shell, MapDocument& document, FileActions& files, TeachPanel& teach,
                   QObject* parent)
    : QObject(parent), shell_(shell), document_(document), files_(files), teach_(teach) {
  files_.setBeforeSave([this](const QString& path) { writeBeside(path); });
  connect(&files_, &FileActions::drawingReplaced, this, &MapModel::loadOfDrawing);
  connect(&teach_, &TeachPanel::saveWithMapRequested, this, &MapModel::saveWithMap);
}

void MapModel::writeBeside(const QString& map_path) {
  if (!teach_.isUnsaved()) return;
  const std::filesystem::path model = modelBeside(nativePath(map_path));
  teach_.classifier()->save(model);
  teach_.setSaved();
  document_.setModel(QString::fromStdU16String(model.u16string()), map_path);
  of_drawing_ = true;
}

void MapModel::loadOfDrawing() {
  try {
    if (const auto path = modelToRead()) {
      teach_.setModel(std::make_shared<const BuildingClassifier>(BuildingClassifier::load(*path)));
      of_drawing_ = true;
      return;
    }
  } catch (const Error& error) {
    shell_.messages.show(
        MessageBar::Kind::Warning,
        tr("The model of this drawing cannot be used: %1").arg(QString::fromUtf8(error.what())),
        tr("Runs take the program's own until you load or teach another."));
  }
  // What belonged to the drawing before goes with it; what is taught and not yet saved stays.
  if (of_drawing_ && !teach_.isUnsaved()) teach_.setModel(nullptr);
  of_drawing_ = false;
}

std::optional<std::filesystem::path> MapModel::modelToRead() const {
  const std::filesystem::path file = nativePath(document_.origin());
  const auto reference = modelReference(document_.map(), file);
  // Whether one that lies elsewhere is wanted is asked by ReferenceTrust.
  if (!reference || (!document_.trustsReferences() && !staysInside(*reference, file))) {
    return std::nullopt;
  }
  checkReference(*reference, file, Outside::Allowed);
  return targetOf(*reference, file);
}

bool MapModel::mayClose() {
  const TeachPanel& teach = teach_;
  if (!teach.hasUnsavedWork()) return true;
  constexpr int kSave = 0;
  constexpr int kDiscard = 1;
  if (!teach.isUnsaved()) {
    const int answer = shell_.dialogs.choose(
        {tr("Untrained painting"),
         tr("What was painted in “Teach buildings” is in no model yet. Leave it?"),
         {tr("&Stay"), tr("&Leave")}});
    return answer == kDiscard;
  }
  const int answer =
      shell_.dialogs.choose({tr("Unsaved model"),
                             tr("The model that was taught in “Teach buildings” is in no file."),
                             {tr("&Save model…"), tr("&Discard")}});
  return answer == kSave ? saveModel() : answer == kDiscard;
}

bool MapModel::saveModel() {
  const QString path = shell_.dialogs.fileToSave({tr("Save the model"),
                                                  {},
                                                  tr("Models (*.json)"),
                                                  QStringLiteral("buildings.json"),
                                                  QStringLiteral("json")});
  return !path.isEmpty() && teach_.saveModel(path);
}

void MapModel::saveWithMap() {
  if (!teach_.classifier()) return;
  // Also one that was loaded or saved elsewhere is to lie beside the map.
  teach_.setUnsaved();
  if (!files_.save()) return;
  shell_.messages.show(MessageBar::Kind::Info,
                       tr("The model is saved with “%1”.").arg(document_.displayName()),
                       tr("Whoever opens the drawing gets it too; keep both files together."));
}

}  // namespace handmap
