#include "app/gui/files/reference_trust.h"

#include <QFile>
#include <QSettings>

#include "app/gui/files/file_actions.h"
#include "core/base/error.h"
#include "core/map/references.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {
constexpr auto kTrustedKey = "files/trusted_references";
constexpr int kMostTrusted = 200;
constexpr qsizetype kMostNamed = 3;
constexpr auto kReferenceTrustTopic = "references";
}  // namespace

ReferenceTrust::ReferenceTrust(const Shell& shell, MapDocument& document, FileActions& files,
                               QObject* parent)
    : QObject(parent), shell_(shell), document_(document), files_(files) {
  connect(&files_, &FileActions::drawingReplaced, this, &ReferenceTrust::onReplaced);
  connect(&files_, &FileActions::saved, this, &ReferenceTrust::onSaved);
}

QStringList ReferenceTrust::outside() const {
  QStringList names;
  const std::filesystem::path file = QFile::encodeName(document_.origin()).toStdString();
  try {
    for (const Reference& reference : referencesOf(document_.map(), file)) {
      if (!staysInside(reference, file)) names << QString::fromStdString(reference.path.string());
    }
  } catch (const Error&) {  // a model that is no path: MapModel tells
  }
  return names;
}

void ReferenceTrust::onReplaced() {
  shell_.messages.withdraw(kReferenceTrustTopic);
  const QStringList names = outside();
  if (names.isEmpty()) return;
  const QString path = document_.filePath();
  if (shell_.settings.value(kTrustedKey).toStringList().contains(path)) {
    document_.setTrustsReferences(true);
    Q_EMIT granted();
    return;
  }
  QString named = names.mid(0, kMostNamed).join(QStringLiteral(", "));
  if (names.size() > kMostNamed) named += QStringLiteral(", …");
  shell_.messages
      .ask(tr("“%1” wants to read files outside of its folder: %2")
               .arg(document_.displayName(), named),
           tr("Read them only if you know where the drawing comes from."), kReferenceTrustTopic)
      .addAction(tr("Read them"), [this, path] { grant(path); });
}

void ReferenceTrust::grant(const QString& path) {
  if (path != document_.filePath()) return;  // another drawing is open by now
  remember(path);
  document_.setTrustsReferences(true);
  Q_EMIT granted();
}

void ReferenceTrust::onSaved(const QString& path) {
  // Who saves a drawing in another folder knows the files that stay behind.
  const bool has_outside = !outside().isEmpty();
  const bool known = document_.trustsReferences() || !has_outside;
  if (known && (has_outside || path != document_.origin())) remember(path);
}

void ReferenceTrust::remember(const QString& path) {
  if (path.isEmpty()) return;
  QStringList trusted = shell_.settings.value(kTrustedKey).toStringList();
  trusted.removeAll(path);
  trusted.prepend(path);
  shell_.settings.setValue(kTrustedKey, trusted.mid(0, kMostTrusted));
}

}  // namespace handmap
