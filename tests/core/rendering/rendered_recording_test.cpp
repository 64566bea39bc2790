#include "core/rendering/rendered_recording.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/text.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/rendering/views.h"

namespace handmap {
namespace {

RenderedDrive shortDrive() {
  RenderedDrive drive;
  drive.world = streetWorld(1);
  drive.simulation.step_m = 60.0;
  drive.rendering = test::smallCamera();
  return drive;
}

std::vector<Observation> allOf(ObservationSource& source) {
  std::vector<Observation> all;
  while (auto observation = source.next()) all.push_back(std::move(*observation));
  return all;
}

TEST(RenderedRecording, GivesTheSameFromItsFolderAsWhenItWasRendered) {
  const test::TemporaryFolder folder;
  const auto place = folder.path() / "kept";
  const auto rendered = renderedOnce(shortDrive(), place, {});
  EXPECT_FALSE(fileExists(place)) << "nothing is rendered before it is asked for";
  const std::vector<Observation> first = allOf(*rendered);
  ASSERT_TRUE(fileExists(place));
  const auto replayed = renderedOnce(shortDrive(), place, {});
  EXPECT_EQ(replayed->info().start_odometry, rendered->info().start_odometry);
  EXPECT_EQ(replayed->info().camera->fx, rendered->info().camera->fx);
  const std::vector<Observation> again = allOf(*replayed);
  ASSERT_EQ(again.size(), first.size());
  ASSERT_GE(first.size(), 2U);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(again[i].frame, first[i].frame);
    EXPECT_EQ(again[i].time_s, first[i].time_s);
    EXPECT_EQ(again[i].odometry, first[i].odometry);
    EXPECT_EQ(again[i].standing, first[i].standing);
    ASSERT_EQ(again[i].views.size(), first[i].views.size());
    for (std::size_t v = 0; v < first[i].views.size(); ++v) {
      EXPECT_EQ(again[i].views[v].pan, first[i].views[v].pan);
      EXPECT_EQ(cv::norm(again[i].views[v].left, first[i].views[v].left), 0.0);
      EXPECT_EQ(cv::norm(again[i].views[v].right, first[i].views[v].right), 0.0);
    }
  }
}

TEST(RenderedRecording, WhatWasNotAskedForToItsEndIsNotKept) {
  const test::TemporaryFolder folder;
  const auto place = folder.path() / "kept";
  ASSERT_TRUE(renderedOnce(shortDrive(), place, {})->next());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(RenderedRecording, IsRenderedWhereNothingCanBeKept) {
  const auto source = renderedOnce(shortDrive(), "/proc/none/kept", {});
  EXPECT_TRUE(source->next());
}

TEST(RenderedRecording, EndsWhenAsked) {
  const test::TemporaryFolder folder;
  std::stop_source stop;
  const auto source = renderedOnce(shortDrive(), folder.path() / "kept", stop.get_token());
  ASSERT_TRUE(source->next());
  stop.request_stop();
  EXPECT_FALSE(source->next());
}

}  // namespace
}  // namespace handmap
