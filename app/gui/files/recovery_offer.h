// Offers what earlier sessions have left behind, one after another, in the message bar.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "widgets/recovery/recovery.h"

namespace handmap {

class MessageBar;

class RecoveryOffer : public QObject {
  Q_OBJECT
 public:
  /// `may_leave` asks for what is open now; false: it is to stay.
  RecoveryOffer(QWidget& window, MessageBar& messages, Recovery& recovery,
                std::function<bool()> may_leave, QObject* parent = nullptr);

  /// Looks for what was left behind. Nothing while an offer is not answered.
  void look();

 Q_SIGNALS:
  void recovered(bool with_teaching);

 private:
  void offerNext();
  void offer(const LeftBehind& left, const UnsavedWork& work);
  void tellUnreadable(const LeftBehind& left, const QString& problem);
  void recover(const LeftBehind& left, const UnsavedWork& work);
  void answered();

  QWidget& window_;
  MessageBar& messages_;
  Recovery& recovery_;
  std::function<bool()> may_leave_;
  std::vector<LeftBehind> waiting_;  ///< the one at the back is offered
};

}  // namespace handmap
