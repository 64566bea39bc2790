#include "widgets/style/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>
#include <memory>

namespace handmap {

namespace {

class TintedSvg : public QIconEngine {
 public:
  explicit TintedSvg(std::shared_ptr<QSvgRenderer> svg) : svg_(std::move(svg)) {}

  QIconEngine* clone() const override { return new TintedSvg(svg_); }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal scale = painter->device()->devicePixelRatioF();
    QPixmap picture = pixmap((QSizeF(rect.size()) * scale).toSize(), mode, state);
    painter->drawPixmap(rect, picture);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    const int side = std::min(size.width(), size.height());
    svg_->render(&painter,
                 QRectF((size.width() - side) / 2.0, (size.height() - side) / 2.0, side, side));
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(picture.rect(), tint(mode));
    return picture;
  }

 private:
  static QColor tint(QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
    if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::Active, QPalette::ButtonText);
  }

  std::shared_ptr<QSvgRenderer> svg_;
};

}  // namespace

QIcon icon(const QString& name) {
  const QString path = QStringLiteral(":/icons/%1.svg").arg(name);
  if (!QFile::exists(path)) return {};
  return QIcon(new TintedSvg(std::make_shared<QSvgRenderer>(path)));
}

}  // namespace handmap
