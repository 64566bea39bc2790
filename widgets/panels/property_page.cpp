#include "widgets/panels/property_page.h"

#include <QCheckBox>
#include <QLabel>

namespace handmap {

namespace {

constexpr int kMaxNameLength = 1000;  // UTF-16 units; a map file takes 4096 bytes

}  // namespace

PropertyPage::PropertyPage(MapDocument& document, const QString& title)
    : document_(document), form_(new QFormLayout(this)) {
  auto* heading = new QLabel(QStringLiteral("<b>%1</b>").arg(title));
  heading->setObjectName(QStringLiteral("title"));
  form_->addRow(heading);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void PropertyPage::addField(const char* name, const QString& label, QWidget* field) {
  field->setObjectName(QLatin1String(name));
  if (field->accessibleName().isEmpty()) field->setAccessibleName(label);
  if (auto* box = qobject_cast<QCheckBox*>(field)) {  // whose words do not break
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    if (box->toolTip().isEmpty()) box->setToolTip(box->text());
  }
  if (label.isEmpty())
    form_->addRow(field);
  else
    form_->addRow(label, field);
}

QLineEdit* PropertyPage::addLine(const char* name, const QString& label) {
  auto* field = new QLineEdit;
  field->setMaxLength(kMaxNameLength);
  addField(name, label, field);
  connect(field, &QLineEdit::editingFinished, this, &PropertyPage::finish);
  return field;
}

void PropertyPage::addId() {
  id_ = addLine("id", tr("Id"));
  connect(id_, &QLineEdit::editingFinished, this, [this] {
    const QString wanted = id_->text();
    if (shown_id_.isEmpty() || wanted == shown_id_) return;
    if (!document_.rename(shown_id_, wanted))
      Q_EMIT messageRaised(
          tr("“%1” cannot be the id of %2: ids are not empty and unique").arg(wanted, shown_id_));
    id_->setModified(false);
    showId();
  });
}

void PropertyPage::showId() {
  const QStringList keys = document_.selection();
  const QString id = keys.size() == 1 ? keys.first() : QString();
  if (id == shown_id_ && id_->isModified()) return;
  shown_id_ = id;
  id_->setText(id);
  id_->setEnabled(!id.isEmpty());
}

void PropertyPage::forgetTyping() {
  for (NumberField* field : findChildren<NumberField*>()) field->forgetTyping();
}

void PropertyPage::showField(QWidget& field, bool shown) {
  field.setVisible(shown);
  if (QWidget* label = form_->labelForField(&field)) label->setVisible(shown);
}

void PropertyPage::showText(QLineEdit& field, const QString& text) {
  if (field.text() == text) return;
  field.setText(text);
  if (!field.hasFocus()) field.setCursorPosition(0);  // a long one is read from its beginning
}

void PropertyPage::finish() {
  document_.finishMerging();
  if (isVisible()) refresh();
}

}  // namespace handmap
