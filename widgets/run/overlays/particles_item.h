// All particles of a run in one item: heading ticks in a few colours of weight, one drawLines() a
// colour; above kDensityFrom particles an image of their density.
#pragma once

#include <QGraphicsItem>
#include <QImage>
#include <array>
#include <vector>

#include "core/method/snapshot.h"
#include "widgets/style/colours.h"

namespace handmap {

class ParticlesItem : public QGraphicsItem {
 public:
  static constexpr std::size_t kDensityFrom = 2000;

  void setColours(const Colours& colours);
  void setParticles(const std::vector<ParticleView>& particles);
  bool showsDensity() const { return !density_.isNull(); }

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  static constexpr std::size_t kShades = 5;
  struct Tick {
    QPointF at;
    QPointF direction;
  };
  void fillShades(const std::vector<ParticleView>& particles);
  void fillDensity(const std::vector<ParticleView>& particles);

  void paintDensity(QPainter& painter, double least_m) const;
  void paintTicks(QPainter& painter, double length_m) const;

  const Colours* colours_ = &Colours::light();
  std::array<std::vector<Tick>, kShades> shades_;  ///< the strongest last
  QImage density_;                                 ///< one byte a cell: share of the fullest
  QRectF particle_bounds_;
  QRectF bounds_;
};

}  // namespace handmap
