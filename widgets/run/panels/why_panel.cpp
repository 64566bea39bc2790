#include "widgets/run/panels/why_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/run/words/words.h"

namespace handmap {

namespace {

enum Column { Time, Rays, Offset, Share, Pull, ColumnCount };

QString centimetres(double value) { return QString::number(value, 'f', 2); }

QString signedMetres(double value) {
  return (value > 0.0 ? QStringLiteral("+") : QString()) + centimetres(value);
}

/// The drawing has a weight, however little.
QString percent(double share) { return QString::number(100.0 * share, 'f', 1); }

}  // namespace

WhyPanel::WhyPanel(QWidget* parent)
    : QWidget(parent),
      buildings_(new QComboBox),
      walls_(new QComboBox),
      words_(new QLabel),
      witnesses_(new QTableWidget(0, ColumnCount)) {
  buildings_->setAccessibleName(tr("Building that is asked about"));
  walls_->setAccessibleName(tr("Wall that is asked about"));
  buildings_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  walls_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  witnesses_->setHorizontalHeaderLabels(
      {tr("Time\n(s)"), tr("Rays"), tr("Saw at\n(m)"), tr("Weight\n(%)"), tr("Pulled\n(m)")});
  witnesses_->setAccessibleName(tr("Observations that placed the wall"));
  witnesses_->setToolTip(
      tr("Metres outwards from where the wall stands now. Click: look at that moment."));
  witnesses_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  witnesses_->setSelectionBehavior(QAbstractItemView::SelectRows);
  witnesses_->setSelectionMode(QAbstractItemView::SingleSelection);
  witnesses_->setTabKeyNavigation(false);
  witnesses_->setFrameShape(QFrame::NoFrame);
  witnesses_->verticalHeader()->hide();
  witnesses_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  witnesses_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  for (QWidget* widget : {static_cast<QWidget*>(words_), static_cast<QWidget*>(witnesses_),
                          static_cast<QWidget*>(witnesses_->horizontalHeader())}) {
    widget->setFont(small);
  }
  auto* top = new QHBoxLayout;
  top->addWidget(buildings_, 1);
  top->addWidget(walls_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(top);
  layout->addWidget(words_);
  layout->addWidget(witnesses_, 1);
  connect(buildings_, &QComboBox::currentIndexChanged, this, [this] {
    if (filling_) return;
    fillWalls();
    tellWall();
  });
  connect(walls_, &QComboBox::currentIndexChanged, this, [this] {
    if (!filling_) tellWall();
  });
  connect(witnesses_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int row = witnesses_->currentRow();
    const bool one = !witnesses_->selectedItems().isEmpty() && row >= 0;
    Q_EMIT witnessChosen(one ? std::optional(static_cast<std::size_t>(row)) : std::nullopt);
  });
  const auto choose = [this](int row) {
    if (row >= 0 && static_cast<std::size_t>(row) < times_.size()) {
      Q_EMIT timeChosen(times_[static_cast<std::size_t>(row)]);
    }
  };
  connect(witnesses_, &QTableWidget::cellClicked, this, choose);
  connect(witnesses_, &QTableWidget::cellActivated, this, choose);
  clear();
}

void WhyPanel::clear() {
  setMap({});
  words_->setText(tr("Click a corrected wall on the map, or choose one here: what placed it?"));
}

void WhyPanel::setMap(const Map& refined) {
  const auto before = asked();
  map_ = refined;
  const QScopedValueRollback quiet(filling_, true);
  buildings_->clear();
  for (std::size_t b = 0; b < map_.buildings.size(); ++b) {
    if (!map_.buildings[b].estimate) continue;
    buildings_->addItem(Words::nameOf(map_.buildings[b]), static_cast<qulonglong>(b));
  }
  const int at = before ? buildings_->findData(static_cast<qulonglong>(before->building)) : -1;
  buildings_->setCurrentIndex(at);
  fillWalls();
  if (at >= 0) walls_->setCurrentIndex(walls_->findData(static_cast<qulonglong>(before->wall)));
  if (at < 0) {
    witnesses_->setRowCount(0);
    times_.clear();
  }
}

void WhyPanel::fillWalls() {
  const QScopedValueRollback quiet(filling_, true);
  walls_->clear();
  if (buildings_->currentIndex() < 0) return;
  const Polygon outline = map_.buildings[buildings_->currentData().toULongLong()].footprint();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 along = outline[(i + 1) % outline.size()] - outline[i];
    const Vec2 outwards = -perpendicular(along);
    walls_->addItem(tr("%1 wall, %2 m long")
                        .arg(Words::direction(std::atan2(outwards.y(), outwards.x())))
                        .arg(along.norm(), 0, 'f', 1),
                    static_cast<qulonglong>(i));
  }
}

