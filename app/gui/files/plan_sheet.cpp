#include "app/gui/files/plan_sheet.h"

#include <QBuffer>
#include <QFileInfo>
#include <QObject>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "app/gui/files/exports.h"
#include "core/base/text.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {

namespace {

constexpr int kMargin = 12;  // pixels of the screen, as all here
constexpr int kSampleWidth = 34;
constexpr int kSampleHeight = 16;
constexpr int kPictureScale = 2;  // of a PNG, for print

/// Lays the legend out in lines below the map.
class Layout {
 public:
  Layout(const MapCanvas& canvas, const PlanSheet& sheet)
      : sheet_(sheet),
        palette_(canvas.palette()),
        font_(canvas.font()),
        title_font_(canvas.font()),
        map_(canvas.viewport()->size()) {
    title_font_.setBold(true);
    title_font_.setPointSizeF(1.4 * title_font_.pointSizeF());
    title_height_ = QFontMetrics(title_font_).height() + 2 * kMargin;
    const QFontMetrics metrics(font_);
    line_height_ = std::max(metrics.height(), kSampleHeight) + 6;
    int x = kMargin;
    int y = title_height_ + map_.height() + kMargin;
    for (const auto& entry : sheet.legend) {
      const int width = kSampleWidth + 6 + metrics.horizontalAdvance(entry.second) + 2 * kMargin;
      if (x > kMargin && x + width > map_.width()) {
        x = kMargin;
        y += line_height_;
      }
      places_ << QPoint(x, y);
      x += width;
    }
    size_ = {map_.width(), sheet.legend.isEmpty() ? y : y + line_height_ + kMargin};
  }

  QSize size() const { return size_; }

  void paint(QPainter& painter, MapCanvas& canvas) const {
    painter.fillRect(QRect(QPoint(), size_), palette_.color(QPalette::Base));
    painter.setPen(palette_.color(QPalette::Text));
    painter.setFont(title_font_);
    painter.drawText(QRect(kMargin, 0, map_.width() - 2 * kMargin, title_height_),
                     Qt::AlignVCenter | Qt::AlignLeft, sheet_.title);
    const QRect map(QPoint(0, title_height_), map_);
    painter.save();
    painter.setClipRect(map);
    painter.setFont(font_);
    canvas.render(&painter, map, canvas.viewport()->rect(), Qt::IgnoreAspectRatio);
    painter.restore();
    painter.setFont(font_);
    painter.setPen(palette_.color(QPalette::Text));
    painter.drawRect(map);
    for (qsizetype i = 0; i < places_.size(); ++i) {
      const auto& [sample, name] = sheet_.legend[i];
      const QPoint at = places_[i];
      painter.drawPixmap(
          QRect(at.x(), at.y() + (line_height_ - kSampleHeight) / 2, kSampleWidth, kSampleHeight),
          sample);
      painter.drawText(QRect(at.x() + kSampleWidth + 6, at.y(), map_.width(), line_height_),
                       Qt::AlignVCenter | Qt::AlignLeft, name);
    }
  }

 private:
  const PlanSheet& sheet_;
  QPalette palette_;
  QFont font_;
  QFont title_font_;
  QSize map_;
  QSize size_;
  int title_height_ = 0;
  int line_height_ = 0;
  QList<QPoint> places_;
};

}  // namespace

void writePlan(MapCanvas& canvas, const PlanSheet& sheet, const QString& path) {
  const Layout layout(canvas, sheet);
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending != QLatin1String("svg") && ending != QLatin1String("pdf")) {
    QImage picture(layout.size() * kPictureScale, QImage::Format_RGB32);
    picture.setDevicePixelRatio(kPictureScale);
    if (!picture.isNull()) {
      QPainter painter(&picture);
      layout.paint(painter, canvas);
    }
    return writePicture(picture, path);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (ending == QLatin1String("svg")) {
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setTitle(sheet.title);
    svg.setSize(layout.size());
    svg.setViewBox(QRect(QPoint(), layout.size()));
    QPainter painter(&svg);
    layout.paint(painter, canvas);
  } else {
    constexpr int kDotsPerInch = 96;  // one of these pixels is one of the screen
    QPdfWriter pdf(&buffer);
    pdf.setTitle(sheet.title);
    pdf.setResolution(kDotsPerInch);
    pdf.setPageSize(QPageSize(QSizeF(layout.size()) * 72.0 / kDotsPerInch, QPageSize::Point));
    pdf.setPageMargins(QMarginsF());
    QPainter painter(&pdf);
    layout.paint(painter, canvas);
  }
  writeFileAtomically(path.toStdString(), bytes.toStdString());
}

}  // namespace handmap
