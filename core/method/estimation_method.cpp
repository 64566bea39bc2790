#include "core/method/estimation_method.h"

#include "core/method/handmap_method.h"
#include "core/method/localization_method.h"
#include "core/method/paper_method.h"

namespace handmap {

std::unique_ptr<EstimationMethod> makeMethod(const Map& drawing, const SourceInfo& source,
                                             const RunSettings& settings) {
  if (settings.method == Method::Paper) return makePaperMethod(drawing, source, settings);
  if (!settings.slam.refine) return makeLocalizationMethod(drawing, source, settings);
  return makeHandmapMethod(drawing, source, settings);
}

}  // namespace handmap
