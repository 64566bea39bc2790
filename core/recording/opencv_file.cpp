#include "core/recording/opencv_file.h"

#include <pugixml.hpp>
#include <yaml-cpp/yaml.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

using Words = std::vector<std::string>;
using Values = std::map<std::string, Words>;

constexpr std::size_t kMaxNodes = 500;

/// An upper bound of how many values there are, and of how deep they nest.
std::size_t nodesOf(std::string_view text) {
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool item = c == '-' && i + 1 < text.size() && std::isspace(std::uint8_t(text[i + 1]));
    nodes += c == '[' || c == '{' || c == '<' || item ? 1 : 0;
  }
  return nodes;
}

Words wordsOf(const YAML::Node& node) {
  if (node.IsMap() && node["data"] && !node["data"].IsMap()) return wordsOf(node["data"]);
  if (!node.IsSequence()) return {node.IsScalar() ? node.Scalar() : ""};
  Words words;
  for (const YAML::Node& item : node) words.push_back(item.IsScalar() ? item.Scalar() : "");
  return words;
}

/// JSON is YAML, too.
Values yamlValues(std::string_view content) {
  Values values;
  const YAML::Node root = YAML::Load(std::string(content));
  if (!root.IsMap()) return values;
  for (const auto& member : root) {
    if (member.first.IsScalar()) values[member.first.Scalar()] = wordsOf(member.second);
  }
  return values;
}

Values xmlValues(std::string_view content) {
  Values values;
  pugi::xml_document document;
  if (!document.load_buffer(content.data(), content.size())) return values;
  for (const pugi::xml_node node : document.child("opencv_storage").children()) {
    const pugi::xml_node data = node.child("data");
    const std::string text = (data ? data : node).text().get();
    const auto words = splitWords(text);
    values[node.name()] = Words(words.begin(), words.end());
  }
  return values;
}

}  // namespace

OpenCvFile::OpenCvFile(std::string_view content, const std::string& source) {
  const std::string expected = phrase("a YAML or XML file of OpenCV with M1 D1 M2 D2 R T");
  const std::string_view text = trimmed(content);
  if (text.empty()) throwBadInput(source, "", phrase("an empty file"), expected);
  if (nodesOf(text) > kMaxNodes) throwBadInput(source, "", phrase("too many values"), expected);
  try {
    values_ = text.starts_with('<') ? xmlValues(text) : yamlValues(text);
  } catch (const YAML::Exception&) {
    values_.clear();
  }
  if (values_.empty()) throwBadInput(source, "", phrase("no calibration of OpenCV"), expected);
}

const Words* OpenCvFile::find(std::initializer_list<const char*> keys) const {
  for (const char* key : keys) {
    const auto value = values_.find(key);
    if (value != values_.end()) return &value->second;
  }
  return nullptr;
}

}  // namespace handmap
