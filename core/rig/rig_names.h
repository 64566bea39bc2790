// How a rig file calls the kinds of its devices; for its reader and writer only.
#pragma once

#include <array>
#include <utility>

#include "core/rig/rig.h"

namespace handmap {

inline constexpr int kRigVersion = 1;

inline constexpr std::array kCameras = {std::pair(CameraKind::Video, "video"),
                                        std::pair(CameraKind::FireWire, "firewire"),
                                        std::pair(CameraKind::Vision, "vision")};
inline constexpr std::array kScanners = {
    std::pair(ScannerKind::Hokuyo, "hokuyo"), std::pair(ScannerKind::Rplidar, "rplidar"),
    std::pair(ScannerKind::Ros, "ros"), std::pair(ScannerKind::RosCloud, "ros-cloud")};
inline constexpr std::array kOdometries = {
    std::pair(OdometryRigKind::None, "none"), std::pair(OdometryRigKind::Lines, "lines"),
    std::pair(OdometryRigKind::Ros, "ros"), std::pair(OdometryRigKind::Visual, "visual"),
    std::pair(OdometryRigKind::Scan, "scan")};

}  // namespace handmap
