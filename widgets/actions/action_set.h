// The actions of one window, made from the table.
#pragma once

#include <QAction>
#include <QHash>
#include <QObject>

#include "widgets/actions/action_table.h"

class QActionGroup;
class QMenuBar;
class QToolBar;

namespace handmap {

class ActionSet : public QObject {
  Q_OBJECT
 public:
  explicit ActionSet(QObject* parent = nullptr);

  /// The id must be in the table.
  QAction& operator[](const QString& id) const;
  /// Calls `handler` when the action is triggered: actions.on("file.save", this, [this] { … });
  template <typename Handler>
  void on(const QString& id, const QObject* context, Handler handler) const {
    QObject::connect(&(*this)[id], &QAction::triggered, context, handler);
  }
  void setEnabled(std::initializer_list<const char*> ids, bool enabled) const;

  void fillMenuBar(QMenuBar& menu_bar) const;  ///< the menus in the order of the table
  void fillToolBar(QToolBar& bar, ToolBar which) const;

 private:
  QHash<QString, QAction*> actions_;
};

/// An HTML table of every action that has keys, by menu.
QString shortcutSheet();

}  // namespace handmap
