// Names for screen readers.
#pragma once

class QWidget;

namespace handmap {

/// Whatever below `root` takes input and has no name gets one from what people see of it: its
/// tooltip or its placeholder.
void nameInputs(QWidget& root);

}  // namespace handmap
