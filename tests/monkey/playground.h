// The window that the monkey plays with, files of every kind around it, and what must hold whatever
// it does.
#pragma once

#include <QSettings>
#include <QTemporaryDir>
#include <memory>

#include "app/gui/window/main_window.h"
#include "tests/monkey/steps.h"

namespace handmap {

class Playground {
 public:
  Playground();
  ~Playground();
  Playground(const Playground&) = delete;
  Playground& operator=(const Playground&) = delete;

  /// Does the steps in a new window. Returns what does not hold afterwards; empty: all is well.
  QString play(const Steps& steps);

 private:
  class Answers;

  void makeFiles();
  void makeLockedFile();
  void openWindow();
  void take(const Step& step);
  void stroke(std::uint32_t value);
  void press(std::uint32_t value);
  void drop(const QString& path);
  void settle();
  /// While nothing can be undone the map is what undoing must come back to.
  void noteBottom();
  QString checked();
  QString path(const QString& name) const { return folder_.filePath(name); }

  QTemporaryDir folder_;
  QSettings settings_;
  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<MainWindow> window_;
  std::uint32_t value_ = 0;  ///< of the step at work: chooses the answers
  std::string bottom_;
  QStringList thrown_;  ///< by slots
};

}  // namespace handmap
