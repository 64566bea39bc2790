// A spin box for one exact number.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace handmap {

/// Shows up to three decimals, none that are nothing; speaks C whatever the locale. Tells only of
/// what the user enters, and is not written over while he types.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  NumberField(double low, double high, const QString& suffix, QWidget* parent = nullptr);

  /// nullopt: several values at once. Not an edit.
  void showValue(std::optional<double> value);
  void forgetTyping() { typing_ = false; }

  QString textFromValue(double value) const override;
  void stepBy(int steps) override;
  bool event(QEvent* event) override;

 Q_SIGNALS:
  void edited(double value);

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  double known_ = 0.0;  ///< the value last shown or told
  bool showing_ = false;
  bool typing_ = false;
};

}  // namespace handmap
