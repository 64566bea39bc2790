#include "widgets/teach/teach_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "core/base/error.h"
#include "core/recording/image_file.h"
#include "core/recording/recording_files.h"
#include "widgets/pictures/camera_image.h"

namespace handmap {

namespace {

constexpr int kProgressSteps = 1000;
const auto kModelFilter = QStringLiteral("*.json");

struct Counts {
  qsizetype buildings = 0;
  qsizetype others = 0;
};

Counts countOf(const QHash<QString, std::vector<WindowLabel>>& labels) {
  Counts counts;
  for (const std::vector<WindowLabel>& of_image : labels) {
    counts.buildings += std::count(of_image.begin(), of_image.end(), WindowLabel::Building);
    counts.others += std::count(of_image.begin(), of_image.end(), WindowLabel::Other);
  }
  return counts;
}

}  // namespace

TeachPanel::TeachPanel(QWidget* parent)
    : QWidget(parent),
      view_(new TeachView),
      images_(new QListWidget),
      brush_(new QComboBox),
      brush_size_(new QComboBox),
      colour_(new QCheckBox(tr("Use colours"))),
      train_(new QPushButton),
      save_(new QPushButton(tr("Save model…"))),
      save_with_map_(new QPushButton(tr("Save with the map"))),
      progress_(new QProgressBar),
      figures_(new QLabel) {
  auto* layout = new QGridLayout(this);
  makeFileButtons(*layout);
  images_->setAccessibleName(tr("Your own images"));
  images_->setMaximumWidth(200);
  layout->addWidget(images_, 1, 0, 3, 1);
  layout->addWidget(makeBrushes(), 0, 1);
  layout->addWidget(view_, 1, 1);
  layout->addWidget(makeTraining(), 2, 1);
  figures_->setWordWrap(true);
  figures_->setAlignment(Qt::AlignTop);
  figures_->setMinimumHeight(3 * fontMetrics().lineSpacing());  // the image keeps its size
  layout->addWidget(figures_, 3, 1);
  layout->setColumnStretch(1, 1);
  layout->setRowStretch(1, 1);
  connect(images_, &QListWidget::currentRowChanged, this, &TeachPanel::showImage);
  connect(view_, &TeachView::labelsChanged, this, &TeachPanel::keepLabels);
  updateState();
}

TeachPanel::~TeachPanel() = default;

void TeachPanel::makeFileButtons(QGridLayout& layout) {
  auto* open = new QPushButton(tr("Open images…"));
  connect(open, &QPushButton::clicked, this, &TeachPanel::askForImages);
  layout.addWidget(open, 0, 0);
}

QWidget* TeachPanel::makeBrushes() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  brush_->setObjectName("brush");
  brush_->addItem(tr("Building"), static_cast<int>(WindowLabel::Building));
  brush_->addItem(tr("Not a building"), static_cast<int>(WindowLabel::Other));
  brush_->addItem(tr("Erase"), static_cast<int>(WindowLabel::Unknown));
  brush_->setToolTip(tr("What the left button paints; the right one erases"));
  brush_size_->setObjectName("brush_size");
  for (const int side : {1, 3, 5, 9}) brush_size_->addItem(tr("%1 × %1 windows").arg(side), side);
  brush_size_->setCurrentIndex(1);
  const auto apply = [this] {
    view_->setBrush(static_cast<WindowLabel>(brush_->currentData().toInt()));
    view_->setBrushWindows(brush_size_->currentData().toInt());
  };
  connect(brush_, &QComboBox::currentIndexChanged, this, apply);
  connect(brush_size_, &QComboBox::currentIndexChanged, this, apply);
  auto* label = new QLabel(tr("&Paint"));
  label->setBuddy(brush_);
  layout->addWidget(label);
  layout->addWidget(brush_);
  layout->addWidget(brush_size_);
  layout->addStretch();
  return row;
}

