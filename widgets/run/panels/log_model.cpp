#include "widgets/run/panels/log_model.h"

namespace handmap {

void LogModel::add(LogEntry entry) {
  if (entries_.size() == kMostEntries) {
    beginRemoveRows({}, 0, 0);
    entries_.pop_front();
    ++dropped_;
    endRemoveRows();
  }
  const int row = rowCount();
  beginInsertRows({}, row, row);
  entries_.push_back(std::move(entry));
  endInsertRows();
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int LogModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString LogModel::kindInWords(LogKind kind) {
  switch (kind) {
    case LogKind::Note:
      return tr("Note");
    case LogKind::Warning:
      return tr("Warning");
    case LogKind::Problem:
      return tr("Problem");
  }
  return {};
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LogEntry& row = entry(index.row());
  if (role == Qt::TextAlignmentRole && index.column() == Time) {
    return QVariant(Qt::AlignVCenter | Qt::AlignRight);
  }
  if (role == Qt::ToolTipRole) return row.text;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case Time:
      return row.time_s ? QString::number(*row.time_s, 'f', 1) : QStringLiteral("–");
    case Kind:
      return kindInWords(row.kind);
    default:
      return row.text;
  }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Time:
      return tr("Time (s)");
    case Kind:
      return tr("Kind");
    default:
      return tr("What happened");
  }
}

}  // namespace handmap
