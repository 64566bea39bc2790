#include <QApplication>

#include <gtest/gtest.h>

#include "widgets/background/background.h"

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  const QApplication app(argc, argv);
  const int status = RUN_ALL_TESTS();
  // A thread that meets the end of main() would use what is gone.
  return handmap::waitForBackground(std::chrono::seconds(30)) ? status : 1;
}
