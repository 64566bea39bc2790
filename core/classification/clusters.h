// Vectors that stand for many.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/classification/sample_matrix.h"

namespace handmap {

/// The centres that k-means finds in each class by itself, at most `count` in all, half of them in
/// either class; fewer where a class has fewer samples. Deterministic by seed.
SampleMatrix clusterCentres(const SampleMatrix& samples, const std::vector<bool>& positive,
                            int count, std::uint64_t seed, const std::stop_token& stop);

}  // namespace handmap
