// phrase() for those who speak with Qt.
#pragma once

#include <QIODevice>
#include <QString>
#include <utility>

#include "core/base/phrase.h"

namespace handmap {

template <class... Arguments>
QString qPhrase(fmt::format_string<Arguments...> english, Arguments&&... arguments) {
  return QString::fromStdString(phrase(english, std::forward<Arguments>(arguments)...));
}

/// What Qt says of an error; where it has no word for it, that the connection was closed.
inline QString qReason(const QString& said) {
  const bool is_none = said.isEmpty() || said == QIODevice::tr("Unknown error") ||
                       said == QLatin1String("Unknown error");
  return is_none ? qPhrase("the other side closed the connection") : said;
}

}  // namespace handmap
