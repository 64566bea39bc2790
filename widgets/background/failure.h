// What went wrong in a thread of its own, as it is told to the person.
#pragma once

#include <QMetaType>
#include <QString>

#include "core/base/error.h"

namespace handmap {

struct Failure {
  ErrorCode code = ErrorCode::RunFailed;
  QString message;
  QString hint;
};

Failure failureOf(const Error& error);

}  // namespace handmap
