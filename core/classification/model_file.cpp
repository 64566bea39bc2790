// The file of a building classifier: JSON, numbers as short as they read back the same.
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/classification/building_classifier.h"

namespace handmap {

namespace {

constexpr std::string_view kFormat = "handmap-building-classifier";
constexpr int kVersion = 2;
constexpr std::uintmax_t kMaxBytes = 16U << 20;
constexpr double kMaxMagnitude = 1e9;
constexpr std::size_t kMaxVectors = 4096;
constexpr std::int64_t kMaxWindows = 1'000'000'000;

template <typename Numbers>
std::string numbers(const Numbers& values) {
  return fmt::format("[{}]", fmt::join(values.begin(), values.end(), ","));
}

/// An array of `count` numbers into `to`.
void read(const JsonValue& array, Eigen::Index count, float* to) {
  const std::vector<JsonValue> items = array.items(kMaxVectors);
  if (static_cast<Eigen::Index>(items.size()) != count) {
    array.fail(phrase("{} numbers", items.size()), fmt::format("{}", count));
  }
  for (const JsonValue& item : items) {
    *to++ = static_cast<float>(item.number(-kMaxMagnitude, kMaxMagnitude));
  }
}

FeatureSet readFeatures(const JsonValue& json) {
  FeatureSet set;
  const JsonValue family = json.at("features");
  const std::string name = family.text(20);
  if (name != "handmap" && name != "paper") {
    family.fail(phrase("{} or {}", "\"handmap\"", "\"paper\""));
  }
  set.family = name == "paper" ? FeatureFamily::Paper : FeatureFamily::Handmap;
  set.colour = json.at("colour").flag();
  return set;
}

KernelSvm readSvm(const JsonValue& json, Eigen::Index features) {
  const std::vector<JsonValue> rows = json.at("vectors").items(kMaxVectors);
  if (rows.empty()) json.at("vectors").fail(phrase("at least one vector"));
  SampleMatrix vectors(static_cast<Eigen::Index>(rows.size()), features);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    read(rows[i], features, vectors.row(static_cast<Eigen::Index>(i)).data());
  }
  Eigen::VectorXf weights(vectors.rows());
  read(json.at("weights"), weights.size(), weights.data());
  return {std::move(vectors), std::move(weights),
          static_cast<float>(json.at("bias").number(-kMaxMagnitude, kMaxMagnitude)),
          static_cast<float>(json.at("gamma").positive(1e6))};
}

TrainingRecord readRecord(const JsonValue& json) {
  const auto windows = [&](const char* key) {
    return static_cast<int>(json.at(key).integer(0, kMaxWindows));
  };
  TrainingRecord record;
  record.seed = static_cast<std::uint64_t>(json.at("seed").integer(0, INT64_MAX));
  record.gamma = json.at("gamma").positive(1e6);
  record.c = json.at("c").positive(1e6);
  record.cross_validated = {windows("building_as_building"), windows("building_as_other"),
                            windows("other_as_building"), windows("other_as_other")};
  return record;
}

std::string recordJson(const TrainingRecord& record) {
  const Confusion& c = record.cross_validated;
  return fmt::format(
      "{{\"seed\":{},\"gamma\":{},\"c\":{},\"building_as_building\":{},"
      "\"building_as_other\":{},\"other_as_building\":{},\"other_as_other\":{}}}",
      record.seed, record.gamma, record.c, c.building_as_building, c.building_as_other,
      c.other_as_building, c.other_as_other);
}

}  // namespace

BuildingClassifier BuildingClassifier::parse(std::string_view text, const std::string& source) {
  const nlohmann::json parsed = parseJson(text, source);
  const JsonValue json = JsonValue(parsed, source).object();
  if (json.at("format").text(100) != kFormat) json.at("format").fail(quotedJson(kFormat));
  if (json.at("version").integer(0, INT32_MAX) != kVersion) {
    json.at("version").fail(phrase("{}; train the model again", kVersion));
  }
  if (json.at("window").integer(0, INT32_MAX) != kWindow_px) {
    json.at("window").fail(fmt::format("{}", kWindow_px));
  }
  const FeatureSet set = readFeatures(json);
  const Eigen::Index features = featureCount(set);
  Standardization standardization{Eigen::RowVectorXf(features), Eigen::RowVectorXf(features)};
  read(json.at("mean"), features, standardization.mean.data());
  read(json.at("scale"), features, standardization.scale.data());
  const JsonValue probability = json.at("probability");
  const Logistic logistic{probability.at("slope").number(-kMaxMagnitude, kMaxMagnitude),
                          probability.at("offset").number(-kMaxMagnitude, kMaxMagnitude)};
  return {set, std::move(standardization), readSvm(json, features), logistic,
          readRecord(json.at("training"))};
}

BuildingClassifier BuildingClassifier::load(const std::filesystem::path& path) {
  return parse(readFile(path, kMaxBytes), path.string());
}

std::string BuildingClassifier::toJson() const {
  std::vector<std::string> vectors;
  for (Eigen::Index i = 0; i < svm_.vectors().rows(); ++i) {
    const Eigen::RowVectorXf row = svm_.vectors().row(i);
    vectors.push_back(numbers(row));
  }
  return fmt::format(
      "{{\"format\":\"{}\",\"version\":{},\"window\":{},\"features\":\"{}\",\"colour\":{},\n"
      "\"training\":{},\n\"probability\":{{\"slope\":{},\"offset\":{}}},\n\"mean\":{},\n"
      "\"scale\":{},\n\"gamma\":{},\"bias\":{},\"weights\":{},\n\"vectors\":[\n{}]}}\n",
      kFormat, kVersion, kWindow_px, features_.family == FeatureFamily::Paper ? "paper" : "handmap",
      features_.colour, recordJson(record_), logistic_.slope, logistic_.offset,
      numbers(standardization_.mean), numbers(standardization_.scale), svm_.gamma(), svm_.bias(),
      numbers(svm_.weights()), fmt::join(vectors, ",\n"));
}

void BuildingClassifier::save(const std::filesystem::path& path) const {
  writeFileAtomically(path, toJson());
}

}  // namespace handmap
