// What in the drawing is likely to be a slip. Looked for in another thread whenever the drawing has
// been left alone for a moment.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <stop_token>
#include <string>
#include <unordered_map>

#include "core/map/issues.h"
#include "widgets/background/background.h"
#include "widgets/document/map_document.h"

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace handmap {

class IssuesPanel : public QWidget {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(IssuesPanel)
 public:
  explicit IssuesPanel(MapDocument& document, QWidget* parent = nullptr);
  ~IssuesPanel() override;

  const std::vector<Issue>& issues() const { return issues_; }

 Q_SIGNALS:
  /// Somebody wants to look at one.
  void showRequested(const handmap::Issue& issue);
  void found();  ///< issues() are those of the drawing as it is

 private:
  void search();
  void take(std::vector<Issue> issues, int search);
  void request(const QListWidgetItem* item);
  void fill();
  using Names = std::unordered_map<std::string, QString>;  ///< by ids, as they are shown
  static Names namesIn(const Map& map);
  static QString textOf(const Issue& issue, const Names& names);

  MapDocument& document_;
  std::vector<Issue> issues_;
  QListWidget* list_;
  QLabel* summary_;
  QTimer timer_;
  int search_ = 0;
  std::stop_source stop_;
  std::shared_ptr<Lifeline<IssuesPanel>> lifeline_;
};

}  // namespace handmap
