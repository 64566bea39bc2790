#include "widgets/run/panels/buildings_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/map/certainty.h"
#include "core/map/map_changes.h"
#include "widgets/run/words/review_words.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {

struct ColumnText {
  const char* title;
  const char* hint;
};

constexpr std::array<ColumnText, BuildingsModel::ColumnCount> kColumnTexts = {{
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Building"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Id and name in the drawing")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Moved\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "From the drawn to the corrected middle")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Turned\n(°)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Counter-clockwise, against the drawing")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Wider\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "Corrected minus drawn width, along its heading")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Deeper\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Corrected minus drawn depth")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Sure to\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "One standard deviation of the least sure wall that was seen")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Why doubtful"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "What speaks against taking it over")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Doubt\n(%)"),
     QT_TRANSLATE_NOOP(
         "handmap::BuildingsModel",
         "Of 100 buildings with such signs so many were wrong: another one, or none, stood there")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "± right\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "Standard deviation of the wall that faces right on the map; in brackets "
                       "where nobody saw it")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "± up\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "Standard deviation of the wall that faces up on the map; in brackets "
                       "where nobody saw it")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "± left\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "Standard deviation of the wall that faces left on the map; in brackets "
                       "where nobody saw it")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "± down\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel",
                       "Standard deviation of the wall that faces down on the map; in brackets "
                       "where nobody saw it")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Seen\n(times)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "In how many observations it was seen")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Off\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "From the corrected to the true middle")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Drawn x\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Middle of the drawn building")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Drawn y\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Middle of the drawn building")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Now x\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Middle of the corrected building")},
    {QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Now y\n(m)"),
     QT_TRANSLATE_NOOP("handmap::BuildingsModel", "Middle of the corrected building")},
}};

constexpr double kRatherNot = 1.0;  // of suspicion: what is as likely wrong as right
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Nothing where it is nothing.
QString signedText(double number, int decimals) {
  const QString text = QString::number(number, 'f', decimals);
  if (text.toDouble() == 0.0) return QStringLiteral("0");
  return number > 0.0 ? QLatin1Char('+') + text : text;
}

/// Equal also where both are not known.
bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

void BuildingsModel::setDrawing(Map drawing) {
  beginResetModel();
  drawing_ = std::move(drawing);
  rows_.clear();
  taken_.clear();
  endResetModel();
}

BuildingsModel::Row BuildingsModel::rowOf(std::size_t building, const Building& now) const {
  const Building& drawn = drawing_.buildings[building];
  Row row;
  row.id = QString::fromStdString(drawn.id);
  row.name = Words::nameOf(drawn);
  row.building = building;
  auto& numbers = row.numbers;
  const BuildingChange change = changeOf(drawn, now);
  numbers[Moved] = change.moved_m();
  numbers[Turned] = toDegrees(change.turned);
  numbers[Doubt] = 100.0 * doubtOf(now);
  const std::array<SideEstimate, 4> sides = sidesOf(now);
  for (std::size_t facing = 0; facing < sides.size(); ++facing) {
    const Vec2 outwards = unitVector(static_cast<double>(facing) * kPi / 2.0);
    const SideEstimate& side = sides[sideFacing(now.box().heading, outwards)];
    numbers[SigmaRight + facing] = side.sigma;
    row.seen[facing] = side.seen;
  }
  numbers[Observations] = now.estimate->observations;
  numbers[Error] = (truth_ ? truth_->errorOf(now) : std::nullopt).value_or(kUnknown);
  numbers[DrawnX] = change.drawn.x();
  numbers[DrawnY] = change.drawn.y();
  numbers[NowX] = change.now.x();
  numbers[NowY] = change.now.y();
  numbers[Wider] = change.wider_m;
  numbers[Deeper] = change.deeper_m;
  numbers[Sure] = seenSigma(now).value_or(kUnknown);
  const Suspicion suspicion = ReviewWords::suspicion(drawing_, refined_, building, concerns_);
  numbers[Why] = suspicion.degree;
  row.why = suspicion.reasons.join(tr("; "));
  row.doubtful = suspicion.degree >= kRatherNot;
  return row;
}

