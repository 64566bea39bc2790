#include "core/calibration/board_images.h"

#include <map>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

std::map<std::string, fs::path> imagesOf(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throwBadInput(folder.string(), "", phrase("no such folder"), phrase("a folder of images"));
  }
  std::map<std::string, fs::path> images;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".png" && ending != ".jpg" && ending != ".jpeg") continue;
    images[entry.path().stem().string()] = entry.path();
  }
  if (images.empty()) {
    throwBadInput(folder.string(), "", phrase("no images"), phrase("PNG or JPEG images"));
  }
  return images;
}

class Finder {
 public:
  explicit Finder(const Board& board) : board_(board) {}

  void add(const std::string& name, const fs::path& left, const fs::path& right) {
    try {
      const cv::Mat left_image = readImage(left);
      const cv::Mat right_image = readImage(right);
      requireSize(left_image, left);
      requireSize(right_image, right);
      found.views.push_back(
          {name, cornersOf(left_image, phrase("left")), cornersOf(right_image, phrase("right"))});
      alignOrder(found.views.back());
    } catch (const OtherSize& other) {
      throw Error(ErrorCode::BadInput, other.what());
    } catch (const Error& error) {
      found.refused.push_back({name, error.what()});
    }
  }

  BoardImages found;

 private:
  struct OtherSize : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  void requireSize(const cv::Mat& image, const fs::path& path) {
    if (found.size.empty()) found.size = image.size();
    if (image.size() == found.size) return;
    throw OtherSize(phrase("{}: found {} × {} pixels, expected {} × {} as the images before",
                           path.string(), image.cols, image.rows, found.size.width,
                           found.size.height));
  }

  std::vector<cv::Point2f> cornersOf(const cv::Mat& image, const std::string& side) const {
    std::vector<cv::Point2f> corners = findCorners(image, board_);
    if (!corners.empty()) return corners;
    throw Error(ErrorCode::BadInput, phrase("no whole board of {} × {} corners in the {} image",
                                            board_.corners.width, board_.corners.height, side));
  }

  Board board_;
};

}  // namespace

BoardImages findBoards(const fs::path& left, const fs::path& right, const Board& board,
                       const std::function<bool(int, int)>& tell) {
  const auto left_images = imagesOf(left);
  auto right_images = imagesOf(right);
  Finder finder(board);
  const int all = static_cast<int>(left_images.size());
  int done = 0;
  int pairs = 0;
  for (const auto& [name, path] : left_images) {
    if (tell && !tell(done++, all)) break;
    const auto partner = right_images.extract(name);
    if (partner.empty()) {
      finder.found.refused.push_back({name, phrase("no image of that name in the right folder")});
      continue;
    }
    ++pairs;
    finder.add(name, path, partner.mapped());
  }
  for (const auto& [name, path] : right_images) {
    finder.found.refused.push_back({name, phrase("no image of that name in the left folder")});
  }
  if (pairs == 0) {
    throwBadInput(left.string(), "",
                  phrase("no image of the same name as one in {}", right.string()),
                  phrase("both images of a pair with one name"));
  }
  return std::move(finder.found);
}

}  // namespace handmap
