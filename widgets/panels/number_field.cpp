#include "widgets/panels/number_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>
#include <cmath>
#include <utility>

namespace handmap {

namespace {
constexpr int kLeastWidth = 70;  // pixels of "-123.4 m" with its buttons; a panel may be narrow
}  // namespace

NumberField::NumberField(double low, double high, const QString& suffix, QWidget* parent)
    : QDoubleSpinBox(parent) {
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  setLocale(locale);
  setDecimals(3);
  setRange(low, high);
  setSuffix(suffix);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumWidth(kLeastWidth);
  connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    // Return announces the value in any case; a number only shown, and so rounded, is no edit.
    if (std::exchange(known_, value) != value && !showing_) Q_EMIT edited(value);
  });
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { typing_ = true; });
  connect(this, &QAbstractSpinBox::editingFinished, this, [this] { typing_ = false; });
}

void NumberField::showValue(std::optional<double> shown) {
  if (typing_) return;
  showing_ = true;
  const QString instead = shown ? QString() : tr("several");
  if (specialValueText() != instead) setSpecialValueText(instead);
  // Where values differ it is the least, so that any other number is a change.
  const double number = shown.value_or(minimum());
  if (std::abs(value() - number) >= 0.5 * std::pow(10.0, -decimals())) setValue(number);
  known_ = value();
  showing_ = false;
}

QString NumberField::textFromValue(double value) const {
  QString text = locale().toString(value, 'f', decimals());
  while (text.contains(u'.') && (text.endsWith(u'0') || text.endsWith(u'.'))) text.chop(1);
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

void NumberField::stepBy(int steps) {
  if (specialValueText().isEmpty() || typing_) QDoubleSpinBox::stepBy(steps);
}

/// No letter belongs to a number: it may be the key of a tool.
bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const QString text = static_cast<QKeyEvent*>(event)->text();
    if (!text.isEmpty() && text.front().isLetter()) {
      event->ignore();
      return false;
    }
  }
  return QDoubleSpinBox::event(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
  // Scrolling past the panel must not move buildings.
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

}  // namespace handmap
