// Arrays as numpy saves them: .npy, and .npz (a zip of them, deflated or not).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace handmap {

struct Array {
  std::vector<std::size_t> shape;  ///< none: one value
  std::vector<double> values;      ///< the last index the fastest

  std::size_t rows() const { return shape.empty() ? 1 : shape.front(); }
};

/// Real and whole numbers and truth values, either order of bytes and of indices; at most 64
/// million values. `source` names the content. Throws BadInput, for Python objects too.
Array parseNpy(std::string_view content, const std::string& source);

/// By name, without ".npy". At most 512 MB when inflated. Throws BadInput.
std::map<std::string, Array> parseNpz(std::string_view content, const std::string& source);

}  // namespace handmap
