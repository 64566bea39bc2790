// An observation as a method takes it, and its form on disk.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/perception/perception.h"
#include "core/recording/observation.h"

namespace handmap {

struct Perceived {
  Observation observation;  ///< without its views
  Percept percept;          ///< without its pictures
};

/// Of the lists in it; what it takes in memory and, nearly, on disk.
std::size_t bytesOf(const Perceived& perceived);

/// As this machine has it in memory: for what the same program reads again.
std::vector<std::byte> packed(const Perceived& perceived);
/// nullptr where the bytes are not all there.
std::shared_ptr<const Perceived> unpacked(std::span<const std::byte> bytes);

}  // namespace handmap