QWidget* TeachPanel::makeTraining() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  train_->setObjectName("train");
  connect(train_, &QPushButton::clicked, this,
          [this] { isTraining() ? cancelTraining() : train(); });
  colour_->setChecked(true);
  colour_->setToolTip(tr("Without, the model also suits cameras that see grey"));
  progress_->setRange(0, kProgressSteps);
  connect(save_, &QPushButton::clicked, this, &TeachPanel::askToSave);
  save_with_map_->setObjectName("save_with_map");
  save_with_map_->setToolTip(tr("Beside the drawing, which takes it up whenever it is opened"));
  connect(save_with_map_, &QPushButton::clicked, this, &TeachPanel::saveWithMapRequested);
  auto* load = new QPushButton(tr("Load model…"));
  connect(load, &QPushButton::clicked, this, &TeachPanel::askToLoad);
  layout->addWidget(train_);
  layout->addWidget(colour_);
  layout->addWidget(progress_, 1);
  layout->addStretch();
  layout->addWidget(load);
  layout->addWidget(save_);
  layout->addWidget(save_with_map_);
  return row;
}

void TeachPanel::askForImages() {
  openImages(QFileDialog::getOpenFileNames(this, tr("Open images"), {},
                                           tr("Images (*.png *.jpg *.jpeg)")));
}

void TeachPanel::askToSave() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save the model"), "buildings.json", kModelFilter);
  if (!path.isEmpty()) saveModel(path);
}

void TeachPanel::askToLoad() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Load a model"), {}, kModelFilter);
  if (!path.isEmpty()) loadModel(path);
}

void TeachPanel::openImages(const QStringList& paths) {
  for (const QString& path : paths) {
    bool is_there = false;
    for (int i = 0; i < images_->count(); ++i) {
      is_there |= images_->item(i)->data(Qt::UserRole).toString() == path;
    }
    if (is_there) continue;
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), images_);
    item->setData(Qt::UserRole, path);
    item->setToolTip(path);
  }
  if (images_->currentRow() < 0 && images_->count() > 0) images_->setCurrentRow(0);
  Q_EMIT teachingChanged();
}

Teaching TeachPanel::teaching() const {
  Teaching teaching;
  for (int i = 0; i < images_->count(); ++i) {
    const QString path = images_->item(i)->data(Qt::UserRole).toString();
    teaching.images.push_back({path, labels_.value(path)});
  }
  return teaching;
}

void TeachPanel::addTeaching(const Teaching& teaching) {
  if (teaching.isEmpty()) return;
  QStringList paths;
  for (const Teaching::Image& image : teaching.images) {
    paths << image.path;
    if (!image.labels.empty()) labels_.insert(image.path, image.labels);
  }
  ++strokes_;
  openImages(paths);
  showImage();
  updateState();
}

void TeachPanel::showImage() {
  const QListWidgetItem* item = images_->currentItem();
  shown_ = item == nullptr ? QString() : item->data(Qt::UserRole).toString();
  image_ = cv::Mat();
  if (item != nullptr) {
    try {
      image_ = readImage(shown_.toStdString());
    } catch (const Error& error) {
      shown_.clear();
      Q_EMIT messageRaised(QString::fromUtf8(error.what()));
    }
  }
  view_->setImage(cameraImage(image_), labels_.value(shown_));
  showFound();
}

void TeachPanel::keepLabels() {
  labels_.insert(shown_, view_->labels());
  ++strokes_;
  updateState();
  Q_EMIT teachingChanged();
}

void TeachPanel::showFound() {
  if (!classifier_) view_->setFound(cv::Mat1f());
  if (!classifier_ || image_.empty()) return;
  try {
    view_->setFound(classifier_->probabilities(image_));
  } catch (const Error& error) {
    view_->setFound(cv::Mat1f());
    Q_EMIT messageRaised(QString::fromUtf8(error.what()));
  }
}