void BuildingsModel::setRefined(const Map& refined) {
  refined_ = refined;
  concerns_ = concernsOf(drawing_, refined_);
  std::vector<Row> rows;
  // The buildings of a refined map stand where those of its drawing do.
  const std::size_t count = std::min(refined.buildings.size(), drawing_.buildings.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!refined.buildings[i].estimate) continue;
    rows.push_back(rowOf(i, refined.buildings[i]));
  }
  const bool same_buildings = std::ranges::equal(rows, rows_, {}, &Row::id, &Row::id);
  if (!same_buildings) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    Q_EMIT takenChanged();
    return;
  }
  const bool same = std::ranges::equal(rows, rows_, [](const Row& a, const Row& b) {
    return a.seen == b.seen && a.why == b.why && std::ranges::equal(a.numbers, b.numbers, isSame);
  });
  if (same) return;
  rows_ = std::move(rows);
  Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  Q_EMIT takenChanged();
}

QStringList BuildingsModel::leftOut() const {
  QStringList ids;
  for (const Row& row : rows_)
    if (!isTaken(row)) ids << row.id;
  return ids;
}

void BuildingsModel::setAllTaken(bool taken) {
  if (rows_.empty()) return;
  for (const Row& row : rows_) taken_[row.id] = taken;
  Q_EMIT dataChanged(index(0, Name), index(rowCount() - 1, Name), {Qt::CheckStateRole});
  Q_EMIT takenChanged();
}

Qt::ItemFlags BuildingsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == Name ? flags | Qt::ItemIsUserCheckable : flags;
}

bool BuildingsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != Name) return false;
  taken_[idAt(index.row())] = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
  Q_EMIT takenChanged();
  return true;
}

QString BuildingsModel::idAt(int row) const { return rows_.at(static_cast<std::size_t>(row)).id; }

int BuildingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int BuildingsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString BuildingsModel::text(const Row& row, int column) const {
  if (column == Name) return row.name;
  if (column == Why) return row.why;
  const double number = row.numbers.at(static_cast<std::size_t>(column));
  if (std::isnan(number)) return QStringLiteral("–");
  if (column == Turned) return signedText(number, 1);
  if (column == Observations) return QString::number(std::lround(number));
  if (column == Doubt) {
    return number > 0.0 ? QString::number(std::lround(number)) : QStringLiteral("–");
  }
  if (column == Wider || column == Deeper) return signedText(number, 2);
  QString text = QString::number(number, 'f', 2);
  const int sigma = column - SigmaRight;
  if (sigma >= 0 && sigma < 4 && !row.seen.at(static_cast<std::size_t>(sigma))) {
    text = QStringLiteral("(%1)").arg(text);
  }
  return text;
}

QString BuildingsModel::csvText(const Row& row, int column) {
  if (column == Name) return row.name;
  if (column == Why) return row.why;
  const double number = row.numbers.at(static_cast<std::size_t>(column));
  const int sigma = column - SigmaRight;
  const bool unseen = sigma >= 0 && sigma < 4 && !row.seen.at(static_cast<std::size_t>(sigma));
  if (unseen || std::isnan(number)) return {};
  return QString::number(number, 'f', column == Observations ? 0 : 3);
}

QString BuildingsModel::words(const Row& row) const {
  return Words::building(drawing_, refined_, row.building, truth_ ? &*truth_ : nullptr);
}

QVariant BuildingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
  const int column = index.column();
  switch (role) {
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignVCenter |
                      (column == Name || column == Why ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::CheckStateRole:
      return column == Name ? QVariant(isTaken(row) ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DisplayRole:
      return text(row, column);
    case Qt::ToolTipRole:
      return words(row);
    case kCsvRole:
      return csvText(row, column);
    case kSortRole:
      return column == Name ? QVariant(row.name)
                            : QVariant(row.numbers.at(static_cast<std::size_t>(column)));
    default:
      return {};
  }
}

QVariant BuildingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const ColumnText& text = kColumnTexts.at(static_cast<std::size_t>(section));
  if (role == Qt::DisplayRole) return tr(text.title);
  if (role == Qt::ToolTipRole) return tr(text.hint);
  return {};
}

}  // namespace handmap
