// Pictures to draw upon. They are read by another thread; until then, and where one cannot be read,
// a frame with a word in it stands in their place.
#pragma once

#include <QGraphicsObject>
#include <QHash>
#include <optional>

#include "widgets/document/map_document.h"
#include "widgets/pictures/picture_file.h"
#include "widgets/style/colours.h"

namespace handmap {

class UnderlayItem : public QGraphicsObject {
  Q_OBJECT
 public:
  explicit UnderlayItem(const MapDocument& document);

  void rebuild();
  void reload();  ///< all pictures, also those that were read
  void setColours(const Colours& colours);
  /// Shown in place of the document's; nullptr: nothing.
  void setPreview(const MapChange* preview);
  /// Of the picture at that place of the document's list, pixels; a guess until it is read.
  QSize sizeOf(std::size_t place) const;
  QRectF boundsOf(std::size_t place) const;  ///< metres; of the document's

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Entry {
    Picture picture;
    QString problem;
    bool loading = true;
  };

  QString pathOf(const Underlay& underlay) const;
  void load(const QString& path);
  static Entry read(const QString& path);
  const std::vector<Underlay>& shown() const;
  QSize sizeOf(const Underlay& underlay) const;
  void updateBounds();
  void paintPlaceholder(QPainter& painter, const QRectF& pixels, const Underlay& underlay,
                        const Entry& entry) const;

  const MapDocument& document_;
  const Colours* colours_ = &Colours::light();
  QHash<QString, Entry> entries_;
  std::optional<std::vector<Underlay>> preview_;
  QRectF bounds_;
};

}  // namespace handmap
