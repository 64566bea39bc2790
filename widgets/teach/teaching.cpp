#include "widgets/teach/teaching.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/base/json.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::size_t kMaxImages = 10'000;
constexpr std::size_t kMaxPathBytes = 4096;
constexpr std::size_t kMaxWindows = 1u << 18;  // of an image of 64 megapixels
constexpr std::size_t kMaxLabelBytes = 2 * kMaxWindows;

constexpr std::array kLetters = {std::pair(WindowLabel::Unknown, '-'),
                                 std::pair(WindowLabel::Other, 'o'),
                                 std::pair(WindowLabel::Building, 'b')};

/// Runs of equal labels: "120-3b40o".
std::string formatLabels(const std::vector<WindowLabel>& labels) {
  std::string text;
  for (auto run = labels.begin(); run != labels.end();) {
    const auto end = std::find_if(run, labels.end(), [&](auto label) { return label != *run; });
    const auto letter = std::ranges::find(kLetters, *run, &std::pair<WindowLabel, char>::first);
    text += fmt::format("{}{}", end - run, letter->second);
    run = end;
  }
  return text;
}

std::vector<WindowLabel> readLabels(const JsonValue& json) {
  const std::string text = json.text(kMaxLabelBytes);
  std::vector<WindowLabel> labels;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t at = std::min(text.find_first_of("-ob", begin), text.size());
    const auto count = parseInteger(std::string_view(text).substr(begin, at - begin));
    if (at == text.size() || !count || *count < 1 ||
        static_cast<std::size_t>(*count) > kMaxWindows - labels.size()) {
      json.fail(QObject::tr("runs of windows such as %1")
                    .arg(QLatin1String("\"120-3b40o\""))
                    .toStdString());
    }
    const auto label = std::ranges::find(kLetters, text[at], &std::pair<WindowLabel, char>::second);
    labels.insert(labels.end(), static_cast<std::size_t>(*count), label->first);
    begin = at + 1;
  }
  return labels;
}

}  // namespace

std::string formatTeaching(const Teaching& teaching) {
  std::vector<std::string> images;
  images.reserve(teaching.images.size());
  for (const Teaching::Image& image : teaching.images) {
    images.push_back(fmt::format(R"({{"path": {}, "labels": {}}})",
                                 quotedJson(image.path.toStdString()),
                                 quotedJson(formatLabels(image.labels))));
  }
  return fmt::format("[{}]", fmt::join(images, ",\n  "));
}

Teaching readTeaching(const JsonValue& images) {
  Teaching teaching;
  for (const JsonValue& item : images.items(kMaxImages)) {
    teaching.images.push_back({QString::fromStdString(item.at("path").text(kMaxPathBytes)),
                               readLabels(item.at("labels"))});
  }
  return teaching;
}

}  // namespace handmap
