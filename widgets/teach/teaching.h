// What somebody has painted in Teach buildings, as it is kept for another session.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/classification/window_labels.h"

namespace handmap {

class JsonValue;

struct Teaching {
  struct Image {
    QString path;
    std::vector<WindowLabel> labels;  ///< one a whole window; empty: nothing is painted
    bool operator==(const Image&) const = default;
  };
  std::vector<Image> images;

  bool isEmpty() const { return images.empty(); }
  bool operator==(const Teaching&) const = default;
};

/// A JSON array with an object for each image.
std::string formatTeaching(const Teaching& teaching);
/// Throws Error (BadInput).
Teaching readTeaching(const JsonValue& images);

}  // namespace handmap
