// Teaching the program what buildings look like: open images, paint windows, train, look, save.
#pragma once

#include <QHash>
#include <QStringList>
#include <QWidget>
#include <memory>

#include "widgets/background/time_left.h"
#include "widgets/teach/teach_view.h"
#include "widgets/teach/teach_worker.h"
#include "widgets/teach/teaching.h"

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
  void setSaved();
  void setUnsaved() { unsaved_ = classifier_ != nullptr; }
  /// Painted since the last training.
  bool isUntrained() const { return strokes_ != trained_strokes_; }
  bool hasUnsavedWork() const { return unsaved_ || isUntrained(); }
  Teaching teaching() const;
  /// Adds images and what was painted on them, as untrained.
  void addTeaching(const Teaching& teaching);

  QSize sizeHint() const override { return {860, 620}; }

 Q_SIGNALS:
  void messageRaised(const QString& message);
  void saveWithMapRequested();
  void teachingChanged();  ///< teaching() or hasUnsavedWork()
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
  TimeLeft left_;  ///< of training
  QLabel* figures_;
  QHash<QString, std::vector<WindowLabel>> labels_;  ///< by path, of the images that were shown
  QString shown_;                                    ///< path of the image in the view
  cv::Mat image_;                                    ///< that image
  std::shared_ptr<const BuildingClassifier> classifier_;
  bool unsaved_ = false;
  int strokes_ = 0;          ///< counts up with whatever is painted
  int trained_strokes_ = 0;  ///< those of the last training
  std::unique_ptr<TeachWorker> worker_;
};

}  // namespace handmap
