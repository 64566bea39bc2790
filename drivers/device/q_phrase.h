// phrase() for those who speak with Qt.
#pragma once

#include <QString>
#include <utility>

#include "core/base/phrase.h"

namespace handmap {

template <class... Arguments>
QString qPhrase(fmt::format_string<Arguments...> english, Arguments&&... arguments) {
  return QString::fromStdString(phrase(english, std::forward<Arguments>(arguments)...));
}

}  // namespace handmap
