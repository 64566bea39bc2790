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
  setFocusPolicy(Qt::ClickFocus);
  hide();
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    if (isOpen() && !nameOf(document_.map(), key_)) dismiss();
  });
}

void NameEditor::arm(const QString& key) {
  if (isOpen()) commit();
  if (!nameOf(document_.map(), key)) return;
  key_ = key;
  clear();
  setPlaceholderText(tr("Name: Enter"));
  show();
  raise();
}

void NameEditor::disarm() {
  if (isArmed()) close();
}

/// A capital, or a letter of a script that has none: the others are keys of tools.
bool NameEditor::wants(QChar character) const {
  return isArmed() && character.isLetter() && !character.isLower();
}

void NameEditor::begin(const QString& key, const QString& typed) {
  const auto name = nameOf(document_.map(), key);
  if (!name) return;
  key_ = key;
  typing_ = true;
  setAttribute(Qt::WA_TransparentForMouseEvents, false);
  setText(typed.isEmpty() ? *name : typed);
  setPlaceholderText(key);
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
  typed.isEmpty() ? selectAll() : end(false);
}

void NameEditor::commit() {
  if (!isOpen()) return;
  if (!typing_) return close();
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
  typing_ = false;
  // Before it is hidden: who hides with the focus hands it on as Tab does, to the next object.
  if (hasFocus()) parentWidget()->setFocus(Qt::OtherFocusReason);
  hide();
}

void NameEditor::placeAt(const QRectF& object) {
  move((object.center() - QPointF(width() / 2.0, height() / 2.0)).toPoint());
  setAttribute(Qt::WA_TransparentForMouseEvents,
               isArmed() && !object.contains(geometry().toRectF()));
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

void NameEditor::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  if (isArmed()) beginArmed();
}

void NameEditor::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (typing_ && event->reason() != Qt::PopupFocusReason) commit();
}

}  // namespace handmap
