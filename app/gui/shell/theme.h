// Light or dark: as the system has it, or as somebody has chosen.
#pragma once

#include <QDBusVariant>
#include <QObject>

class QPalette;
class QSettings;

namespace handmap {

class ActionSet;

class Theme : public QObject {
  Q_OBJECT
 public:
  enum class Choice { System, Light, Dark };

  /// Both must outlive this object.
  Theme(const ActionSet& actions, QSettings& settings, QObject* parent);

 private Q_SLOTS:
  void onSystemSetting(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void askSystem();
  void takeSystem(const QVariant& value);
  void choose(Choice choice);
  void apply() const;

  const ActionSet& actions_;
  QSettings& settings_;
  Choice choice_ = Choice::System;
  bool system_is_dark_ = false;  ///< as the desktop portal says
};

}  // namespace handmap
