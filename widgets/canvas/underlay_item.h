// Pictures to draw upon. They are read by another thread; until then, and where one cannot be read,
// a frame with a word in it stands in their place.
#pragma once

#include <QGraphicsObject>
#include <QHash>
#include <QImage>

#include "widgets/document/map_document.h"
#include "widgets/style/colours.h"

namespace handmap {

class UnderlayItem : public QGraphicsObject {
  Q_OBJECT
 public:
  explicit UnderlayItem(const MapDocument& document);

  void rebuild();
  void reload();  ///< all pictures, also those that were read
  void setColours(const Colours& colours);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Picture {
    QImage image;
    QSize size;  ///< of the file; the image may be smaller
    QString problem;
    bool loading = true;
  };

  QString pathOf(const Underlay& underlay) const;
  void load(const QString& path);
  static Picture read(const QString& path);
  void updateBounds();
  void paintPlaceholder(QPainter& painter, const QRectF& pixels, const Underlay& underlay,
                        const Picture& picture) const;

  const MapDocument& document_;
  const Colours* colours_ = &Colours::light();
  QHash<QString, Picture> pictures_;
  QRectF bounds_;
};

}  // namespace handmap
