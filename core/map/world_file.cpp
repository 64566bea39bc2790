#include "core/map/world_file.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

WorldFile parseWorldFile(std::string_view text, const std::string& source) {
  std::array<double, 6> numbers{};
  ContentLines lines(text);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto line = lines.next();
    const auto number = line ? parseFinite(line->text) : std::nullopt;
    if (!number) {
      throwBadInput(
          source, line ? phrase("line {}", line->number) : std::string(),
          line ? fmt::format("\"{}\"", line->text.substr(0, 40)) : phrase("{} numbers", i),
          phrase("six numbers, one a line"));
    }
    numbers[i] = *number;
  }
  WorldFile file;
  file.per_pixel << numbers[0], numbers[2], numbers[1], numbers[3];
  file.first = {numbers[4], numbers[5]};
  if (!(std::abs(cross(file.per_pixel.col(0), file.per_pixel.col(1))) > 0.0)) {
    throwBadInput(source, {}, phrase("pixels without size"),
                  phrase("the size of a pixel right and down"));
  }
  return file;
}

}  // namespace handmap
