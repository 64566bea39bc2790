// The values in a file that cv::FileStorage wrote: YAML, JSON or XML.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace handmap {

/// Not read by OpenCV, whose parsers read where nothing is in files that are damaged.
class OpenCvFile {
 public:
  /// `source` names the text in messages. Throws BadInput for what has no keys, and for more than
  /// 500 values.
  OpenCvFile(std::string_view content, const std::string& source);

  /// The words of the number, list or matrix under the first of `keys` that is there; nullptr where
  /// none is. What is none of these is a word that is no number.
  const std::vector<std::string>* find(std::initializer_list<const char*> keys) const;

 private:
  std::map<std::string, std::vector<std::string>> values_;
};

}  // namespace handmap
