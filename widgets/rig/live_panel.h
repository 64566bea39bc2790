// How the devices of a live robot are: state, rate and age of each, what was not used and why.
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "core/rig/rig_monitor.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace handmap {

class LivePanel : public QWidget {
  Q_OBJECT
 public:
  using Monitor = std::function<std::shared_ptr<RigMonitor>()>;

  explicit LivePanel(QWidget* parent = nullptr);

  /// Looks a few times a second at what `monitor` gives, which may be nullptr. An empty function:
  /// looks no more, and keeps what it shows.
  void follow(Monitor monitor);
  void clear();

 private:
  void look();
  void show(const RigStatus& status);

  Monitor monitor_;
  QTreeWidget* devices_;
  QLabel* counts_;
  QPushButton* look_around_;
  QTimer timer_;
};

}  // namespace handmap
