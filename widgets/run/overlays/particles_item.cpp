#include "widgets/run/overlays/particles_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <cmath>

#include "widgets/run/overlays/averaged_image.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr double kTickM = 1.0;
constexpr double kTickAtLeastPx = 7.0;
constexpr double kDensityAtLeastPx = 5.0;
constexpr double kCloudMarginM = 20.0;  // room for ticks of that many pixels when zoomed out far
constexpr int kDensityCells = 256;      // on the longer side

QRectF boundsOf(const std::vector<ParticleView>& particles) {
  if (particles.empty()) return {};
  Vec2 low = particles.front().pose.position();
  Vec2 high = low;
  for (const ParticleView& particle : particles) {
    low = low.cwiseMin(particle.pose.position());
    high = high.cwiseMax(particle.pose.position());
  }
  return {toScene(low), toScene(high)};
}

}  // namespace

void ParticlesItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void ParticlesItem::setParticles(const std::vector<ParticleView>& particles) {
  prepareGeometryChange();
  particle_bounds_ = boundsOf(particles);
  bounds_ = particles.empty() ? QRectF()
                              : particle_bounds_.adjusted(-kCloudMarginM, -kCloudMarginM,
                                                          kCloudMarginM, kCloudMarginM);
  for (auto& shade : shades_) shade.clear();
  density_ = {};
  if (particles.size() > kDensityFrom) {
    fillDensity(particles);
  } else {
    fillShades(particles);
  }
}

void ParticlesItem::fillShades(const std::vector<ParticleView>& particles) {
  double greatest = 0.0;
  for (const ParticleView& particle : particles) greatest = std::max(greatest, particle.weight);
  for (const ParticleView& particle : particles) {
    const double share = greatest > 0.0 ? particle.weight / greatest : 0.0;
    const auto shade = static_cast<std::size_t>(share * (kShades - 0.001));
    shades_[shade].push_back(
        {toScene(particle.pose.position()), toScene(unitVector(particle.pose.heading))});
  }
}

void ParticlesItem::fillDensity(const std::vector<ParticleView>& particles) {
  const double longer = std::max({particle_bounds_.width(), particle_bounds_.height(), 1e-3});
  const double cells_per_m = (kDensityCells - 1) / longer;
  const int columns = static_cast<int>(particle_bounds_.width() * cells_per_m) + 1;
  const int rows = static_cast<int>(particle_bounds_.height() * cells_per_m) + 1;
  std::vector<int> counts(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (const ParticleView& particle : particles) {
    const int column = static_cast<int>((particle.pose.x - particle_bounds_.left()) * cells_per_m);
    const int row = static_cast<int>((particle.pose.y - particle_bounds_.top()) * cells_per_m);
    ++counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(column)];
  }
  const double fullest = std::log1p(std::ranges::max(counts));
  density_ = QImage(columns, rows, QImage::Format_Alpha8);
  auto count = counts.begin();
  for (int row = 0; row < rows; ++row) {
    uchar* line = density_.scanLine(row);
    for (int column = 0; column < columns; ++column) {
      line[column] = static_cast<uchar>(255.0 * std::log1p(*count++) / fullest);
    }
  }
  particle_bounds_.setSize(QSizeF(columns, rows) / cells_per_m);
}

void ParticlesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const double pixels_per_metre =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  if (showsDensity()) {
    paintDensity(*painter, kDensityAtLeastPx / std::max(pixels_per_metre, 1e-6));
  } else {
    paintTicks(*painter, std::max(kTickM, kTickAtLeastPx / std::max(pixels_per_metre, 1e-6)));
  }
}

void ParticlesItem::paintDensity(QPainter& painter, double least_m) const {
  QImage tinted(density_.size(), QImage::Format_ARGB32_Premultiplied);
  tinted.fill(colours_->particle(1.0));
  tinted.setAlphaChannel(density_);
  QRectF area(QPointF(), particle_bounds_.size().expandedTo({least_m, least_m}));
  area.moveCenter(particle_bounds_.center());
  painter.drawImage(area, averagedFor(painter, area, tinted));
}

void ParticlesItem::paintTicks(QPainter& painter, double length_m) const {
  painter.setRenderHint(QPainter::Antialiasing);
  QList<QLineF> ticks;
  QPolygonF dots;
  for (std::size_t shade = 0; shade < kShades; ++shade) {
    ticks.clear();
    dots.clear();
    for (const Tick& tick : shades_[shade]) {
      ticks.append({tick.at, tick.at + length_m * tick.direction});
      dots.append(tick.at);
    }
    const double share = static_cast<double>(shade + 1) / kShades;
    painter.setPen(cosmeticPen(colours_->particle(share), 1.2));
    painter.drawLines(ticks);
    QPen pen = cosmeticPen(colours_->particle(share), 3.0);
    pen.setCapStyle(Qt::RoundCap);
    painter.setPen(pen);
    painter.drawPoints(dots);
  }
}

}  // namespace handmap
