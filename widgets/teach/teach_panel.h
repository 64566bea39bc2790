// Teaching the program what buildings look like: open images, paint windows, train, look, save.
#pragma once

#include <QHash>
#include <QStringList>
#include <QWidget>
#include <memory>

#include "widgets/teach/teach_view.h"
#include "widgets/teach/teach_worker.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace handmap {

class TeachPanel : public QWidget {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(TeachPanel)
 public:
  explicit TeachPanel(QWidget* parent = nullptr);
  ~TeachPanel() override;

  void openImages(const QStringList& paths);
  void train();
  void cancelTraining();
  bool isTraining() const { return worker_ != nullptr; }
  /// Failures are told by messageRaised().
  bool saveModel(const QString& path);
  bool loadModel(const QString& path);

  TeachView& view() { return *view_; }
  /// nullptr before there is one.
  std::shared_ptr<const BuildingClassifier> classifier() const { return classifier_; }
  /// In place of what was taught; nullptr: nothing is taught any more.
  void setModel(std::shared_ptr<const BuildingClassifier> classifier);
  /// Trained, and in no file yet.
  bool isUnsaved() const { return unsaved_; }
  void setSaved() { unsaved_ = false; }
  void setUnsaved() { unsaved_ = classifier_ != nullptr; }

  QSize sizeHint() const override { return {860, 620}; }

 Q_SIGNALS:
  void messageRaised(const QString& message);
  void saveWithMapRequested();
  /// Trained, loaded or taken away (nullptr).
  void classifierChanged(const std::shared_ptr<const handmap::BuildingClassifier>& classifier);

 private:
  void makeFileButtons(QGridLayout& layout);
  QWidget* makeBrushes();
  QWidget* makeTraining();
  void askForImages();
  void askToSave();
  void askToLoad();
  void showImage();
  void keepLabels();
  void showFound();
  void setClassifier(std::shared_ptr<const BuildingClassifier> classifier);
  void trainingEnded();
  void updateState();

  TeachView* view_;
  QListWidget* images_;
  QComboBox* brush_;
  QComboBox* brush_size_;
  QCheckBox* colour_;
  QPushButton* train_;
  QPushButton* save_;
  QPushButton* save_with_map_;
  QProgressBar* progress_;
  QLabel* figures_;
  QHash<QString, std::vector<WindowLabel>> labels_;  ///< by path, of the images that were shown
  QString shown_;                                    ///< path of the image in the view
  cv::Mat image_;                                    ///< that image
  std::shared_ptr<const BuildingClassifier> classifier_;
  bool unsaved_ = false;
  std::unique_ptr<TeachWorker> worker_;
};

}  // namespace handmap
