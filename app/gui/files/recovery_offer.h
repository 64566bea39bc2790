// Offers what earlier sessions have left behind, one after another, in the message bar.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/gui/files/recovery.h"

namespace handmap {

class MessageBar;

class RecoveryOffer : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    QWidget& window;
    Recovery& recovery;
    MessageBar& messages;
    /// Asks for what is open now; false: it is to stay.
    std::function<bool()> may_leave;
  };
  explicit RecoveryOffer(const Parts& parts, QObject* parent = nullptr);

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

  Parts parts_;
  std::vector<LeftBehind> waiting_;  ///< the one at the back is offered
};

}  // namespace handmap
