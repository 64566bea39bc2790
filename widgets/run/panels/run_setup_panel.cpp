#include "widgets/run/panels/run_setup_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>
#include <limits>

namespace handmap {

namespace {
constexpr int kLastFrame = 9'999'999;
constexpr int kToTheEnd = -1;
enum class ToldBy { Program, Taught, Nothing };
}  // namespace

RunSetupPanel::RunSetupPanel(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  method_ = new QComboBox;
  method_->addItem(tr("Handmap"), static_cast<int>(Method::Handmap));
  method_->addItem(tr("Published FastSLAM/PSOM"), static_cast<int>(Method::Paper));
  method_->setToolTip(tr("Handmap's own method, or the published one to the letter"));
  form->addRow(tr("Method"), method_);
  free_scale_ = new QCheckBox(tr("Scale unknown"));
  free_scale_->setToolTip(tr("The drawing may be 0.7 to 1.4 times as large as the place"));
  free_turn_ = new QCheckBox(tr("Turn unknown"));
  free_turn_->setToolTip(tr("The drawing may be turned by up to 40° about the robot's start"));
  form->addRow(tr("Drawing"), free_scale_);
  form->addRow(QString(), free_turn_);
  slam_particles_ =
      addNumber(tr("Particles"), 1, 100'000, tr("Poses of the robot that are followed at once"));
  pso_particles_ =
      addNumber(tr("Swarm"), 1, 1000, tr("Points of the swarm that corrects a building"));
  pso_iterations_ =
      addNumber(tr("Iterations"), 0, 1000, tr("Moves of a swarm in one observation, at most"));
  seed_ = addNumber(tr("Seed"), 0, std::numeric_limits<int>::max(),
                    tr("The same seed and the same inputs give the same result"));
  threads_ = addNumber(tr("Threads"), 0, 256, tr("The result does not depend on it"));
  threads_->setSpecialValueText(tr("all"));
  buildings_ = new QComboBox;
  buildings_->addItem(tr("Found by the program"), static_cast<int>(ToldBy::Program));
  buildings_->addItem(tr("Every wall counts"), static_cast<int>(ToldBy::Nothing));
  buildings_->setToolTip(
      tr("How buildings are distinguished from trees and hedges in images; with Teach Buildings "
         "you make a way of your own"));
  form->addRow(tr("Buildings in images"), buildings_);
  source_ = new QComboBox;
  source_->addItem(tr("Images, else points"), static_cast<int>(SourceKind::Auto));
  source_->addItem(tr("Images"), static_cast<int>(SourceKind::Images));
  source_->addItem(tr("Points"), static_cast<int>(SourceKind::Points));
  source_->setToolTip(tr("What is taken of a recording"));
  form->addRow(tr("Source"), source_);
  from_ = addNumber(tr("From frame"), 0, kLastFrame, tr("First frame of a recording"));
  to_ = addNumber(tr("To frame"), kToTheEnd, kLastFrame, tr("Last frame of a recording"));
  to_->setSpecialValueText(tr("end"));
  every_ = addNumber(tr("Observations"), 1, 10'000,
                     tr("How many observations are used: all of them, or one of every so many"));
  every_->setSpecialValueText(tr("all"));
  every_->setPrefix(tr("one of "));
  connect(method_, &QComboBox::currentIndexChanged, this, &RunSetupPanel::showOfMethod);
  setSetup({});
  showOfMethod();
  for (QSpinBox* box : {from_, to_, every_})
    connect(box, &QSpinBox::valueChanged, this, &RunSetupPanel::replayChanged);
  connect(source_, &QComboBox::currentIndexChanged, this, &RunSetupPanel::replayChanged);
}

/// What the other method alone asks for is not asked.
void RunSetupPanel::showOfMethod() {
  const bool is_ours = method_->currentData().toInt() == static_cast<int>(Method::Handmap);
  free_scale_->setEnabled(is_ours);
  free_turn_->setEnabled(is_ours);
  auto* form = static_cast<QFormLayout*>(layout());
  for (QSpinBox* box : {slam_particles_, pso_particles_, pso_iterations_})
    form->setRowVisible(box, !is_ours);
}

QSpinBox* RunSetupPanel::addNumber(const QString& label, int low, int high, const QString& hint) {
  auto* box = new QSpinBox;
  box->setRange(low, high);
  box->setToolTip(hint);
  box->setAlignment(Qt::AlignRight);
  static_cast<QFormLayout*>(layout())->addRow(label, box);
  return box;
}

void RunSetupPanel::setTaughtClassifier(std::shared_ptr<const WindowClassifier> classifier) {
  taught_ = std::move(classifier);
  int index = buildings_->findData(static_cast<int>(ToldBy::Taught));
  if (!taught_) {
    if (index >= 0) buildings_->removeItem(index);
    if (index >= 0) buildings_->setCurrentIndex(0);
    return;
  }
  if (index < 0) {
    index = 1;
    buildings_->insertItem(index, tr("Found as taught"), static_cast<int>(ToldBy::Taught));
  }
  buildings_->setCurrentIndex(index);
}

RunSetup RunSetupPanel::setup() const {
  RunSetup setup;
  setup.settings.method = static_cast<Method>(method_->currentData().toInt());
  setup.settings.free_scale = free_scale_->isEnabled() && free_scale_->isChecked();
  setup.settings.free_turn = free_turn_->isEnabled() && free_turn_->isChecked();
  setup.settings.slam.slam_particles = slam_particles_->value();
  setup.settings.slam.pso_particles = pso_particles_->value();
  setup.settings.slam.pso_iterations = pso_iterations_->value();
  setup.settings.seed = static_cast<std::uint64_t>(seed_->value());
  setup.settings.threads = threads_->value();
  const auto told_by = static_cast<ToldBy>(buildings_->currentData().toInt());
  setup.settings.perception.classify = told_by != ToldBy::Nothing;
  if (told_by == ToldBy::Taught) setup.settings.perception.classifier = taught_;
  setup.replay.kind = static_cast<SourceKind>(source_->currentData().toInt());
  setup.replay.from = from_->value();
  if (to_->value() != kToTheEnd) setup.replay.to = to_->value();
  setup.replay.every = every_->value();
  return setup;
}

void RunSetupPanel::setSetup(const RunSetup& setup) {
  method_->setCurrentIndex(method_->findData(static_cast<int>(setup.settings.method)));
  free_scale_->setChecked(setup.settings.free_scale);
  free_turn_->setChecked(setup.settings.free_turn);
  slam_particles_->setValue(setup.settings.slam.slam_particles);
  pso_particles_->setValue(setup.settings.slam.pso_particles);
  pso_iterations_->setValue(setup.settings.slam.pso_iterations);
  seed_->setValue(static_cast<int>(setup.settings.seed));
  threads_->setValue(setup.settings.threads);
  const PerceptionOptions& perception = setup.settings.perception;
  if (perception.classify && perception.classifier) {
    setTaughtClassifier(perception.classifier);
  } else {
    const ToldBy told_by = perception.classify ? ToldBy::Program : ToldBy::Nothing;
    buildings_->setCurrentIndex(buildings_->findData(static_cast<int>(told_by)));
  }
  setReplay(setup.replay);
}

void RunSetupPanel::setReplay(const ReplayOptions& replay) {
  const QSignalBlocker silent(this);
  source_->setCurrentIndex(source_->findData(static_cast<int>(replay.kind)));
  from_->setValue(replay.from);
  to_->setValue(replay.to.value_or(kToTheEnd));
  every_->setValue(replay.every);
}

void RunSetupPanel::save(QSettings& settings) const {
  settings.setValue("run/particles", slam_particles_->value());
  settings.setValue("run/swarm", pso_particles_->value());
  settings.setValue("run/iterations", pso_iterations_->value());
  settings.setValue("run/threads", threads_->value());
}

void RunSetupPanel::restore(const QSettings& settings) {
  // Spin boxes clamp what is out of range; what is no number keeps the default.
  const auto take = [&settings](const char* key, QSpinBox* box) {
    bool is_number = false;
    const int value = settings.value(key).toInt(&is_number);
    if (is_number) box->setValue(value);
  };
  take("run/particles", slam_particles_);
  take("run/swarm", pso_particles_);
  take("run/iterations", pso_iterations_);
  take("run/threads", threads_);
}

}  // namespace handmap
