#include "widgets/canvas/name_editor.h"

#include <QKeyEvent>
#include <algorithm>

#include "core/map/map_limits.h"

namespace handmap {

namespace {

constexpr int kWidth = 180;

const Landmark* findLandmark(const Map& map, const QString& key) {
  const auto found = std::ranges::find(map.landmarks, key.toStdString(), &Landmark::id);
  return found == map.landmarks.end() ? nullptr : &*found;
}

}  // namespace

std::optional<QString> nameOf(const Map& map, const QString& key) {
  if (const Building* building = map.find(key.toStdString()))
    return QString::fromStdString(building->name);
  if (const Landmark* landmark = findLandmark(map, key))
    return QString::fromStdString(landmark->name);
  return std::nullopt;
}

NameEditor::NameEditor(MapDocument& document, QWidget* canvas)
    : QLineEdit(canvas), document_(document) {
  setObjectName(QStringLiteral("name_editor"));
  setAccessibleName(tr("Name"));
  setAlignment(Qt::AlignCenter);
  setMaxLength(static_cast<int>(kMaxTextBytes / 4));  // of UTF-8
  setFixedWidth(kWidth);
  hide();
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    if (!armed_.isEmpty() && !nameOf(document_.map(), armed_)) disarm();
    if (isOpen() && !nameOf(document_.map(), key_)) dismiss();
  });
}

bool NameEditor::wants(QChar character) const {
  return !armed_.isEmpty() && character.isLetterOrNumber();
}

void NameEditor::begin(const QString& key, const QString& typed) {
  const auto name = nameOf(document_.map(), key);
  if (!name) return;
  disarm();
  key_ = key;
  setText(typed.isEmpty() ? *name : typed);
  setPlaceholderText(key);
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
  typed.isEmpty() ? selectAll() : end(false);
}

void NameEditor::commit() {
  if (!isOpen()) return;
  const QString key = key_;
  const std::string name = text().trimmed().toStdString();
  close();
  const QString step = tr("Name %1").arg(key);
  if (const Building* building = document_.map().find(key.toStdString())) {
    Building named = *building;
    named.name = name;
    document_.changeBuilding(key, std::move(named), step);
  } else if (const Landmark* landmark = findLandmark(document_.map(), key)) {
    Landmark named = *landmark;
    named.name = name;
    document_.changeLandmark(key, std::move(named), step);
  }
}

void NameEditor::dismiss() {
  if (isOpen()) close();
}

void NameEditor::close() {
  key_.clear();
  const bool had_focus = hasFocus();
  hide();
  if (had_focus) parentWidget()->setFocus(Qt::OtherFocusReason);
}

void NameEditor::placeAt(const QPointF& centre) {
  move((centre - QPointF(width() / 2.0, height() / 2.0)).toPoint());
}

bool NameEditor::event(QEvent* event) {
  // Letters and Escape are its own, whatever shortcuts there are.
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void NameEditor::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return commit();
    case Qt::Key_Escape:
      return dismiss();
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void NameEditor::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) commit();
}

}  // namespace handmap
