#include "widgets/panels/sure_box.h"

#include <QWheelEvent>
#include <algorithm>
#include <array>

namespace handmap {

namespace {

/// From a plan; as people draw a place they know well (what a new drawing has); from hearsay.
constexpr std::array kLevels = {Uncertainty{0.5, 0.5}, Uncertainty{3.0, 3.0},
                                Uncertainty{8.0, 5.0}};

}  // namespace

SureBox::SureBox(QWidget* parent) : QComboBox(parent) {
  addItems({tr("sure"), tr("roughly"), tr("a guess"), tr("in numbers")});
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QComboBox::activated, this, [this](int index) {
    const auto level = static_cast<std::size_t>(index);
    if (level < kLevels.size()) Q_EMIT chosen(kLevels[level]);
  });
}

void SureBox::showValue(std::optional<Uncertainty> value) {
  const auto level = value ? std::ranges::find(kLevels, *value) : kLevels.end();
  setCurrentIndex(value ? static_cast<int>(level - kLevels.begin()) : -1);
}

void SureBox::wheelEvent(QWheelEvent* event) {
  // Scrolling past the panel must not change the drawing.
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

}  // namespace handmap