void TeachPanel::train() {
  if (isTraining()) return;
  TeachJob job;
  job.colour = colour_->isChecked();
  for (int i = 0; i < images_->count(); ++i) {
    const QString path = images_->item(i)->data(Qt::UserRole).toString();
    const std::vector<WindowLabel> labels = labels_.value(path);
    const bool painted = std::any_of(labels.begin(), labels.end(), [](WindowLabel label) {
      return label != WindowLabel::Unknown;
    });
    if (painted) job.images.push_back({path.toStdString(), labels});
  }
  worker_ = std::make_unique<TeachWorker>(std::move(job));
  connect(worker_.get(), &TeachWorker::progressed, this, [this](double share) {
    left_.update(share, steadySeconds());
    progress_->setValue(static_cast<int>(share * kProgressSteps));
    progress_->setFormat(QStringLiteral("%p %") + left_.inWords());
  });
  connect(worker_.get(), &TeachWorker::finished, this,
          [this, strokes = strokes_](const std::shared_ptr<const BuildingClassifier>& classifier) {
            trainingEnded();
            unsaved_ = true;
            trained_strokes_ = strokes;
            setClassifier(classifier);
          });
  connect(worker_.get(), &TeachWorker::cancelled, this, &TeachPanel::trainingEnded);
  connect(worker_.get(), &TeachWorker::failed, this, [this](const QString& message) {
    trainingEnded();
    Q_EMIT messageRaised(message);
  });
  progress_->setValue(0);
  worker_->start();
  updateState();
}

void TeachPanel::cancelTraining() {
  if (worker_) worker_->cancel();
}

void TeachPanel::trainingEnded() {
  // It has said its last word; not deleted here, as this is called by its signal.
  worker_.release()->deleteLater();
  updateState();
}

void TeachPanel::setClassifier(std::shared_ptr<const BuildingClassifier> classifier) {
  classifier_ = std::move(classifier);
  updateState();
  showFound();
  Q_EMIT classifierChanged(classifier_);
  Q_EMIT teachingChanged();
}

void TeachPanel::setSaved() {
  unsaved_ = false;
  Q_EMIT teachingChanged();
}

void TeachPanel::setModel(std::shared_ptr<const BuildingClassifier> classifier) {
  unsaved_ = false;
  setClassifier(std::move(classifier));
}

bool TeachPanel::saveModel(const QString& path) {
  if (!classifier_) return false;
  try {
    refuseFileOfRecording(path.toStdString());
    classifier_->save(path.toStdString());
    setSaved();
    return true;
  } catch (const Error& error) {
    Q_EMIT messageRaised(QString::fromUtf8(error.what()));
    return false;
  }
}

bool TeachPanel::loadModel(const QString& path) {
  try {
    setModel(
        std::make_shared<const BuildingClassifier>(BuildingClassifier::load(path.toStdString())));
    return true;
  } catch (const Error& error) {
    Q_EMIT messageRaised(QString::fromUtf8(error.what()));
    return false;
  }
}

void TeachPanel::updateState() {
  const Counts counts = countOf(labels_);
  const int needed = TrainingOptions().folds;
  const bool enough = counts.buildings >= needed && counts.others >= needed;
  train_->setText(isTraining() ? tr("Cancel") : tr("&Train"));
  train_->setEnabled(isTraining() || enough);
  progress_->setVisible(isTraining());
  save_->setEnabled(classifier_ != nullptr);
  save_with_map_->setEnabled(classifier_ != nullptr);
  QString text = tr("Painted: %1 windows of buildings, %2 of others.")
                     .arg(counts.buildings)
                     .arg(counts.others);
  if (!enough) text += tr(" Paint at least %1 of each to train.").arg(needed);
  if (classifier_) {
    const Confusion& crossed = classifier_->record().cross_validated;
    text += tr("<br>The model (crosses): balanced accuracy <b>%1 %</b>, precision %2 %, recall %3 "
               "%, cross-validated on %4 windows.")
                .arg(100.0 * crossed.balancedAccuracy(), 0, 'f', 1)
                .arg(100.0 * crossed.precision(), 0, 'f', 1)
                .arg(100.0 * crossed.recall(), 0, 'f', 1)
                .arg(crossed.buildings() + crossed.others());
  }
  figures_->setText(text);
}

}  // namespace handmap
