#include "core/classification/window_labels.h"

#include <algorithm>
#include <array>

#include "core/classification/windows.h"

namespace handmap {

std::vector<WindowLabel> windowLabels(const cv::Mat1b& classes, int building,
                                      std::optional<int> ignored) {
  const WindowGrid grid = WindowGrid::of(classes.size());
  std::vector<WindowLabel> labels;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      std::array<int, 256> counts{};
      for (int y = row * kWindow_px; y < (row + 1) * kWindow_px; ++y) {
        const std::uint8_t* line = classes[y] + static_cast<std::ptrdiff_t>(column) * kWindow_px;
        for (int x = 0; x < kWindow_px; ++x) ++counts[line[x]];
      }
      const auto most = std::max_element(counts.begin(), counts.end()) - counts.begin();
      if (most == ignored) {
        labels.push_back(WindowLabel::Unknown);
      } else {
        labels.push_back(most == building ? WindowLabel::Building : WindowLabel::Other);
      }
    }
  }
  return labels;
}

}  // namespace handmap
