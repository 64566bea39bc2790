#include "widgets/style/colours.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

namespace handmap {

namespace {

/// The two palettes differ in colour alone; how a role is drawn is the same in both.
struct Row {
  Role role;
  QRgb light;
  QRgb dark;
  double width = 1.0;
  Qt::PenStyle line = Qt::SolidLine;
  Qt::BrushStyle fill = Qt::NoBrush;
  int fill_alpha = 0;
};

constexpr auto kSolid = Qt::SolidLine;
constexpr auto kFilled = Qt::SolidPattern;

constexpr Row kRows[] = {
    {Role::Background, 0xfffbfbf9, 0xff1d2023, 1.0, kSolid, kFilled, 255},
    {Role::GridLine, 0xffefefeb, 0xff26292d},
    {Role::GridLineMajor, 0xffdfdfd9, 0xff33383d},
    {Role::Axis, 0xffbcbcb4, 0xff545b62},
    {Role::Text, 0xff1c2023, 0xfff1f2f3},
    {Role::TextHalo, 0xfffbfbf9, 0xff1d2023},
    {Role::Drawing, 0xff2e3338, 0xffdfe2e5, 1.4, kSolid, kFilled, 26},
    {Role::Selection, 0xffa8327d, 0xfff08fcb, 2.0, kSolid, kFilled, 34},
    {Role::Preview, 0xffa8327d, 0xfff08fcb, 1.4, Qt::DashLine, kFilled, 26},
    {Role::Problem, 0xffd55e00, 0xffff8a3c, 2.0, Qt::DashDotLine, kFilled, 34},
    {Role::Corrected, 0xff0072b2, 0xff56b4e9, 2.0},
    {Role::CorrectedBand, 0xff0072b2, 0xff56b4e9, 1.0, kSolid, kFilled, 56},
    {Role::Swarm, 0xff86b7d8, 0xff3a6f92, 0.8},
    {Role::Truth, 0xff009e73, 0xff2fcf9f, 2.0, Qt::DashLine},
    {Role::Particle, 0xffe69f00, 0xfff5b638, 1.5, kSolid, kFilled, 160},
    {Role::Trajectory, 0xffc47600, 0xfff5a623, 2.0},
    {Role::Odometry, 0xff7d7d7d, 0xff9aa1a8, 2.0, Qt::DotLine},
    {Role::LocalMap, 0xff6f55a0, 0xffb39ddb, 1.0, kSolid, kFilled, 160},
    {Role::Doubtful, 0xffd55e00, 0xffff8a3c, 1.5, Qt::DashDotDotLine, Qt::BDiagPattern, 255},
    {Role::Start, 0xff2e3338, 0xffdfe2e5, 2.0, kSolid, kFilled, 255},
    {Role::Route, 0xff5a6067, 0xffaab0b6, 1.6, Qt::DashDotLine},
    {Role::Landmark, 0xff2e3338, 0xffdfe2e5, 1.6, kSolid, kFilled, 255},
};
static_assert(std::size(kRows) == static_cast<std::size_t>(Role::Count));

constexpr double kCasing = 1.25;  // pixels of a casing on either side of its line

/// A cosmetic pen is as wide in pixels of the device, which are finer on some screens.
double devicePixels(double width_px) {
  return width_px * (qGuiApp != nullptr ? qGuiApp->devicePixelRatio() : 1.0);
}

const Row& rowOf(Role role) { return kRows[static_cast<std::size_t>(role)]; }

}  // namespace

QPen cosmeticPen(const QColor& colour, double width_px) {
  QPen pen(colour, devicePixels(width_px));
  pen.setCosmetic(true);
  return pen;
}

const Colours& Colours::light() {
  static const Colours kColours(false);
  return kColours;
}

const Colours& Colours::dark() {
  static const Colours kColours(true);
  return kColours;
}

const Colours& Colours::of(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? dark() : light();
}

QColor Colours::operator[](Role role) const {
  return QColor::fromRgb(dark_ ? rowOf(role).dark : rowOf(role).light);
}

QPen Colours::pen(Role role) const {
  const Row& row = rowOf(role);
  QPen pen = cosmeticPen((*this)[role], row.width);
  pen.setStyle(row.line);
  pen.setCapStyle(Qt::FlatCap);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

QPen Colours::casing(const QPen& line) const {
  QPen pen((*this)[Role::TextHalo], line.widthF() + devicePixels(2.0 * kCasing), Qt::SolidLine,
           Qt::SquareCap, Qt::RoundJoin);
  pen.setCosmetic(true);
  return pen;
}

QBrush Colours::brush(Role role) const {
  QColor colour = (*this)[role];
  colour.setAlpha(rowOf(role).fill_alpha);
  return {colour, rowOf(role).fill};
}

QColor Colours::particle(double share) const {
  QColor colour = (*this)[Role::Particle];
  colour.setAlphaF(static_cast<float>(0.25 + 0.75 * std::clamp(share, 0.0, 1.0)));
  return colour;
}

}  // namespace handmap
