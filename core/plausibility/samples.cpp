#include "core/plausibility/samples.h"

#include "core/base/error.h"
#include "core/recording/view_reader.h"

namespace handmap {

std::vector<std::size_t> rowsWithPoints(const Recording& recording) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < recording.rows.size(); ++i) {
    if (!recording.rows[i].points.empty()) rows.push_back(i);
  }
  return rows;
}

std::vector<PointsSample> samplesOf(const Recording& recording, std::size_t most,
                                    const std::stop_token& stop) {
  std::vector<PointsSample> samples;
  const ViewReader reader(recording);
  const std::vector<std::size_t> rows = rowsWithPoints(recording);
  const std::size_t step = rows.size() / most + 1;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    throwIfStopped(stop);
    View view;
    try {
      reader.readPoints(recording.rows[rows[i]], view);
    } catch (const Error&) {
      continue;  // the run tells it
    }
    samples.push_back({rows[i], std::move(*view.points)});
  }
  return samples;
}

}  // namespace handmap
