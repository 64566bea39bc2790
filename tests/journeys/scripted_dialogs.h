// Answers in the person's place, in the order in which they were put in; then cancels.
#pragma once

#include <QList>
#include <QStringList>
#include <utility>

#include "widgets/messages/dialogs.h"

namespace handmap {

class ScriptedDialogs : public Dialogs {
 public:
  QStringList paths;
  QStringList texts;
  QList<int> choices;
  QList<double> figures;
  QStringList asked;  ///< titles of dialogs
  QString folder;     ///< that the last one for a folder began in

  QString fileToOpen(const File& file) override { return nextPath(file.title); }
  QString fileToSave(const File& file) override { return nextPath(file.title); }
  QString folderToOpen(const QString& title, const QString& begin) override {
    folder = begin;
    return nextPath(title);
  }
  int choose(const Question& question) override {
    asked << question.title;
    return choices.isEmpty() ? -1 : choices.takeFirst();
  }

  QList<double> numbers(const QString& title, const QList<Number>&) override {
    asked << title;
    return std::exchange(figures, {});
  }
  QString typedOrKnown(const QString& title, const QString&, const QStringList&) override {
    asked << title;
    return texts.isEmpty() ? QString() : texts.takeFirst();
  }

 private:
  QString nextPath(const QString& title) {
    asked << title;
    return paths.isEmpty() ? QString() : paths.takeFirst();
  }
};

}  // namespace handmap
