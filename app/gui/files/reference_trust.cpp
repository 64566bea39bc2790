#include "app/gui/files/reference_trust.h"

#include <QFile>
#include <QSettings>

#include "app/gui/files/file_actions.h"
#include "app/gui/shell/message_bar.h"
#include "core/base/error.h"
#include "core/map/references.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {
constexpr auto kTrustedKey = "files/trusted_references";
constexpr int kMostTrusted = 200;
constexpr qsizetype kMostNamed = 3;
constexpr auto kReferenceTrustTopic = "references";
}  // namespace

ReferenceTrust::ReferenceTrust(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts) {
  connect(&parts_.files, &FileActions::drawingReplaced, this, &ReferenceTrust::onReplaced);
  connect(&parts_.files, &FileActions::saved, this, &ReferenceTrust::onSaved);
}

QStringList ReferenceTrust::outside() const {
  QStringList names;
  const std::filesystem::path file = QFile::encodeName(parts_.document.origin()).toStdString();
  try {
    for (const Reference& reference : referencesOf(parts_.document.map(), file)) {
      if (!staysInside(reference, file)) names << QString::fromStdString(reference.path.string());
    }
  } catch (const Error&) {  // a model that is no path: MapModel tells
  }
  return names;
}

void ReferenceTrust::onReplaced() {
  parts_.messages.withdraw(kReferenceTrustTopic);
  const QStringList names = outside();
  if (names.isEmpty()) return;
  const QString path = parts_.document.filePath();
  if (parts_.settings.value(kTrustedKey).toStringList().contains(path)) {
    parts_.document.setTrustsReferences(true);
    Q_EMIT granted();
    return;
  }
  QString named = names.mid(0, kMostNamed).join(QStringLiteral(", "));
  if (names.size() > kMostNamed) named += QStringLiteral(", …");
  parts_.messages
      .ask(tr("“%1” wants to read files outside of its folder: %2")
               .arg(parts_.document.displayName(), named),
           tr("Say yes if you know where the drawing comes from."), kReferenceTrustTopic)
      .addAction(tr("Read them"), [this, path] { grant(path); });
}

void ReferenceTrust::grant(const QString& path) {
  if (path != parts_.document.filePath()) return;  // another drawing is open by now
  remember(path);
  parts_.document.setTrustsReferences(true);
  Q_EMIT granted();
}

void ReferenceTrust::onSaved(const QString& path) {
  // Who saves a drawing in another folder knows the files that stay behind.
  const bool has_outside = !outside().isEmpty();
  const bool known = parts_.document.trustsReferences() || !has_outside;
  if (known && (has_outside || path != parts_.document.origin())) remember(path);
}

void ReferenceTrust::remember(const QString& path) {
  if (path.isEmpty()) return;
  QStringList trusted = parts_.settings.value(kTrustedKey).toStringList();
  trusted.removeAll(path);
  trusted.prepend(path);
  parts_.settings.setValue(kTrustedKey, trusted.mid(0, kMostTrusted));
}

}  // namespace handmap
