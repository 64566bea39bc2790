// What happened during a run, the newest last: bounded, so that hours of it cost no more than
// minutes.
#pragma once

#include <QAbstractTableModel>
#include <deque>
#include <optional>

namespace handmap {

enum class LogKind { Note, Warning, Problem };

struct LogEntry {
  std::optional<double> time_s;  ///< of the recording
  LogKind kind = LogKind::Note;
  QString text;
  QString building;  ///< id of the one that it is about; empty: none
};

class LogModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Time, Kind, Text, ColumnCount };
  /// Older entries go; dropped() counts them.
  static constexpr std::size_t kMostEntries = 2000;

  using QAbstractTableModel::QAbstractTableModel;

  void add(LogEntry entry);
  const LogEntry& entry(int row) const { return entries_.at(static_cast<std::size_t>(row)); }
  int dropped() const { return dropped_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  static QString kindInWords(LogKind kind);

 private:
  std::deque<LogEntry> entries_;
  int dropped_ = 0;
};

}  // namespace handmap
