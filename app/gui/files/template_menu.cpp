#include "app/gui/files/template_menu.h"

#include <QDir>
#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>
#include <array>

#include "app/gui/files/file_actions.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

constexpr auto kSuffix = ".handmap";

struct BuiltIn {
  const char* name;
  const char* file;  ///< in the resources
};
constexpr std::array kBuiltIn = {
    BuiltIn{QT_TRANSLATE_NOOP("handmap::TemplateMenu", "A street, houses on both sides"), "street"},
    BuiltIn{QT_TRANSLATE_NOOP("handmap::TemplateMenu", "A crossroads"), "crossroads"},
    BuiltIn{QT_TRANSLATE_NOOP("handmap::TemplateMenu", "A campus around a yard"), "campus"},
};

}  // namespace

TemplateMenu::TemplateMenu(const Shell& shell, MapDocument& document, FileActions& files,
                           QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      files_(files),
      menu_(new QMenu(tr("New fro&m Template"), &shell.window)) {
  connect(menu_, &QMenu::aboutToShow, this, &TemplateMenu::fill);
}

QString TemplateMenu::folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
         QStringLiteral("/templates");
}

void TemplateMenu::fill() {
  menu_->clear();
  for (const BuiltIn& entry : kBuiltIn)
    addEntry(tr(entry.name),
             QStringLiteral(":/templates/%1.handmap").arg(QLatin1String(entry.file)));
  const QDir own(folder());
  const QStringList files =
      own.entryList({QStringLiteral("*") + QLatin1String(kSuffix)}, QDir::Files, QDir::Name);
  if (!files.isEmpty()) menu_->addSeparator();
  for (const QString& file : files) addEntry(file.chopped(8), own.filePath(file));
}

void TemplateMenu::addEntry(const QString& text, const QString& path) {
  connect(menu_->addAction(text), &QAction::triggered, this, [this, path] { begin(path); });
}

void TemplateMenu::begin(const QString& path) {
  try {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
      throw Error(ErrorCode::BadInput,
                  (path + QStringLiteral(": ") + file.errorString()).toStdString());
    Map map = parseMap(file.readAll().toStdString(), path.toStdString());
    map.name.clear();  // it is somebody's own drawing from now on
    files_.replace(map);
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                         QString::fromStdString(error.hint()));
  }
}

void TemplateMenu::keep() {
  QDir().mkpath(folder());
  const QString path = shell_.dialogs.fileToSave(
      {tr("Keep as a template"), folder(), tr("Handmap drawings (*.handmap)"),
       tr("My template") + QLatin1String(kSuffix), QStringLiteral("handmap")});
  if (path.isEmpty()) return;
  try {
    Map map = document_.map();
    moveReferences(map, QFile::encodeName(document_.origin()).toStdString(),
                   QFile::encodeName(path).toStdString());
    writeMap(map, QFile::encodeName(path).toStdString());
    shell_.messages.show(MessageBar::Kind::Info,
                         tr("The drawing can be begun with under File / New from Template."));
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                         QString::fromStdString(error.hint()));
  }
}

}  // namespace handmap
