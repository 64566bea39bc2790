// The checkerboard wizard, with a video of a board in place of live cameras.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "app/gui/rig/rig_actions.h"
#include "tests/core/calibration/rendered_boards.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/rig/rig_form.h"

namespace handmap {
namespace {

class CalibrationWindow : public WindowTest {
 protected:
  static constexpr double kRate_hz = 4.0;
  static constexpr int kHeld = 8;  // frames

  std::unique_ptr<MainWindow> openAnswered() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    auto window = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window->show();
    return window;
  }
  /// Somebody holds a board before a stereo camera, both images side by side: the first so many
  /// poses, as often as said.
  QString boardVideo(std::size_t count, int times) const {
    const StereoCalibration camera = test::boardCamera();
    const QString file = path("boards.avi");
    cv::VideoWriter writer(file.toStdString(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           kRate_hz, {2 * camera.size.width, camera.size.height});
    auto poses = test::guidedPoses();
    poses.resize(count);
    cv::RNG random(1);
    for (std::size_t shown = 0; shown < poses.size() * static_cast<std::size_t>(times); ++shown) {
      const test::BoardPose& pose = poses[shown % poses.size()];
      cv::Mat both;
      cv::hconcat(test::leftImage(camera, pose), test::rightImage(camera, pose), both);
      for (int i = 0; i < kHeld; ++i) {
        cv::Mat noise(both.size(), CV_16S);
        random.fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
        cv::Mat image;
        cv::add(both, noise, image, cv::noArray(), CV_8U);
        cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        writer.write(image);
      }
    }
    return file;
  }
  template <typename Widget>
  static Widget* child(const CalibrationDialog& dialog, const char* name) {
    return dialog.findChild<Widget*>(name);
  }
  static QString textOf(const CalibrationDialog& dialog, const char* name) {
    return child<QLabel>(dialog, name)->text();
  }

  ScriptedDialogs* dialogs_ = nullptr;  ///< of the window
};

TEST_F(CalibrationWindow, ABoardBeforeTheCamerasBecomesTheCalibrationOfTheRig) {
  const auto window = openAnswered();
  action(*window, "run.connect")->trigger();
  Rig rig;
  rig.name = "Webcam";
  rig.camera = CameraRig{};
  // A slow machine misses poses: it is shown them again.
  constexpr int kPoses = 11;
  rig.camera->left = boardVideo(kPoses, 2).toStdString();
  rig.odometry.kind = OdometryRigKind::Visual;
  window->rigs().dialog()->form().setRig(rig);
  window->rigs().dialog()->findChild<QAbstractButton*>("rig_calibrate")->click();
  CalibrationDialog* dialog = window->rigs().calibration();
  ASSERT_TRUE(dialog != nullptr && dialog->isVisible());
  EXPECT_EQ(child<QComboBox>(*dialog, "calibration_left")->currentText().toStdString(),
            rig.camera->left);
  dialog->findChild<QDoubleSpinBox*>()->setValue(40.0);
  child<QLineEdit>(*dialog, "calibration_keep")->setText(path("kept"));
  auto* start = child<QPushButton>(*dialog, "calibration_start");
  auto* now = child<QPushButton>(*dialog, "calibration_now");
  auto* save = child<QPushButton>(*dialog, "calibration_save");
  start->click();
  const auto taken = [&] {
    return textOf(*dialog, "calibration_verdict").section(' ', 0, 0).toInt();
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return taken() >= kPoses; }, kPatienceMs))
      << textOf(*dialog, "calibration_verdict").toStdString();
  ASSERT_TRUE(now->isEnabled());
  EXPECT_EQ(child<QListWidget>(*dialog, "calibration_needs")->count(), 10);
  EXPECT_TRUE(textOf(*dialog, "calibration_verdict").contains("of 15 pairs"));
  EXPECT_FALSE(save->isEnabled());
  now->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return save->isEnabled(); }, kPatienceMs))
      << textOf(*dialog, "calibration_words").toStdString();
  EXPECT_TRUE(textOf(*dialog, "calibration_verdict").contains("Baseline 0.1"))
      << textOf(*dialog, "calibration_verdict").toStdString();
  EXPECT_TRUE(QFile::exists(path("kept/left/001.png")));

  dialogs_->paths << path("calib.yml");
  save->click();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return window->rigs().calibration() == nullptr; }, kPatienceMs));
  EXPECT_EQ(window->rigs().dialog()->form().rig().camera->calibration,
            path("calib.yml").toStdString());
  const StereoCalibration found = readStereoCalibration(path("calib.yml").toStdString());
  EXPECT_NEAR(cv::norm(found.translation), 0.12, 0.003);
  window->rigs().dialog()->reject();
}

TEST_F(CalibrationWindow, SaysThatAVideoIsAtItsEnd) {
  const auto window = open();
  window->rigs().showCalibration();
  CalibrationDialog* dialog = window->rigs().calibration();
  child<QComboBox>(*dialog, "calibration_left")->setEditText(boardVideo(1, 1));
  child<QPushButton>(*dialog, "calibration_start")->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return textOf(*dialog, "calibration_words").contains("at its end"); }, kPatienceMs))
      << textOf(*dialog, "calibration_verdict").toStdString();
  EXPECT_FALSE(child<QPushButton>(*dialog, "calibration_now")->isEnabled());
  dialog->reject();
}

TEST_F(CalibrationWindow, SaysWhatIsMissingAndWhatCannotBe) {
  const auto window = open();
  window->rigs().showCalibration();
  CalibrationDialog* dialog = window->rigs().calibration();
  auto* start = child<QPushButton>(*dialog, "calibration_start");
  child<QComboBox>(*dialog, "calibration_left")->setEditText(" ");
  start->click();
  EXPECT_EQ(textOf(*dialog, "calibration_words"), "Choose a camera.");
  child<QComboBox>(*dialog, "calibration_left")->setEditText("/none/such.avi");
  const auto sides = dialog->findChildren<QSpinBox*>();
  sides[0]->setValue(sides[1]->value());
  start->click();
  EXPECT_TRUE(textOf(*dialog, "calibration_words").contains("which side is up"));
  sides[0]->setValue(sides[1]->value() + 3);
  start->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return textOf(*dialog, "calibration_words").contains("such.avi: cannot be opened"); },
      kPatienceMs));
  dialog->reject();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return window->rigs().calibration() == nullptr; }, kPatienceMs));
}

}  // namespace
}  // namespace handmap
