// English or Japanese: as the system has it, or as somebody has chosen.
#pragma once

#include <QObject>
#include <functional>

class QCoreApplication;
class QSettings;

namespace handmap {

class ActionSet;
class MessageBar;

/// Installs the translators, for core too. Before the first window and the first thread: what is on
/// the screen keeps its language.
void installLanguage(QCoreApplication& app, const QSettings& settings);

/// The choice in the menu; takes effect at the next start, which it offers.
class Language : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    const ActionSet& actions;
    MessageBar& messages;
    QSettings& settings;
    std::function<void()> start_again;
  };
  Language(Parts parts, QObject* parent);

 private:
  void choose(const QString& name);

  Parts parts_;
};

}  // namespace handmap
