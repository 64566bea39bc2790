// Of a camera that pans where the robot stops.
#pragma once

namespace handmap {

/// Which view of a stop an image is.
struct Panning {
  double pan = 0.0;  ///< radians, positive to the left
  int view = 1;
  int views = 1;
};

}  // namespace handmap
