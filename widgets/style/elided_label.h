// A line of text; what does not fit ends in an ellipsis.
#pragma once

#include <QLabel>

namespace handmap {

class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  using QLabel::QLabel;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace handmap
