#include "widgets/actions/action_set.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QMenuBar>
#include <QToolBar>

#include "widgets/style/icons.h"

namespace handmap {

namespace {

QString plainText(const char* text) { return QString::fromUtf8(text).remove(u'&'); }

QAction* makeAction(const ActionSpec& spec, QActionGroup& tools, QObject* parent) {
  auto* action = new QAction(QString::fromUtf8(spec.text), parent);
  action->setObjectName(QLatin1String(spec.id));
  if (*spec.keys) action->setShortcuts(QKeySequence::listFromString(QLatin1String(spec.keys)));
  const QString hint = QString::fromUtf8(spec.hint);
  const QString keys = action->shortcut().toString(QKeySequence::NativeText);
  action->setStatusTip(hint);
  action->setToolTip(plainText(spec.text).remove(u'…') +
                     (keys.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(keys)) + u'\n' +
                     hint);
  if (*spec.icon) action->setIcon(icon(QLatin1String(spec.icon)));
  action->setCheckable(spec.kind != ActionKind::Push);
  if (spec.kind == ActionKind::Tool) tools.addAction(action);
  return action;
}

}  // namespace

ActionSet::ActionSet(QObject* parent) : QObject(parent) {
  auto* tools = new QActionGroup(this);
  for (const ActionSpec& spec : actionTable())
    actions_.insert(QLatin1String(spec.id), makeAction(spec, *tools, this));
}

QAction& ActionSet::operator[](const QString& id) const {
  QAction* action = actions_.value(id);
  if (!action) qFatal("no action %s in the table", qPrintable(id));
  return *action;
}

void ActionSet::setEnabled(std::initializer_list<const char*> ids, bool enabled) const {
  for (const char* id : ids) (*this)[QLatin1String(id)].setEnabled(enabled);
}

void ActionSet::fillMenuBar(QMenuBar& menu_bar) const {
  QHash<Menu, QMenu*> menus;
  for (const ActionSpec& spec : actionTable()) {
    QMenu*& menu = menus[spec.menu];
    if (!menu) {
      menu = menu_bar.addMenu(QString::fromUtf8(menuTitle(spec.menu)));
      menu->setObjectName(plainText(menuTitle(spec.menu)));
    }
    if (spec.separated && !menu->isEmpty()) menu->addSeparator();
    menu->addAction(&(*this)[QLatin1String(spec.id)]);
  }
}

void ActionSet::fillToolBar(QToolBar& bar, ToolBar which) const {
  for (const ActionSpec& spec : actionTable()) {
    if (spec.tool_bar != which) continue;
    if (spec.separated && !bar.actions().isEmpty()) bar.addSeparator();
    bar.addAction(&(*this)[QLatin1String(spec.id)]);
  }
}

QString shortcutSheet() {
  QString rows;
  Menu menu = Menu::Help;
  for (const ActionSpec& spec : actionTable()) {
    if (!*spec.keys) continue;
    if (rows.isEmpty() || spec.menu != menu)
      rows += QStringLiteral("<tr><th colspan='3' align='left'><br>%1</th></tr>")
                  .arg(plainText(menuTitle(spec.menu)).toHtmlEscaped());
    menu = spec.menu;
    const QString keys = QKeySequence::listToString(
        QKeySequence::listFromString(QLatin1String(spec.keys)), QKeySequence::NativeText);
    rows +=
        QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td><b>%2</b>&nbsp;&nbsp;</td><td>%3</td></tr>")
            .arg(plainText(spec.text).remove(u'…').toHtmlEscaped(), keys.toHtmlEscaped(),
                 QString::fromUtf8(spec.hint).toHtmlEscaped());
  }
  return QStringLiteral("<table cellspacing='2'>%1</table>").arg(rows);
}

}  // namespace handmap