void WhyPanel::ask(std::size_t building, std::size_t wall) {
  {
    const QScopedValueRollback quiet(filling_, true);
    buildings_->setCurrentIndex(buildings_->findData(static_cast<qulonglong>(building)));
    fillWalls();
    walls_->setCurrentIndex(walls_->findData(static_cast<qulonglong>(wall)));
  }
  tellWall();
}

std::optional<WhyPanel::Wall> WhyPanel::asked() const {
  if (buildings_->currentIndex() < 0 || walls_->currentIndex() < 0) return std::nullopt;
  return Wall{buildings_->currentData().toULongLong(), walls_->currentData().toULongLong()};
}

void WhyPanel::tellWall() {
  const auto wall = asked();
  wall ? Q_EMIT wallAsked(wall->building, wall->wall) : Q_EMIT nothingAsked();
}

void WhyPanel::setStory(const WallStory& story, bool kept) {
  QStringList lines;
  const double moved = -story.drawn_m;
  lines << tr("It stands %1 m %2 of the drawn one; known to ±%3 m.")
               .arg(centimetres(std::abs(moved)), moved < 0.0 ? tr("inwards") : tr("outwards"),
                    centimetres(story.sigma_m));
  if (!story.seen) {
    lines << (story.witnesses.empty()
                  ? tr("Nobody saw it: its other walls put it there.")
                  : tr("Hardly a ray ended on it: its other walls put it there."));
  }
  lines << tr("Drawing: %1 ±%2 m, weight %3 %.")
               .arg(signedMetres(story.drawn_m), centimetres(story.drawn_sigma_m),
                    percent(story.drawn_share));
  if (!kept) {
    lines << tr("What the robot saw is not kept: nothing more can be told.");
  } else if (story.witnesses.empty()) {
    lines << tr("No ray ended within %1 m of it.").arg(story.tolerance_m);
  } else {
    lines << tr("Seen: %1 ±%2 m, weight %3 %, by %n observation(s)", nullptr,
                static_cast<int>(story.witnesses.size()))
                     .arg(signedMetres(story.seen_m), centimetres(story.seen_sigma_m),
                          percent(1.0 - story.drawn_share)) +
                 tr(" with %1 rays that ended within %2 m.").arg(story.rays).arg(story.tolerance_m);
    lines << tr("Together: %1 m. The rest is of its other walls and of the drawing as a whole.")
                 .arg(signedMetres(story.explained_m));
  }
  words_->setText(lines.join(QLatin1Char('\n')));
  fillWitnesses(story);
}

void WhyPanel::fillWitnesses(const WallStory& story) {
  witnesses_->clearSelection();
  times_.clear();
  const int rows = std::min(kMostWitnesses, static_cast<int>(story.witnesses.size()));
  witnesses_->setRowCount(rows);
  for (int row = 0; row < rows; ++row) {
    const WallWitness& witness = story.witnesses[static_cast<std::size_t>(row)];
    times_.push_back(witness.time_s);
    const std::array<QString, ColumnCount> texts = {
        QString::number(witness.time_s, 'f', 1), QString::number(witness.returns.size()),
        signedMetres(witness.offset_m), percent(witness.share), signedMetres(witness.pull_m)};
    for (int column = 0; column < ColumnCount; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      witnesses_->setItem(row, column, item);
    }
  }
}

QString WhyPanel::words() const { return words_->text(); }

void WhyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  Q_EMIT shown(true);
}

void WhyPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  Q_EMIT shown(false);
}

}  // namespace handmap
