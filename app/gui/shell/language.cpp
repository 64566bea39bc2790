#include "app/gui/shell/language.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <array>
#include <utility>

#include "app/gui/shell/message_bar.h"
#include "core/base/phrase.h"
#include "widgets/actions/action_set.h"

namespace handmap {

namespace {

constexpr auto kKey = "view/language";
constexpr auto kSystem = "system";
constexpr std::array kChoices = {
    std::pair("view.language_system", kSystem),
    std::pair("view.language_en", "en"),
    std::pair("view.language_ja", "ja"),
};

QString chosen(const QSettings& settings) {
  return settings.value(kKey, QLatin1String(kSystem)).toString();
}

}  // namespace

void installLanguage(QCoreApplication& app, const QSettings& settings) {
  const QString choice = chosen(settings);
  const bool is_system = choice == QLatin1String(kSystem);
  const QLocale locale = is_system ? QLocale::system() : QLocale(choice);
  const auto install = [&](const QString& name, const QString& folder) {
    auto* translator = new QTranslator(&app);
    if (translator->load(locale, name, QStringLiteral("_"), folder))
      QCoreApplication::installTranslator(translator);
    else
      delete translator;
  };
  translatePhrases([](const char* english) {
    return QCoreApplication::translate("core", english).toStdString();
  });
  // Where neither language is that of the system, the English plurals.
  auto* plurals = new QTranslator(&app);
  if (plurals->load(QStringLiteral(":/translations/handmap_en.qm")))
    QCoreApplication::installTranslator(plurals);
  install(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(QStringLiteral("handmap"), QStringLiteral(":/translations"));
}

Language::Language(Parts parts, QObject* parent) : QObject(parent), parts_(std::move(parts)) {
  auto* group = new QActionGroup(this);
  const QString now = chosen(parts_.settings);
  for (const auto& [action, name] : kChoices) {
    group->addAction(&parts_.actions[action]);
    parts_.actions[action].setChecked(now == QLatin1String(name));
    parts_.actions.on(action, this, [this, its = name] { choose(QLatin1String(its)); });
  }
}

void Language::choose(const QString& name) {
  if (name == chosen(parts_.settings)) return;
  parts_.settings.setValue(kKey, name);
  parts_.settings.sync();
  parts_.messages
      .show(MessageBar::Kind::Info, tr("The program speaks it from its next start on."), {},
            QStringLiteral("language"))
      .addAction(tr("Start again"), parts_.start_again);
}

}  // namespace handmap
