// The guide: pages of Markdown with pictures, in a window of its own.
#pragma once

#include <QWidget>

class QLineEdit;
class QTextBrowser;

namespace handmap {

class GuideWindow : public QWidget {
  Q_OBJECT
 public:
  explicit GuideWindow(QWidget* parent = nullptr);

  /// A page by its name without an ending, e.g. "drawing"; the first one when there is none.
  void open(const QString& page = QStringLiteral("index"));
  QTextBrowser& browser() { return *browser_; }

  static QStringList pages();  ///< that there are in this language
  static QString folder();     ///< of the pages in this language, a resource

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// From here on, and through all pages once.
  void findNext();

  QTextBrowser* browser_;
  QLineEdit* search_;
};

}  // namespace handmap
