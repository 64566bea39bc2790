// The name of an object, typed where the object is.
#pragma once

#include <QLineEdit>

#include "widgets/document/map_document.h"

namespace handmap {

class NameEditor : public QLineEdit {
  Q_OBJECT
 public:
  NameEditor(MapDocument& document, QWidget* canvas);

  /// What is typed next on the canvas is the object's name, until disarm().
  void arm(const QString& key) { armed_ = key; }
  void disarm() { armed_.clear(); }
  /// Whether the character begins the name of the object that was just made.
  bool wants(QChar character) const;
  const QString& armedKey() const { return armed_; }

  /// Opens for the object with its name, or with what was typed in its place.
  void begin(const QString& key, const QString& typed = {});
  bool isOpen() const { return !key_.isEmpty(); }
  const QString& key() const { return key_; }
  void commit();
  void dismiss();
  void placeAt(const QPointF& centre);  ///< in pixels of the canvas

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void close();

  MapDocument& document_;
  QString armed_;
  QString key_;
};

/// The name of a building or a landmark; nothing for what has none.
std::optional<QString> nameOf(const Map& map, const QString& key);

}  // namespace handmap
