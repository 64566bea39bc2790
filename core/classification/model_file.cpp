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
constexpr int kVersionWithTrees = 3;
constexpr std::uintmax_t kMaxBytes = 16U << 20;
constexpr double kMaxMagnitude = 1e9;
constexpr std::size_t kMaxVectors = 4096;
constexpr std::size_t kMaxNodes = 1U << 16;
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
  for (const FeatureFamily known :
       {FeatureFamily::Paper, FeatureFamily::Handmap, FeatureFamily::Equalized}) {
    if (name == nameOf(known)) set.family = known;
  }
  if (name != nameOf(set.family)) {
    family.fail(phrase("{} or {}", "\"handmap\", \"equalized\"", "\"paper\""));
  }
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

/// Three numbers a node.
DecisionTree readTree(const JsonValue& json, Eigen::Index features) {
  const std::vector<JsonValue> numbers = json.items(3 * kMaxNodes);
  if (numbers.empty() || numbers.size() % 3 != 0) {
    json.fail(phrase("{} numbers", numbers.size()), phrase("three a node"));
  }
  const auto nodes = static_cast<std::int64_t>(numbers.size() / 3);
  DecisionTree tree;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    TreeNode node;
    node.feature = static_cast<int>(numbers[i].integer(TreeNode::kLeaf, features - 1));
    node.value = static_cast<float>(numbers[i + 1].number(-kMaxMagnitude, kMaxMagnitude));
    // Always onwards, so that every way through the tree ends.
    const auto next = static_cast<std::int64_t>(i / 3 + 1);
    const bool leaf = node.feature == TreeNode::kLeaf;
    node.right = static_cast<int>(numbers[i + 2].integer(leaf ? 0 : next + 1, nodes - 1));
    tree.push_back(node);
  }
  return tree;
}

RandomTrees readTrees(const JsonValue& json, Eigen::Index features) {
  const std::vector<JsonValue> items = json.items(kMaxVectors);
  if (items.empty()) json.fail(phrase("at least one tree"));
  std::vector<DecisionTree> trees;
  for (const JsonValue& item : items) trees.push_back(readTree(item, features));
  return RandomTrees(std::move(trees));
}

/// Trees have neither gamma nor c.
TrainingRecord readRecord(const JsonValue& json, bool of_trees) {
  const auto windows = [&](const char* key) {
    return static_cast<int>(json.at(key).integer(0, kMaxWindows));
  };
  TrainingRecord record;
  record.seed = static_cast<std::uint64_t>(json.at("seed").integer(0, INT64_MAX));
  if (!of_trees) {
    record.gamma = json.at("gamma").positive(1e6);
    record.c = json.at("c").positive(1e6);
  }
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

std::string separatorJson(const KernelSvm& svm) {
  std::vector<std::string> vectors;
  for (Eigen::Index i = 0; i < svm.vectors().rows(); ++i) {
    const Eigen::RowVectorXf row = svm.vectors().row(i);
    vectors.push_back(numbers(row));
  }
  return fmt::format("\"gamma\":{},\"bias\":{},\"weights\":{},\n\"vectors\":[\n{}]", svm.gamma(),
                     svm.bias(), numbers(svm.weights()), fmt::join(vectors, ",\n"));
}

std::string separatorJson(const RandomTrees& trees) {
  std::vector<std::string> lines;
  for (const DecisionTree& tree : trees.trees()) {
    std::vector<std::string> nodes;
    for (const TreeNode& node : tree) {
      nodes.push_back(fmt::format("{},{},{}", node.feature, node.value, node.right));
    }
    lines.push_back(fmt::format("[{}]", fmt::join(nodes, ",")));
  }
  return fmt::format("\"trees\":[\n{}]", fmt::join(lines, ",\n"));
}

}  // namespace

BuildingClassifier BuildingClassifier::parse(std::string_view text, const std::string& source) {
  const nlohmann::json parsed = parseJson(text, source);
  const JsonValue json = JsonValue(parsed, source).object();
  if (json.at("format").text(100) != kFormat) json.at("format").fail(quotedJson(kFormat));
  const std::int64_t version = json.at("version").integer(0, INT32_MAX);
  if (version != kVersion && version != kVersionWithTrees) {
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
  Separator separator = version == kVersion ? Separator(readSvm(json, features))
                                            : Separator(readTrees(json.at("trees"), features));
  return {set, std::move(standardization), std::move(separator), logistic,
          readRecord(json.at("training"), version == kVersionWithTrees)};
}

BuildingClassifier BuildingClassifier::load(const std::filesystem::path& path) {
  return parse(readFile(path, kMaxBytes), path.string());
}

std::string BuildingClassifier::toJson() const {
  const bool trees = std::holds_alternative<RandomTrees>(separator_);
  return fmt::format(
      "{{\"format\":\"{}\",\"version\":{},\"window\":{},\"features\":\"{}\",\"colour\":{},\n"
      "\"training\":{},\n\"probability\":{{\"slope\":{},\"offset\":{}}},\n\"mean\":{},\n"
      "\"scale\":{},\n{}}}\n",
      kFormat, trees ? kVersionWithTrees : kVersion, kWindow_px, nameOf(features_.family),
      features_.colour, recordJson(record_), logistic_.slope, logistic_.offset,
      numbers(standardization_.mean), numbers(standardization_.scale),
      std::visit([](const auto& separator) { return separatorJson(separator); }, separator_));
}

void BuildingClassifier::save(const std::filesystem::path& path) const {
  writeFileAtomically(path, toJson());
}

}  // namespace handmap
