#include "core/classification/labelled_folder.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/classification/variation.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> imagesIn(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> images;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") {
      images.push_back(entry.path());
    }
  }
  if (error) {
    throwBadInput(folder.string(), "", phrase("no folder that can be read"),
                  phrase("one with images"));
  }
  if (images.empty()) {
    throwBadInput(folder.string(), "", phrase("no images"), phrase("PNG or JPEG images"));
  }
  std::sort(images.begin(), images.end());
  return images;
}

std::string sizeOf(const cv::Mat& image) { return fmt::format("{} × {}", image.cols, image.rows); }

}  // namespace

void forEachLabelled(
    const LabelledFolder& folder,
    const std::function<void(const cv::Mat&, const std::vector<WindowLabel>&, double)>& use,
    const std::stop_token& stop) {
  const std::vector<fs::path> images = imagesIn(folder.images);
  for (std::size_t i = 0; i < images.size() && !stop.stop_requested(); ++i) {
    const fs::path labels = folder.labels / (images[i].stem().string() + ".png");
    if (!fileExists(labels)) {
      throwBadInput(labels.string(), "", phrase("no such file"),
                    phrase("the labels of {}", images[i].filename().string()));
    }
    const cv::Mat image = readImage(images[i]);
    const cv::Mat classes = readImage(labels);
    if (classes.channels() != 1) {
      throwBadInput(labels.string(), "", phrase("a colour image"),
                    phrase("a grey one: a class number a pixel"));
    }
    if (classes.size() != image.size()) {
      throwBadInput(labels.string(), "", phrase("{} pixels", sizeOf(classes)),
                    phrase("{} as its image", sizeOf(image)));
    }
    const std::vector<WindowLabel> known = windowLabels(classes, folder.building, folder.ignored);
    for (int k = 0; k <= folder.variations && !stop.stop_requested(); ++k) {
      RandomStream random(folder.seed, static_cast<std::uint32_t>(i),
                          static_cast<std::uint32_t>(k));
      use(k == 0 ? image : varied(image, random), known,
          (static_cast<double>(i) + (k + 1.0) / (folder.variations + 1.0)) /
              static_cast<double>(images.size()));
    }
  }
}

}  // namespace handmap
