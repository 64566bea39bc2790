// Which robots that are none there are.
#pragma once

namespace handmap {

enum class VirtualRigKind {
  Laser,      ///< a planar laser on a robot that does not stop
  StereoHead  ///< a stereo camera on a pan-tilt head that looks around at each stop
};

}  // namespace handmap
