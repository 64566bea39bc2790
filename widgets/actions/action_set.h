// The actions of one window, made from the table.
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QObject>

#include "widgets/actions/action_table.h"

class QMenuBar;
class QSettings;
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
  /// `why_not` is said while they are disabled: in the tooltip and the palette of commands.
  void setEnabled(std::initializer_list<const char*> ids, bool enabled,
                  const QString& why_not = {}) const;
  QString whyNot(const QString& id) const;  ///< empty while it is enabled

  // --- Keys: those of the table, or what somebody has chosen in their place
  QList<QKeySequence> keys(const QString& id) const;
  /// Id of the action that has one of the keys besides `id`; empty: none.
  QString ownerOf(const QList<QKeySequence>& keys, const QString& id) const;
  void setKeys(const QString& id, const QList<QKeySequence>& keys) const;
  static QList<QKeySequence> usualKeys(const ActionSpec& spec);
  void saveKeys(QSettings& settings) const;  ///< only what is not as usual
  void restoreKeys(const QSettings& settings) const;

  void fillMenuBar(QMenuBar& menu_bar) const;  ///< the menus in the order of the table
  void fillToolBar(QToolBar& bar, ToolBar which) const;

 private:
  QHash<QString, QAction*> actions_;
};

/// In the language of the program, without mnemonic and dots.
QString plainTextOf(const ActionSpec& spec);
QString hintOf(const ActionSpec& spec);
QString plainTitleOf(Menu menu);

}  // namespace handmap
