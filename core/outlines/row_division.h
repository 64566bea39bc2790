// Where houses that stand wall to wall end, as what is drawn and what was seen of their fronts tell
// it together: a hidden semi-Markov model along the row, solved exactly.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

namespace handmap {

/// A drawn house that may be of the row. Places along the row, metres; nats.
struct RowHouse {
  double centre = 0.0;
  double centre_sigma = 1.0;
  double width = 0.0;
  double log_width_sigma = 0.3;
  double least_width = 0.0;
  double most_width = 0.0;
  double nats = 0.0;             ///< that it is of the row at all, beside what is said above
  double worth_elsewhere = 0.0;  ///< where it is not of the row, against not being there at all
};

/// A part of the row.
struct RowPart {
  std::size_t house;  ///< index, or kUndrawn: one thing or more
  double from, to;
  double from_sigma, to_sigma;  ///< of an end of the row: 0
  double probability;           ///< that its middle is of that house
};

/// What was seen of a stretch from..to says for its being one thing; nats.
using StretchEvidence = std::function<double(double from, double to)>;

/// The row from `from` to `to` divided among some of the houses, in their order, and what is not
/// drawn; all may be drawn off together. All divisions are counted, each as probable as it is: the
/// one with most of the row right is told, where its parts end by the mean. Empty where no division
/// is possible or `stop` was requested.
std::vector<RowPart> divideRow(const std::vector<RowHouse>& houses, double from, double to,
                               const StretchEvidence& evidence, const std::stop_token& stop = {});

}  // namespace handmap
