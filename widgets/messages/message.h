// One message above the canvas: what has happened, and buttons for what can be done about it.
#pragma once

#include <QFrame>
#include <functional>

class QBoxLayout;
class QHBoxLayout;
class QImage;
class QLabel;
class QTimer;

namespace handmap {

class Message : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { Info, Warning, Error };

  explicit Message(QString topic, QWidget* parent = nullptr);

  /// Another text in place of the old one; its buttons go. The same text again counts up.
  void setText(Kind kind, const QString& text, const QString& hint);
  enum class Then { Close, Stay };
  /// A button; it takes the message away, unless it is to stay, and then does what it says.
  void addAction(const QString& text, std::function<void()> action, Then then = Then::Close);
  void setPicture(const QImage& picture);
  /// A question stays until it is answered by a button or put off by its cross.
  void setQuestion();

  bool isQuestion() const { return question_; }
  const QString& topic() const { return topic_; }
  QString text() const;

 Q_SIGNALS:
  void dismissed();
  void putOff();   ///< by the cross, after dismissed()
  void resized();  ///< it may need more room, or less

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void applyColours();
  void letGoInTime();

  QString topic_;
  QString plain_;  ///< the text without its count
  Kind kind_ = Kind::Info;
  int times_ = 0;
  bool question_ = false;
  QLabel* icon_;
  QLabel* picture_;
  QLabel* text_;
  QBoxLayout* body_;  ///< the text, and beside or below it
  QHBoxLayout* buttons_;
  QTimer* timer_;
};

}  // namespace handmap
