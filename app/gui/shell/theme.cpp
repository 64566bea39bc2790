#include "app/gui/shell/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QPalette>
#include <QSettings>
#include <array>

#include "widgets/actions/action_set.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr auto kThemeKey = "view/theme";
constexpr auto kService = "org.freedesktop.portal.Desktop";
constexpr auto kPath = "/org/freedesktop/portal/desktop";
constexpr auto kInterface = "org.freedesktop.portal.Settings";
constexpr auto kGroup = "org.freedesktop.appearance";
constexpr auto kScheme = "color-scheme";

struct NamedTheme {
  Theme::Choice choice;
  const char* action;
  const char* name;  ///< in the settings
};
constexpr std::array kThemes = {
    NamedTheme{Theme::Choice::System, "view.theme_system", "system"},
    NamedTheme{Theme::Choice::Light, "view.theme_light", "light"},
    NamedTheme{Theme::Choice::Dark, "view.theme_dark", "dark"},
};

QPalette paletteOf(bool dark) {
  const QColor window = dark ? QColor(0x2a, 0x2d, 0x31) : QColor(0xef, 0xef, 0xec);
  const QColor base = dark ? QColor(0x3a, 0x3e, 0x43) : QColor(Qt::white);
  const QColor text = dark ? QColor(0xf1, 0xf2, 0xf3) : QColor(0x1c, 0x20, 0x23);
  const QColor faint = dark ? QColor(0x8a, 0x91, 0x98) : QColor(0x8c, 0x8c, 0x86);
  QPalette palette(window);  // shades of all buttons and frames
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, dark ? window.darker(110) : window.lighter(104));
  palette.setColor(QPalette::ToolTipBase, dark ? window.lighter(130) : QColor(0xff, 0xff, 0xe8));
  palette.setColor(QPalette::Highlight, dark ? QColor(0x2f, 0x6f, 0xa8) : QColor(0x00, 0x72, 0xb2));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, dark ? QColor(0x56, 0xb4, 0xe9) : QColor(0x00, 0x5f, 0x96));
  return palette;
}

}  // namespace

Theme::Theme(const ActionSet& actions, QSettings& settings, QObject* parent)
    : QObject(parent), actions_(actions), settings_(settings) {
  auto* group = new QActionGroup(this);
  const QString chosen = settings.value(kThemeKey).toString();
  for (const NamedTheme& named : kThemes) {
    group->addAction(&actions[named.action]);
    actions.on(named.action, this, [this, choice = named.choice] { choose(choice); });
    if (chosen == QLatin1String(named.name)) choice_ = named.choice;
  }
  for (const NamedTheme& named : kThemes)
    if (named.choice == choice_) actions[named.action].setChecked(true);
  askSystem();
  if (choice_ != Choice::System) apply();
}

/// Some desktops tell of darkness only here. Without a session there is nobody to ask.
void Theme::askSystem() {
  if (!qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS")) return;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(onSystemSetting(QString, QString, QDBusVariant)));
  QDBusMessage question =
      QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
  question << QString::fromLatin1(kGroup) << QString::fromLatin1(kScheme);
  auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
    const QDBusPendingReply<QDBusVariant> reply = *answer;
    if (reply.isValid()) takeSystem(reply.value().variant());
    answer->deleteLater();
  });
}

void Theme::onSystemSetting(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group == QLatin1String(kGroup) && key == QLatin1String(kScheme)) takeSystem(value.variant());
}

void Theme::takeSystem(const QVariant& value) {
  constexpr uint kPrefersDark = 1;
  const bool nested = value.canConvert<QDBusVariant>();
  const QVariant number = nested ? value.value<QDBusVariant>().variant() : value;
  system_is_dark_ = number.toUInt() == kPrefersDark;
  if (choice_ == Choice::System) apply();
}

void Theme::choose(Choice choice) {
  choice_ = choice;
  for (const NamedTheme& named : kThemes)
    if (named.choice == choice) settings_.setValue(kThemeKey, QLatin1String(named.name));
  apply();
}

void Theme::apply() const {
  if (choice_ != Choice::System)
    return QApplication::setPalette(paletteOf(choice_ == Choice::Dark));
  QApplication::setPalette(QPalette());  // what the style of the desktop has
  const bool is_dark = &Colours::of(QGuiApplication::palette()) == &Colours::dark();
  if (system_is_dark_ && !is_dark) QApplication::setPalette(paletteOf(true));
}

}  // namespace handmap
