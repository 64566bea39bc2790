#include "app/gui/window/application.h"

#include <QTest>
#include <QTimer>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"

namespace handmap {
namespace {

/// What is told of an exception that a slot throws.
template <typename Throw>
QStringList toldOf(Throw throw_it) {
  QStringList told;
  QObject context;
  QObject::connect(
      &Application::instance(), &Application::failed, &context,
      [&told](const QString& message, const QString& hint) { told << message << hint; });
  QTimer::singleShot(0, &context, throw_it);
  QTest::qWait(50);
  return told;
}

TEST(Application, NoExceptionOfASlotEndsTheProgram) {
  const QStringList own =
      toldOf([] { throw Error(ErrorCode::BadInput, "a.handmap: torn", "Mend it."); });
  EXPECT_EQ(own, (QStringList{"a.handmap: torn", "Mend it."}));
  EXPECT_EQ(toldOf([] { throw std::bad_alloc(); }).size(), 2);
  EXPECT_TRUE(
      toldOf([] { CV_Error(cv::Error::StsBadArg, "no image"); }).value(0).contains("no image"));
  EXPECT_TRUE(
      toldOf([] { std::filesystem::create_directory("/gone/below"); }).value(0).contains("/gone"));
  EXPECT_EQ(toldOf([] { throw 7; }).size(), 2);
}

TEST(Application, TheSameAgainIsToldOnce) {
  QStringList told;
  QObject context;
  QObject::connect(&Application::instance(), &Application::failed, &context,
                   [&told](const QString& message) { told << message; });
  for (int i = 0; i < 5; ++i) {
    QTimer::singleShot(0, &context, [] { throw std::runtime_error("painted ever again"); });
  }
  QTest::qWait(50);
  EXPECT_EQ(told.size(), 1);
}

}  // namespace
}  // namespace handmap
