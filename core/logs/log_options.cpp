#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "core/logs/log.h"

namespace handmap {

void setColumns(std::string_view text, LogOptions& options) {
  options.columns.clear();
  for (const std::string_view field : splitFields(text, ',')) {
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw Error(ErrorCode::Usage,
                  phrase("--columns: found \"{}\", expected ROLE=COLUMN,…", field));
    }
    options.columns[std::string(field.substr(0, equals))] = std::string(field.substr(equals + 1));
  }
}

void setAngles(std::string_view text, LogOptions& options) {
  const auto fields = splitFields(text, ':');
  const auto first = parseFinite(fields[0]);
  const double step = fields.size() == 2 ? parseFinite(fields[1]).value_or(0.0) : 0.0;
  if (!first || step == 0.0) {
    throw Error(ErrorCode::Usage,
                phrase("--angles: found \"{}\", expected FIRST:STEP in degrees", text));
  }
  options.angles = RayAngles{toRadians(*first), toRadians(step)};
}

}  // namespace handmap
