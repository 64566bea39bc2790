// What of Qt threads with an event loop need.
#pragma once

#include <QCoreApplication>
#include <memory>

namespace handmap {

/// One at a time. Files keep their decimal points whatever the locale of the person.
std::unique_ptr<QCoreApplication> qtCore();

}  // namespace handmap
