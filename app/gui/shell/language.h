// English or Japanese: as the system has it, or as somebody has chosen.
#pragma once

#include <QLocale>
#include <QObject>
#include <functional>

#include "app/gui/shell/shell.h"

class QCoreApplication;

namespace handmap {

QLocale languageOf(const QSettings& settings);

/// Installs the translators, for core too. Before the first window and the first thread: what is on
/// the screen keeps its language.
void installLanguage(QCoreApplication& app, const QSettings& settings);

/// The choice in the menu; takes effect at the next start, which it offers.
class Language : public QObject {
  Q_OBJECT
 public:
  Language(const Shell& shell, std::function<void()> start_again, QObject* parent);

 private:
  void choose(const QString& name);

  const Shell& shell_;
  std::function<void()> start_again_;
};

}  // namespace handmap
