#include "app/gui/shell/language.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <array>
#include <utility>

#include "core/base/phrase.h"
#include "widgets/actions/action_set.h"
#include "widgets/messages/message_bar.h"

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

QLocale languageOf(const QSettings& settings) {
  const QString choice = chosen(settings);
  return choice == QLatin1String(kSystem) ? QLocale::system() : QLocale(choice);
}

void installLanguage(QCoreApplication& app, const QSettings& settings) {
  const QLocale locale = languageOf(settings);
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

Language::Language(const Shell& shell, std::function<void()> start_again, QObject* parent)
    : QObject(parent), shell_(shell), start_again_(std::move(start_again)) {
  auto* group = new QActionGroup(this);
  const QString now = chosen(shell_.settings);
  for (const auto& [action, name] : kChoices) {
    group->addAction(&shell_.actions[action]);
    shell_.actions[action].setChecked(now == QLatin1String(name));
    shell_.actions.on(action, this, [this, its = name] { choose(QLatin1String(its)); });
  }
}

void Language::choose(const QString& name) {
  if (name == chosen(shell_.settings)) return;
  shell_.settings.setValue(kKey, name);
  shell_.settings.sync();
  shell_.messages
      .show(MessageBar::Kind::Info,
            tr("The other language comes with the next start of the program."), {},
            QStringLiteral("language"))
      .addAction(tr("Start again"), start_again_);
}

}  // namespace handmap
