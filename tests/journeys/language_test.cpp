// Every text of the program in every language, and the window in Japanese.
#include "app/gui/shell/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include "tests/journeys/window_test.h"
#include "widgets/actions/action_set.h"
#include "widgets/run/overlays/layers.h"

namespace handmap {
namespace {

struct Entry {
  QString context;
  QString source;
  QStringList translations;  ///< one, or one a plural form
  bool finished = true;
};

std::vector<Entry> entriesOf(const char* language) {
  QFile file(QStringLiteral(HANDMAP_TRANSLATIONS "/handmap_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << language;
  QXmlStreamReader xml(&file);
  std::vector<Entry> entries;
  QString context;
  bool numerus = false;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("message")) numerus = xml.attributes().hasAttribute("numerus");
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source"))
      entries.push_back({context, xml.readElementText(), {}});
    if (xml.name() == QLatin1String("numerusform"))
      entries.back().translations << xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    entries.back().finished = !xml.attributes().hasAttribute("type");
    if (!numerus) entries.back().translations << xml.readElementText();
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return entries;
}

/// "%1", "%2" … and "%n"; of phrases "{0}", "{1:.1f}" …, also where their numbers are left out.
/// Sorted.
QStringList placesIn(const QString& context, QString text) {
  QStringList places;
  if (context == QLatin1String("core")) {
    static const QRegularExpression kField(QStringLiteral("\\{(\\d*)(:[^}]*)?\\}"));
    text.remove("{{").remove("}}");
    for (auto match = kField.globalMatch(text); match.hasNext();) {
      const auto field = match.next();
      const QString number = field.captured(1);
      places << (number.isEmpty() ? QString::number(places.size()) : number) + field.captured(2);
    }
  }
  static const QRegularExpression kPlace(QStringLiteral("%(\\d|n)"));
  for (auto match = kPlace.globalMatch(text); match.hasNext();) places << match.next().captured();
  places.sort();
  return places;
}

TEST(Translations, NoneIsUnfinishedAndNoneLosesANumber) {
  for (const char* language : {"ja", "en"}) {
    const std::vector<Entry> entries = entriesOf(language);
    EXPECT_FALSE(entries.empty()) << language;
    for (const Entry& entry : entries) {
      EXPECT_TRUE(entry.finished && !entry.translations.join(QString()).isEmpty())
          << language << ": " << entry.context.toStdString() << ": " << entry.source.toStdString();
      for (const QString& text : entry.translations)
        EXPECT_EQ(placesIn(entry.context, text), placesIn(entry.context, entry.source))
            << text.toStdString();
    }
  }
}

/// lupdate loses the namespace of some callers; what it then files under is never asked for.
TEST(Translations, EveryContextIsOneThatIsAskedFor) {
  const QStringList without_namespace{"Actions", "FigureWords", "QObject", "TimeLeft", "core"};
  for (const char* language : {"ja", "en"}) {
    for (const Entry& entry : entriesOf(language)) {
      EXPECT_TRUE(entry.context.startsWith("handmap::") ||
                  without_namespace.contains(entry.context))
          << language << ": " << entry.context.toStdString() << ": " << entry.source.toStdString();
    }
  }
}

/// Of somebody who draws and has never heard of the method. What only the published method has
/// may be called as its paper calls it.
TEST(Translations, NoWordOfTheMethodWhereAPersonDraws) {
  static const QRegularExpression kNever(
      "\\b(told by|tells? the "
      "motion|1-σ|sigma|hypothes[ei]s|labels|posterior|covariance|nats|every "
      "1|is taken for it)\\b|σ|, %\\d m( off)?$");
  static const QRegularExpression kOfThePaper("\\b(particles?|swarms?)\\b",
                                              QRegularExpression::CaseInsensitiveOption);
  const QStringList may_say_so{"handmap::PhaseWords", "handmap::RunSetupPanel",
                               "handmap::LayersPanel", "handmap::ChartsPanel",
                               "handmap::RunWorker"};
  for (const Entry& entry : entriesOf("ja")) {
    if (entry.context == QLatin1String("core")) continue;  // names keys of files too
    EXPECT_FALSE(kNever.match(entry.source).hasMatch())
        << entry.context.toStdString() << ": " << entry.source.toStdString();
    EXPECT_TRUE(may_say_so.contains(entry.context) || !kOfThePaper.match(entry.source).hasMatch())
        << entry.context.toStdString() << ": " << entry.source.toStdString();
  }
}

class Translated : public WindowTest {
 protected:
  void speak(const char* language) {
    settings_.setValue("view/language", language);
    installLanguage(*qApp, settings_);
  }
  ~Translated() override {
    for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(translator);
      delete translator;
    }
  }
};

TEST_F(Translated, EveryActionAndLayerIsTaken) {
  speak("ja");
  for (const ActionSpec& spec : actionTable()) {
    for (const char* text : {spec.text, spec.hint}) {
      const bool is_name_of_a_language = QLatin1String(text) == QLatin1String("&English");
      EXPECT_TRUE(is_name_of_a_language ||
                  QCoreApplication::translate("Actions", text) != QString::fromUtf8(text))
          << text << ": ./dev translate takes new texts up into resources/translations";
    }
  }
  for (const LayerSpec& spec : kLayers)
    EXPECT_NE(QCoreApplication::translate("handmap::LayersPanel", spec.text),
              QString::fromUtf8(spec.text));
}

TEST_F(Translated, TheWindowSpeaksJapaneseAndCountsInEnglish) {
  speak("ja");
  auto window = open();
  EXPECT_EQ(window->menuBar()->actions().front()->text(), "ファイル(&F)");
  EXPECT_TRUE(action(*window, "file.save")->toolTip().startsWith("保存 (Ctrl+S)"));
  window.reset();
  speak("en");
  EXPECT_EQ(QCoreApplication::translate("handmap::IssuesPanel", "%n issue(s); a click shows where.",
                                        nullptr, 1),
            "1 issue; a click shows where.");
  EXPECT_EQ(QCoreApplication::translate("handmap::IssuesPanel", "%n issue(s); a click shows where.",
                                        nullptr, 2),
            "2 issues; a click shows where.");
}

}  // namespace
}  // namespace handmap
