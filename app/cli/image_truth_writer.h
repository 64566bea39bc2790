// Writes what rendered pixels really show beside the images of a recording.
#pragma once

#include <filesystem>
#include <vector>

#include "core/recording/observation.h"
#include "core/rendering/renderer.h"

namespace handmap {

/// labels/NNNNNN.png: a class per pixel (core/rendering/label.h), 8 bit. depth/NNNNNN.png: depth
/// along the optical axis in centimetres, 16 bit; 0 for the sky and past 655.35 m. Both are named
/// like the left image. `truths` in the order of the observation's views. Throws RunFailed.
void writeImageTruth(const std::filesystem::path& folder, const Observation& observation,
                     const std::vector<ImageTruth>& truths);

}  // namespace handmap
