#include "widgets/style/names.h"

#include <QAccessible>
#include <QLineEdit>
#include <QWidget>

namespace handmap {

namespace {

QString seenOn(const QWidget& widget) {
  QString hint = widget.toolTip().section(u'\n', 0, 0);
  if (!hint.isEmpty()) return hint;
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  return line ? line->placeholderText() : QString();
}

}  // namespace

void nameInputs(QWidget& root) {
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus && !widget->inherits("QAbstractButton")) continue;
    const QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    if (!face || !face->text(QAccessible::Name).isEmpty()) continue;
    if (const QString name = seenOn(*widget); !name.isEmpty()) widget->setAccessibleName(name);
  }
}

}  // namespace handmap
