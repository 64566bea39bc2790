// What the program asks in a window of its own: files, folders, a choice. Passed in, so that tests
// answer in the person's place.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <memory>

class QWidget;

namespace handmap {

class Dialogs {
 public:
  virtual ~Dialogs() = default;

  /// What the dialog for a file says and where it begins.
  struct File {
    QString title;
    QString folder;
    QString filter;      ///< e.g. "Handmap drawings (*.handmap)"
    QString suggestion;  ///< name without a folder; to save only
    QString suffix;      ///< added to a name that has none; to save only
  };
  /// Each returns an absolute path; empty: cancelled.
  virtual QString fileToOpen(const File& file) = 0;
  virtual QString fileToSave(const File& file) = 0;
  virtual QString folderToOpen(const QString& title, const QString& folder) = 0;

  struct Question {
    QString title;
    QString text;
    QStringList answers;  ///< texts of the buttons, the first is the default
  };
  /// Index of the answer; -1: cancelled. Cancelling is always possible.
  virtual int choose(const Question& question) = 0;

  struct Number {
    QString label;
    double value;  ///< at first
    double low;
    double high;
    int decimals = 0;
    QString suffix = {};
  };
  /// One number a line; empty: cancelled.
  virtual QList<double> numbers(const QString& title, const QList<Number>& lines) = 0;

  /// What is typed, or one of the known; empty: cancelled.
  virtual QString typedOrKnown(const QString& title, const QString& label,
                               const QStringList& known) = 0;
};

/// Over `window`, which must outlive them.
std::unique_ptr<Dialogs> systemDialogs(QWidget& window);

}  // namespace handmap
