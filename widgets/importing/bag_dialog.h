// Says what a bag of ROS holds and which of its topics is taken for what, and lets a person choose
// others.
#pragma once

#include <QDialog>
#include <map>
#include <memory>
#include <string>

#include "core/bag_import/bag_plan.h"
#include "widgets/background/background.h"
#include "widgets/background/failure.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace handmap {

class BagDialog : public QDialog {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(BagDialog)
 public:
  explicit BagDialog(const QString& file, QWidget* parent = nullptr);
  ~BagDialog() override;

  /// nullptr before it was opened, and where it cannot be.
  const std::shared_ptr<const Bag>& bag() const { return bag_; }
  /// As chosen, and where the sensor is.
  ToldTopics topics() const;

 private:
  void show(const std::shared_ptr<const Bag>& bag);
  void fill(const std::string& role, std::optional<std::size_t> proposed);
  /// Whether there is anything to choose that sees.
  bool maySee() const;
  void judge();

  std::shared_ptr<const Bag> bag_;
  QFormLayout* form_;
  QLabel* words_;
  QPushButton* import_;
  std::map<std::string, QComboBox*> choices_;  ///< by role
  QLineEdit* sensor_;
  std::shared_ptr<Lifeline<BagDialog>> self_;  ///< shared with the thread that reads
};

}  // namespace handmap
