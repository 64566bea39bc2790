#include "tests/monkey/steps.h"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

namespace handmap {

namespace {

constexpr int kFewest = 5;
constexpr int kMost = 25;

struct Kind {
  const char* name;
  double weight;
};

constexpr std::array<Kind, static_cast<std::size_t>(StepKind::Count)> kKinds = {{{"action", 12.0},
                                                                                 {"simulate", 3.0},
                                                                                 {"stroke", 4.0},
                                                                                 {"key", 2.0},
                                                                                 {"button", 5.0},
                                                                                 {"drop", 1.5},
                                                                                 {"undo", 1.5},
                                                                                 {"redo", 1.0},
                                                                                 {"speed", 0.5},
                                                                                 {"seek", 2.0},
                                                                                 {"wait", 6.0},
                                                                                 {"settle", 1.0},
                                                                                 {"sleep", 2.0},
                                                                                 {"close", 0.5}}};

}  // namespace

Steps stepsOf(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<double> weights;
  for (const Kind& kind : kKinds) weights.push_back(kind.weight);
  std::discrete_distribution<int> kinds(weights.begin(), weights.end());
  Steps steps(static_cast<std::size_t>(std::uniform_int_distribution(kFewest, kMost)(random)));
  std::uniform_int_distribution<std::uint32_t> values(0, 99'999);
  for (Step& step : steps) step = {static_cast<StepKind>(kinds(random)), values(random)};
  return steps;
}

QString inWords(const Steps& steps) {
  QStringList words;
  for (const Step& step : steps) {
    words << QStringLiteral("%1:%2")
                 .arg(QLatin1String(kKinds.at(static_cast<std::size_t>(step.kind)).name))
                 .arg(step.value);
  }
  return words.join(u' ');
}

Steps parsedSteps(const QString& text) {
  Steps steps;
  for (const QString& word : text.simplified().split(u' ', Qt::SkipEmptyParts)) {
    const QStringList parts = word.split(u':');
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& one) {
      return parts.front() == QLatin1String(one.name);
    });
    bool ok = parts.size() == 2 && kind != kKinds.end();
    const std::uint32_t value = ok ? parts.back().toUInt(&ok) : 0;
    if (!ok) throw std::invalid_argument("no step: " + word.toStdString());
    steps.push_back({static_cast<StepKind>(kind - kKinds.begin()), value});
  }
  return steps;
}

}  // namespace handmap
