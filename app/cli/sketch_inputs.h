// The drawings and true maps of the commands that study how people draw.
#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/sketch_study/sketch.h"

namespace handmap {

struct SketchInputs {
  std::vector<std::string> drawings;
  std::vector<std::string> references;  ///< one for all drawings or one each
  std::vector<double> metres;  ///< a unit of a reference; one for all, one each, or none: 1
};

void addSketchInputs(CLI::App& command, SketchInputs& inputs);

/// Throws Usage for numbers that do not go together, BadInput for what cannot be read.
std::vector<Sketch> readSketches(const SketchInputs& inputs);
/// The same true maps beside other drawings, one for each.
std::vector<Sketch> readSketches(const SketchInputs& inputs,
                                 const std::vector<std::string>& drawings);

}  // namespace handmap
