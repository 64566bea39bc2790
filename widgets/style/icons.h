// Our own icons, tinted from the palette whenever they are drawn, so that they follow a change
// between light and dark.
#pragma once

#include <QIcon>

namespace handmap {

/// `name` is that of a file in resources/icons, without ".svg"; a null icon when there is none.
QIcon icon(const QString& name);

}  // namespace handmap
