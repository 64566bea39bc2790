// The pictures of the guide, made by the program itself: the same scenes, the same size, light.
#pragma once

#include <QObject>
#include <QString>

namespace handmap {

class MainWindow;

class GuidePictures : public QObject {
  Q_OBJECT
 public:
  /// Makes them in `folder` and leaves the application with the exit status: 0, or 3 where one
  /// could not be made. The window must outlive this object.
  GuidePictures(MainWindow& window, QString folder);

  static QStringList names();

 private:
  void begin();
  void drawBuilding();
  void onPaused();
  void finishRun();
  void makeOthers();
  void keep(QWidget& widget, const char* name);
  void keepPanel(QWidget& panel, const char* name);

  MainWindow& window_;
  QString folder_;
};

}  // namespace handmap
