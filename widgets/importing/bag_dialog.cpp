#include "widgets/importing/bag_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <variant>

namespace handmap {

namespace {

using BagOrFailure = std::variant<std::shared_ptr<const Bag>, Failure>;

BagOrFailure openBagInBackground(const QString& file) {
  try {
    return std::shared_ptr<const Bag>(openBag(file.toStdString()));
  } catch (const Error& error) {
    return failureOf(error);
  } catch (const std::exception& error) {
    return Failure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
  }
}

}  // namespace

BagDialog::BagDialog(const QString& file, QWidget* parent)
    : QDialog(parent),
      form_(new QFormLayout),
      words_(new QLabel(tr("Reading…"))),
      sensor_(new QLineEdit),
      self_(std::make_shared<Lifeline<BagDialog>>(*this)) {
  setObjectName("bag_dialog");
  setWindowTitle(tr("Import a bag of ROS"));
  resize(560, 320);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  import_ = buttons->addButton(tr("Import…"), QDialogButtonBox::AcceptRole);
  import_->setDefault(true);
  // It has the focus while it is all that can be pressed: Return would leave.
  buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
  import_->setEnabled(false);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  words_->setWordWrap(true);
  words_->setObjectName("bag_words");
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  layout->addWidget(words_, 1, Qt::AlignTop);
  layout->addWidget(buttons);
  const std::pair<const char*, QString> roles[] = {
      {"left", tr("Left images")},   {"right", tr("Right images")}, {"scan", tr("Laser scan")},
      {"points", tr("Point cloud")}, {"odometry", tr("Odometry")},  {"truth", tr("True poses")}};
  for (const auto& [role, name] : roles) {
    auto* choice = new QComboBox;
    choice->setEnabled(false);
    choice->setObjectName(QStringLiteral("bag_%1").arg(QLatin1String(role)));
    choices_[role] = choice;
    form_->addRow(name, choice);
    connect(choice, &QComboBox::currentIndexChanged, this, &BagDialog::judge);
  }
  sensor_->setObjectName("bag_sensor");
  sensor_->setPlaceholderText(tr("as the bag says; else x,y,z, e.g. 0.3,0,1.7"));
  sensor_->setToolTip(
      tr("Where on the robot the scanner or camera is: ahead, left, up, metres, and "
         "how far it is turned to the left, degrees."));
  form_->addRow(tr("Place of the sensor"), sensor_);
  connect(sensor_, &QLineEdit::textChanged, this, &BagDialog::judge);
  startInBackground([self = self_, file] {
    self->post([answer = openBagInBackground(file)](BagDialog& dialog) {
      if (const auto* failure = std::get_if<Failure>(&answer)) {
        dialog.words_->setText(failure->message);
      } else {
        dialog.show(std::get<std::shared_ptr<const Bag>>(answer));
      }
    });
  });
}

BagDialog::~BagDialog() { self_->cut(); }

void BagDialog::show(const std::shared_ptr<const Bag>& bag) {
  bag_ = bag;
  const BagPlan plan = planOf(*bag, {});
  const bool is_scan = plan.ranges && canServe(bag->topics()[*plan.ranges], "scan");
  fill("left", plan.left);
  fill("right", plan.right);
  fill("scan", is_scan ? plan.ranges : std::nullopt);
  fill("points", is_scan ? std::nullopt : plan.ranges);
  fill("odometry", plan.odometry);
  fill("truth", plan.truth);
  judge();
}

void BagDialog::fill(const std::string& role, std::optional<std::size_t> proposed) {
  QComboBox& choice = *choices_[role];
  const QSignalBlocker blocker(choice);
  choice.addItem(tr("none"), QStringLiteral("none"));
  for (std::size_t i = 0; i < bag_->topics().size(); ++i) {
    const BagTopic& topic = bag_->topics()[i];
    if (!canServe(topic, role)) continue;
    const QString name = QString::fromStdString(topic.name);
    choice.addItem(tr("%1 (%n message(s))", nullptr, static_cast<int>(topic.messages)).arg(name),
                   name);
    if (i == proposed) choice.setCurrentIndex(choice.count() - 1);
  }
  choice.setEnabled(choice.count() > 1);
}

ToldTopics BagDialog::topics() const {
  ToldTopics told;
  for (const auto& [role, choice] : choices_) {
    const std::string topic = choice->currentData().toString().toStdString();
    if (!topic.empty()) told[role] = topic;
  }
  const QString place = sensor_->text().trimmed();
  if (!place.isEmpty()) told["sensor"] = place.toStdString();
  return told;
}

bool BagDialog::maySee() const {
  return std::ranges::any_of(std::array{"left", "right", "scan", "points"},
                             [this](const char* role) { return choices_.at(role)->isEnabled(); });
}

void BagDialog::judge() {
  if (!bag_) return;
  QStringList words;
  bool sees = false;
  try {
    sees = planOf(*bag_, topics()).seesAnything();
    if (!sees) {
      words << (maySee() ? tr("Nothing in it sees: choose a scan, points, or a pair of images that "
                              "have camera infos beside them.")
                         : tr("Nothing in it sees: it has neither scans nor points nor images."));
    }
  } catch (const Error& error) {
    words << QString::fromStdString(error.what());
  }
  for (const std::string& note : bag_->notes()) words << QString::fromStdString(note);
  words_->setText(words.join('\n'));
  import_->setEnabled(sees);
}

}  // namespace handmap
