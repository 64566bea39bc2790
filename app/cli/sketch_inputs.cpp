#include "app/cli/sketch_inputs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/options.h"
#include "core/base/error.h"

namespace handmap {

namespace {

template <typename Value>
const Value& oneFor(std::size_t drawing, const std::vector<Value>& values) {
  return values.size() == 1 ? values.front() : values[drawing];
}

void checkCount(const char* option, std::size_t found, std::size_t drawings) {
  if (found == 1 || found == drawings) return;
  throw Error(ErrorCode::Usage, fmt::format("{}: found {}, expected one, or one for each of the {} "
                                            "drawings",
                                            option, found, drawings));
}

}  // namespace

void addSketchInputs(CLI::App& command, SketchInputs& inputs) {
  command
      .add_option("drawings", inputs.drawings,
                  "Drawings with the ids of the true map; or sketch maps in GeoJSON with "
                  "SketchMapia's alignment.json beside them")
      ->required()
      ->option_text("DRAWING...");
  const auto repeated = [&](const char* name, auto& values, const std::string& text,
                            const std::string& kind) -> CLI::Option* {
    return command.add_option(name, values, text)
        ->option_text(kind)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  repeated("--reference", inputs.references, "The true map: one for all, or one each (required)",
           "TRUE")
      ->required();
  repeated("--metres", inputs.metres,
           "A unit of the true map, where that is no metre: one for all, or one each", "N")
      ->check(inRange(1e-6, 1e6));
}

std::vector<Sketch> readSketches(const SketchInputs& inputs) {
  return readSketches(inputs, inputs.drawings);
}

std::vector<Sketch> readSketches(const SketchInputs& inputs,
                                 const std::vector<std::string>& drawings) {
  checkCount("--reference", inputs.references.size(), drawings.size());
  if (!inputs.metres.empty()) checkCount("--metres", inputs.metres.size(), drawings.size());
  std::vector<Sketch> sketches;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    sketches.push_back(readSketch(drawings[i], oneFor(i, inputs.references),
                                  inputs.metres.empty() ? 1.0 : oneFor(i, inputs.metres)));
  }
  return sketches;
}

}  // namespace handmap
