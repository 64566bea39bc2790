// Kinds of options that CLI11 does not have, and checks of outputs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/recording/recording.h"
#include "core/recording/recording_files.h"
#include "core/simulation/misdrawn.h"

namespace handmap {

/// A finite number within the bounds, in C notation whatever the locale.
CLI::Validator inRange(double low, double high);

/// An option that takes such a number. The help tells the bounds and the default, which is the
/// value now (none for a std::optional).
template <typename Number>
CLI::Option* addNumber(CLI::App& command, const std::string& name, Number& value, double low,
                       double high, const std::string& text) {
  std::string range = fmt::format("{} to {}", low, high);
  if constexpr (std::is_arithmetic_v<Number>) range += fmt::format(", default {}", value);
  return command.add_option(name, value, fmt::format("{} ({})", text, range))
      ->check(inRange(low, high))
      ->option_text("N");
}

/// An option that takes two such numbers from 0 on, as "2,5"; `words` names them.
CLI::Option* addPair(CLI::App& command, const std::string& name,
                     const std::function<void(double, double)>& take, double first_high,
                     double second_high, const std::string& words, const std::string& text);

/// --wrong and --start-off: what else is wrong with a sketch.
void addMisdrawing(CLI::App& command, Misdrawing& misdrawing);

/// --seed.
CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& text);

/// --building-class, of networks.
void addBuildingClass(CLI::App& command, std::optional<int>& building_class);

/// --quiet.
void addQuiet(CLI::App& command, bool& quiet);

/// Of --allow-outside.
inline constexpr auto kAllowOutsideText =
    "Follow what a map names outside of its folder: only for maps you trust";

/// --from, --to and --every; `every_text` tells what each Nth is taken of.
void addFrames(CLI::App& command, ReplayOptions& replay, const std::string& every_text);

/// An option that takes one of some words. The help tells the default, which is the value now.
template <typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& value,
                       const std::vector<std::pair<std::string, Value>>& choices,
                       const std::string& text) {
  std::string words;
  std::string now;
  for (const auto& [word, meaning] : choices) {
    words += (words.empty() ? "" : "|") + word;
    if (meaning == value) now = word;
  }
  const auto choose = [=, &value](const std::string& word) {
    for (const auto& [known, meaning] : choices) {
      if (word == known) return void(value = meaning);
    }
    throw CLI::ValidationError(name, fmt::format("found {}, expected {}", word, words));
  };
  return command
      .add_option_function<std::string>(name, choose, fmt::format("{} (default {})", text, now))
      ->option_text(words);
}

/// Throws Usage, before any work is done, where an output could not be written: no folder there, no
/// permission, two to one place, over an input or over what lies in a folder of inputs; BadInput
/// where it is a file of a recording. Empty paths are fine.
void checkOutputFiles(const std::vector<std::string>& outputs,
                      const std::vector<std::string>& inputs,
                      NewOdometry odometry = NewOdometry::Refused);
/// The same for a folder that is to be filled: it must be new or empty.
void checkOutputFolder(const std::string& path);

}  // namespace handmap
