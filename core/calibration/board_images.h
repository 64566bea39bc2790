// Images of a checkerboard that both cameras of a stereo camera see.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/calibration/board.h"

namespace handmap {

struct RefusedPair {
  std::string name;
  std::string reason;
};

struct BoardImages {
  cv::Size size;  ///< of all images
  std::vector<BoardView> views;
  std::vector<RefusedPair> refused;
};

/// Reads the PNG and JPEG images of two folders; the images of a pair have the same name. Pairs
/// that cannot be read or do not show the whole board in both images are refused. Throws BadInput
/// for folders without a pair and for images of different sizes. `tell` hears of each pair: done,
/// all. Returning false there ends the search early.
BoardImages findBoards(const std::filesystem::path& left, const std::filesystem::path& right,
                       const Board& board, const std::function<bool(int done, int all)>& tell = {});

}  // namespace handmap
