#include "widgets/run/overlays/pose_spread_item.h"

#include <QPainter>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/method/pose_trust.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr int kCorners = 48;
constexpr double kRayPx = 46.0;
constexpr double kLeastHeading = toRadians(3.0);  // a narrower cone would look like a way ahead
constexpr double kMostHeading = kPi / 2.0;        // what is wider tells no direction
constexpr double kMarginM = 60.0;                 // room for rays of so many pixels when zoomed out

}  // namespace

void PoseSpreadItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void PoseSpreadItem::setReport(const FrameReport& report) {
  prepareGeometryChange();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(positionCovariance(report));
  const Eigen::Vector2d lengths = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Matrix2d root = axes.eigenvectors() * lengths.asDiagonal();
  ellipse_.clear();
  for (int i = 0; i < kCorners; ++i) {
    const Vec2 corner = report.pose.position() + root * unitVector(2.0 * kPi * i / kCorners);
    ellipse_ << toScene(corner);
  }
  at_ = toScene(report.pose.position());
  const double turn = std::min(report.pose_sigma[2], kMostHeading);
  heading_.clear();
  if (turn >= kLeastHeading)
    heading_ = {toScene(unitVector(report.pose.heading - turn)),
                toScene(unitVector(report.pose.heading + turn))};
  bounds_ = ellipse_.boundingRect().adjusted(-kMarginM, -kMarginM, kMarginM, kMarginM);
}

void PoseSpreadItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  QColor fill = (*colours_)[Role::Trajectory];
  fill.setAlpha(50);
  painter->setPen(cosmeticPen((*colours_)[Role::Trajectory], 1.2));
  painter->setBrush(fill);
  painter->drawPolygon(to_device.map(ellipse_));
  const QPointF at = to_device.map(at_);
  for (const QPointF& direction : heading_) {
    const QLineF ray(at, to_device.map(at_ + direction));
    if (ray.length() > 0.0) painter->drawLine(at, ray.pointAt(kRayPx / ray.length()));
  }
  painter->restore();
}

}  // namespace handmap
