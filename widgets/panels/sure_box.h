// How sure somebody is of what he drew, in words.
#pragma once

#include <QComboBox>
#include <optional>

#include "core/map/map.h"

namespace handmap {

class SureBox : public QComboBox {
  Q_OBJECT
 public:
  explicit SureBox(QWidget* parent = nullptr);

  /// nullopt: several values at once. Not a choice.
  void showValue(std::optional<Uncertainty> value);

 Q_SIGNALS:
  void chosen(const handmap::Uncertainty& value);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace handmap
