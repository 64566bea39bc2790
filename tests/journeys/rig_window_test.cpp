// The dialog that puts a rig together, in the window.
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QTreeWidget>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "app/gui/rig/rig_actions.h"
#include "tests/journeys/window_test.h"
#include "widgets/rig/rig_dialog.h"
#include "widgets/rig/rig_form.h"

namespace handmap {
namespace {

class RigWindow : public WindowTest {
 protected:
  static QString wordsOf(RigDialog& dialog) {
    return dialog.findChild<QLabel*>("rig_words")->text();
  }
  /// Twenty seconds of noise, both images side by side.
  QString noiseVideo() const {
    const QString file = path("noise.avi");
    cv::VideoWriter writer(file.toStdString(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0,
                           {256, 96});
    cv::RNG random(1);
    for (int i = 0; i < 400; ++i) {
      cv::Mat image(96, 256, CV_8UC3);
      random.fill(image, cv::RNG::UNIFORM, 0, 256);
      cv::GaussianBlur(image, image, {}, 3.0);
      writer.write(image);
    }
    return file;
  }
};

TEST_F(RigWindow, TheDialogSaysWhatIsMissing) {
  const auto window = open();
  action(*window, "run.connect")->trigger();
  RigDialog* dialog = window->rigs().dialog();
  ASSERT_TRUE(dialog != nullptr && dialog->isVisible());
  auto* sees = dialog->findChild<QComboBox*>("rig_sees");
  sees->setCurrentIndex(sees->findText("Laser scanner: Hokuyo"));
  dialog->findChild<QComboBox*>("rig_scanner")->setEditText("");
  dialog->findChild<QPushButton*>("rig_use")->click();
  EXPECT_EQ(wordsOf(*dialog), "Choose where the scanner is connected.");
  sees->setCurrentIndex(sees->findText("Two cameras over ROS"));
  dialog->findChild<QPushButton*>("rig_use")->click();
  EXPECT_EQ(wordsOf(*dialog),
            "Enter where the bridge to ROS is: ws://host:9090 or foxglove://host:8765.");
  sees->setCurrentIndex(sees->findText("Stereo camera, both images in one"));
  dialog->findChild<QComboBox*>("rig_camera")->setEditText(" ");
  dialog->findChild<QPushButton*>("rig_use")->click();
  EXPECT_EQ(wordsOf(*dialog), "Choose a camera.");
  EXPECT_TRUE(dialog->isVisible());
  dialog->reject();
}

TEST_F(RigWindow, ARigIsSavedOpenedAndUsed) {
  const auto window = open();
  action(*window, "run.connect")->trigger();
  RigDialog* dialog = window->rigs().dialog();
  Rig rig;
  rig.name = "Cart";
  rig.range_limit_m = 30.0;
  rig.camera = CameraRig{};
  rig.camera->left = "/dev/video7";
  rig.camera->calibration = path("calib.yml").toStdString();
  rig.camera->mount = {0.1, 0.0, 1.25, 0.0, 0.0};
  rig.odometry.kind = OdometryRigKind::Visual;
  dialog->form().setRig(rig);
  ASSERT_TRUE(dialog->save(path("cart.json"))) << wordsOf(*dialog).toStdString();
  EXPECT_EQ(readRig(path("cart.json").toStdString()), rig);
  dialog->form().setRig(Rig{});
  ASSERT_TRUE(dialog->open(path("cart.json")));
  EXPECT_EQ(dialog->form().rig(), rig);
  dialog->findChild<QPushButton*>("rig_use")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->rigs().dialog() == nullptr; }, kPatienceMs));
  EXPECT_TRUE(message(*window).contains("Cart")) << message(*window).toStdString();
  EXPECT_TRUE(action(*window, "run.run")->isEnabled());
}

TEST_F(RigWindow, ARigOverRosIsEnteredAsAnyOther) {
  const auto window = open();
  action(*window, "run.connect")->trigger();
  RigDialog* dialog = window->rigs().dialog();
  Rig rig;
  rig.name = "Rover";
  rig.camera = CameraRig{};
  rig.camera->ros = "ws://rover:9090";
  rig.camera->left = "/left/compressed";
  rig.camera->right = "/right/compressed";
  rig.camera->calibration = path("calib.yml").toStdString();
  rig.odometry.kind = OdometryRigKind::Visual;
  rig.publish = {"ws://rover:9090", 8765, true, {"https://viewer.example"}};
  dialog->form().setRig(rig);
  EXPECT_EQ(dialog->form().rig(), rig);
  rig.camera->calibration.clear();  // the robot tells it
  dialog->form().setRig(rig);
  EXPECT_EQ(dialog->form().rig(), rig);
  dialog->reject();
}

TEST_F(RigWindow, TheDialogOffersWhatGoesTogether) {
  const auto window = open();
  action(*window, "run.connect")->trigger();
  RigDialog* dialog = window->rigs().dialog();
  auto* sees = dialog->findChild<QComboBox*>("rig_sees");
  auto* motion = dialog->findChild<QComboBox*>("rig_odometry");
  auto* version = dialog->findChild<QComboBox*>("rig_ros_version");
  EXPECT_EQ(motion->currentText(), "No wheels: the images");
  EXPECT_FALSE(version->isVisible());
  sees->setCurrentIndex(sees->findText("Laser scanner: Hokuyo"));
  EXPECT_EQ(motion->currentText(), "No wheels: the scans");
  EXPECT_EQ(motion->findText("No wheels: the images"), -1);
  sees->setCurrentIndex(sees->findText("Laser scanner over ROS"));
  EXPECT_TRUE(version->isVisible());
  auto* scanner = dialog->findChild<QComboBox*>("rig_scanner");
  scanner->setEditText("ws://rover:9090");
  motion->setCurrentIndex(motion->findText("Wheels over ROS"));
  EXPECT_EQ(dialog->findChild<QComboBox*>("rig_wheels")->currentText(), "ws://rover:9090");
  version->setCurrentIndex(version->findText("ROS 1"));
  EXPECT_EQ(dialog->form().rig().ros_version, 1);
  EXPECT_EQ(dialog->form().rig().odometry.port, "ws://rover:9090");
  dialog->reject();
}

TEST_F(RigWindow, ARigIsTriedAndLookedAt) {
  const auto window = open();
  action(*window, "run.connect")->trigger();
  RigDialog* dialog = window->rigs().dialog();
  Rig rig;
  rig.name = "Video";
  rig.camera = CameraRig{};
  rig.camera->left = noiseVideo().toStdString();
  rig.camera->calibration = "calib.yml";  // a run would need it
  rig.odometry.kind = OdometryRigKind::Visual;
  dialog->form().setRig(rig);
  auto* trial = dialog->findChild<QPushButton*>("rig_try");
  trial->click();
  const auto devices = [dialog] {
    const auto* tree = dialog->findChild<QTreeWidget*>("live_devices");
    return tree->topLevelItemCount() > 0 ? tree->topLevelItem(0)->text(1) : QString();
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return devices() == "ready"; }, kPatienceMs))
      << devices().toStdString() << wordsOf(*dialog).toStdString();
  trial->click();
  dialog->reject();
}

TEST_F(RigWindow, AFileThatIsNoRigIsAMessage) {
  const auto window = open();
  QFile file(path("no.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{}");
  file.close();
  window->rigs().openRig(file.fileName());
  EXPECT_TRUE(message(*window).contains("no.json")) << message(*window).toStdString();
  EXPECT_FALSE(action(*window, "run.run")->isEnabled());
}

}  // namespace
}  // namespace handmap
