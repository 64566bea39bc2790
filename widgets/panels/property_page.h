// One page of the property panel, for one kind of selection.
#pragma once

#include <QFormLayout>
#include <QLineEdit>
#include <QWidget>

#include "widgets/document/map_document.h"
#include "widgets/panels/number_field.h"

namespace handmap {

inline constexpr double kPercent = 100.0;  ///< what pages show of shares

class PropertyPage : public QWidget {
  Q_OBJECT
 public:
  PropertyPage(MapDocument& document, const QString& title);

  /// Shows the document as it is now.
  virtual void refresh() = 0;
  /// Other objects are selected: what is half typed was meant for the old ones.
  void forgetTyping();

 Q_SIGNALS:
  void messageRaised(const QString& message);

 protected:
  MapDocument& document() const { return document_; }
  QString selectedId() const { return document_.selection().value(0); }

  /// A row with a number; `name` is the object name, for tests and style sheets.
  template <typename Edit>
  NumberField* addNumber(const char* name, const QString& label, double low, double high,
                         const QString& suffix, Edit edit) {
    auto* field = new NumberField(low, high, suffix);
    addField(name, label, field);
    connect(field, &NumberField::edited, this, edit);
    connect(field, &QAbstractSpinBox::editingFinished, this, &PropertyPage::finish);
    return field;
  }
  template <typename Edit>
  NumberField* addCoordinate(const char* name, const QString& label, Edit edit) {
    return addNumber(name, label, -1e6, 1e6, tr(" m"), edit);
  }
  template <typename Edit>
  NumberField* addHeading(Edit edit) {
    NumberField* field = addNumber("heading", tr("Heading"), -360.0, 360.0, tr("°"), edit);
    field->setWrapping(true);
    return field;
  }
  /// A row with a text that is changed while it is typed.
  template <typename Edit>
  QLineEdit* addText(const char* name, const QString& label, Edit edit) {
    QLineEdit* field = addLine(name, label);
    connect(field, &QLineEdit::textEdited, this, edit);
    return field;
  }
  /// A row with the id of the one selected object, which is renamed when the user is done.
  void addId();
  void showId();
  void addField(const char* name, const QString& label, QWidget* field);

  /// With its label.
  void showField(QWidget& field, bool shown);
  static void showText(QLineEdit& field, const QString& text);

 private:
  QLineEdit* addLine(const char* name, const QString& label);
  void finish();

  MapDocument& document_;
  QFormLayout* form_;
  QLineEdit* id_ = nullptr;
  QString shown_id_;
};

}  // namespace handmap
