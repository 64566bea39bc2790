#include "widgets/actions/action_set.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <algorithm>

#include "widgets/style/icons.h"

namespace handmap {

namespace {

constexpr auto kKeysGroup = "keys";
constexpr auto kWhyNot = "why_not";

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

QString plain(QString text) {
  // Of a translation the mnemonic may stand behind in brackets: "開く(&O)…"
  const qsizetype bracket = text.indexOf(QLatin1String("(&"));
  if (bracket >= 0) text.remove(bracket, 4);
  return text.remove(u'&').remove(u'…');
}

const ActionSpec& specOf(const QString& id) {
  return *std::ranges::find(actionTable(), id,
                            [](const ActionSpec& spec) { return QLatin1String(spec.id); });
}

void showToolTip(QAction& action) {
  const ActionSpec& spec = specOf(action.objectName());
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  QString text = plainTextOf(spec);
  if (!keys.isEmpty()) text += QStringLiteral(" (%1)").arg(keys);
  text += u'\n' + hintOf(spec);
  const QString why_not = action.property(kWhyNot).toString();
  if (!action.isEnabled() && !why_not.isEmpty())
    text += u'\n' + QCoreApplication::translate("Actions", "Not now: %1").arg(why_not);
  action.setToolTip(text);
}

QAction* makeAction(const ActionSpec& spec, QActionGroup& tools, QObject* parent) {
  auto* action = new QAction(translated(spec.text), parent);
  action->setObjectName(QLatin1String(spec.id));
  action->setShortcuts(ActionSet::usualKeys(spec));
  action->setIconText(plainTextOf(spec));  // beside a tool button's icon
  action->setStatusTip(hintOf(spec));
  if (*spec.icon) action->setIcon(icon(QLatin1String(spec.icon)));
  action->setCheckable(spec.kind != ActionKind::Push);
  if (spec.kind == ActionKind::Tool) tools.addAction(action);
  showToolTip(*action);
  return action;
}

}  // namespace

QString plainTextOf(const ActionSpec& spec) { return plain(translated(spec.text)); }
QString hintOf(const ActionSpec& spec) { return translated(spec.hint); }
QString plainTitleOf(Menu menu) { return plain(translated(menuTitle(menu))); }

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

void ActionSet::setEnabled(std::initializer_list<const char*> ids, bool enabled,
                           const QString& why_not) const {
  for (const char* id : ids) {
    QAction& action = (*this)[QLatin1String(id)];
    if (action.isEnabled() == enabled && action.property(kWhyNot).toString() == why_not) continue;
    action.setEnabled(enabled);
    action.setProperty(kWhyNot, why_not);
    showToolTip(action);
  }
}

QString ActionSet::whyNot(const QString& id) const {
  const QAction& action = (*this)[id];
  return action.isEnabled() ? QString() : action.property(kWhyNot).toString();
}

// --- Keys

QList<QKeySequence> ActionSet::usualKeys(const ActionSpec& spec) {
  return *spec.keys ? QKeySequence::listFromString(QLatin1String(spec.keys))
                    : QList<QKeySequence>();
}

QList<QKeySequence> ActionSet::keys(const QString& id) const { return (*this)[id].shortcuts(); }

QString ActionSet::ownerOf(const QList<QKeySequence>& keys, const QString& id) const {
  for (const ActionSpec& spec : actionTable()) {
    QString other = QLatin1String(spec.id);
    if (other == id) continue;
    for (const QKeySequence& theirs : this->keys(other))
      if (keys.contains(theirs)) return other;
  }
  return {};
}

void ActionSet::setKeys(const QString& id, const QList<QKeySequence>& keys) const {
  QAction& action = (*this)[id];
  action.setShortcuts(keys);
  showToolTip(action);
}

void ActionSet::saveKeys(QSettings& settings) const {
  settings.remove(kKeysGroup);
  settings.beginGroup(kKeysGroup);
  for (const ActionSpec& spec : actionTable()) {
    const QString id = QLatin1String(spec.id);
    if (keys(id) != usualKeys(spec))
      settings.setValue(id, QKeySequence::listToString(keys(id), QKeySequence::PortableText));
  }
  settings.endGroup();
}

void ActionSet::restoreKeys(const QSettings& settings) const {
  for (const ActionSpec& spec : actionTable()) {
    const QString id = QLatin1String(spec.id);
    const QVariant chosen =
        settings.value(QStringLiteral("%1/%2").arg(QLatin1String(kKeysGroup), id));
    if (chosen.isValid()) setKeys(id, QKeySequence::listFromString(chosen.toString()));
  }
}

// --- Menus and bars

void ActionSet::fillMenuBar(QMenuBar& menu_bar) const {
  QHash<Menu, QMenu*> menus;
  for (const ActionSpec& spec : actionTable()) {
    QMenu*& menu = menus[spec.menu];
    if (!menu) {
      menu = menu_bar.addMenu(translated(menuTitle(spec.menu)));
      menu->setObjectName(QString::fromUtf8(menuTitle(spec.menu)).remove(u'&'));
      menu->setToolTipsVisible(true);  // they say why something cannot be done
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

}  // namespace handmap
