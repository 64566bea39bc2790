// What is wrong with each thing of a drawing, once shift, turn and scale are taken away.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sketch_study/sketch.h"

namespace handmap {

/// Lengths are those of the truth, metres.
struct DrawnError {
  Vec2 off = Vec2::Zero();  ///< of the place
  double freedom = 1.0;     ///< share of σ² that the fit of the drawing leaves in each coordinate
  Vec2 fullOff() const;     ///< as large as it would be without that
  double size = 0.0;        ///< of the truth: root of the area; 0: a landmark
  std::optional<double> log_size;  ///< ln(drawn / true size), as drawn to the scale of the places
  double nearest = 0.0;            ///< to the nearest other true place that was drawn
  double off_product = 0.0;        ///< its error · that of the nearest, per coordinate
  double product_loss = 0.0;       ///< share of σ² that the fit of the drawing takes from that
  std::optional<double> turn;      ///< of the outline, within ±45°, radians
  int corners = 0;                 ///< drawn
  int right_corners = 0;           ///< of them, within 10° of a right angle
  int true_corners = 0;
  int true_right_corners = 0;
};

struct DrawnErrors {
  std::string name;
  double scale = 1.0;       ///< drawn units a metre
  double turn = 0.0;        ///< of the whole drawing, radians
  double extent = 0.0;      ///< σ of the true places that were drawn, per coordinate, metres
  int objects = 0;          ///< of the truth
  int represented = 0;      ///< of them: drawn, or in a group that was drawn
  double order_kept = 0.0;  ///< canonical accuracy once the turn is taken away
  std::vector<DrawnError> of;
};

/// nullopt where fewer than three things are drawn.
std::optional<DrawnErrors> drawnErrors(const Sketch& sketch);

}  // namespace handmap
