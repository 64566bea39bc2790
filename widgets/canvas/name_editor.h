// The name of an object, typed where the object is. Of what was just drawn it is shown and waits:
// keys are those of the tools until Enter, a click or a capital letter begins the name.
#pragma once

#include <QLineEdit>

#include "widgets/document/map_document.h"

namespace handmap {

class NameEditor : public QLineEdit {
  Q_OBJECT
 public:
  NameEditor(MapDocument& document, QWidget* canvas);

  /// Waits for the name of an object that was just made, until disarm().
  void arm(const QString& key);
  void disarm();
  bool isArmed() const { return !key_.isEmpty() && !typing_; }
  /// Whether the character begins the name of that object.
  bool wants(QChar character) const;

  /// Opens for the object with its name, or with what was typed in its place.
  void begin(const QString& key, const QString& typed = {});
  void beginArmed(const QString& typed = {}) { begin(QString(key_), typed); }
  bool isOpen() const { return !key_.isEmpty(); }
  const QString& key() const { return key_; }
  void commit();
  void dismiss();
  /// In the middle of the object, in pixels of the canvas. While it only waits, a click on it
  /// begins the name where the object is larger; else the click is the tool's.
  void placeAt(const QRectF& object);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void close();

  MapDocument& document_;
  QString key_;
  bool typing_ = false;
};

/// The name of a building or a landmark; nothing for what has none.
std::optional<QString> nameOf(const Map& map, const QString& key);

}  // namespace handmap
