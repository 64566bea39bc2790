#include "widgets/run/panels/said_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

namespace handmap {

SaidPanel::SaidPanel(QWidget* parent) : QWidget(parent), rows_(new QListWidget) {
  rows_->setAccessibleName(tr("What you said"));
  rows_->setFrameShape(QFrame::NoFrame);
  rows_->setSelectionMode(QAbstractItemView::NoSelection);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(rows_);
  setRows({});
}

int SaidPanel::count() const { return static_cast<int>(findChildren<QToolButton*>().size()); }

QWidget* SaidPanel::rowOf(const QString& text, int row) {
  auto* widget = new QWidget;
  auto* layout = new QHBoxLayout(widget);
  layout->setContentsMargins(6, 2, 2, 2);
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  layout->addWidget(label, 1);
  auto* cross = new QToolButton;
  cross->setText(QStringLiteral("✕"));
  cross->setAutoRaise(true);
  cross->setToolTip(tr("Take it back: the run is done again without it"));
  cross->setAccessibleName(tr("Take back: %1").arg(text));
  connect(cross, &QToolButton::clicked, this, [this, row] { Q_EMIT takeBackWanted(row); });
  layout->addWidget(cross);
  return widget;
}

void SaidPanel::setRows(const QStringList& rows) {
  rows_->clear();
  if (rows.isEmpty()) {
    rows_->addItem(
        tr("Robot is here, Building is right and Building is not there are listed here "
           "while the run is there."));
    rows_->item(0)->setFlags(Qt::NoItemFlags);
    rows_->setWordWrap(true);
    return;
  }
  for (int row = 0; row < rows.size(); ++row) {
    auto* item = new QListWidgetItem(rows_);
    QWidget* widget = rowOf(rows[row], row);
    item->setSizeHint(widget->sizeHint());
    rows_->setItemWidget(item, widget);
  }
}

}  // namespace handmap
