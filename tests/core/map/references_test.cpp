#include "core/map/references.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/map/map_io.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;
using test::expectBadInput;

/// drawings/yard.handmap with a picture and a folder beside it, and a secret outside.
class References : public testing::Test {
 protected:
  References() {
    folder_.write("drawings/aerial.png", "picture");
    folder_.write("drawings/more/plan.png", "picture");
    folder_.write("secret.png", "picture");
  }

  bool inside(const fs::path& path) const { return staysInside({"key", path}, map_file_); }
  void check(const fs::path& path, Outside outside) const {
    checkReference({"handmap:model", path}, map_file_, outside);
  }

  const test::TemporaryFolder folder_;
  const fs::path map_file_ = folder_.path() / "drawings" / "yard.handmap";
};

TEST_F(References, OfPicturesAndModelAreListed) {
  Map map = parseMap(R"({"format":"handmap","version":1,"buildings":[],
                         "underlays":[{"image":"a.png","x":0,"y":0,"metres_per_pixel":1},
                                      {"image":"../b.png","x":0,"y":0,"metres_per_pixel":1}],
                         "handmap:model":"yard.model.json"})",
                     "yard.handmap");
  const auto references = referencesOf(map, map_file_);
  ASSERT_EQ(references.size(), 3U);
  EXPECT_EQ(references[1].key, "underlays[1].image");
  EXPECT_EQ(references[1].path, "../b.png");
  EXPECT_EQ(references[2].key, "handmap:model");
  EXPECT_EQ(targetOf(references[2], map_file_), folder_.path() / "drawings/yard.model.json");
  expectBadInput([&] { checkReferences(map, map_file_); },
                 {"yard.handmap: underlays[1].image: found \"../b.png\", outside of the folder"});
  EXPECT_NO_THROW(checkReferences(map, map_file_, Outside::Allowed));
  map.model.clear();
  map.unknown[kModelKey] = "3";
  expectBadInput([&] { referencesOf(map, map_file_); }, {"yard.handmap: handmap:model: found 3"});
}

TEST_F(References, StayInTheFolder) {
  for (const char* path : {"aerial.png", "./more/plan.png", "more/../aerial.png", "not-yet.png",
                           "not/yet/there.png", "..png"}) {
    EXPECT_TRUE(inside(path)) << path;
  }
  EXPECT_TRUE(inside(folder_.path() / "drawings" / "aerial.png"));
}

TEST_F(References, LeaveTheFolder) {
  for (const char* path : {"../secret.png", "more/../../secret.png", "/etc/passwd", "..", ".", "",
                           "nowhere/../../secret.png", "../drawings-too/aerial.png"}) {
    EXPECT_FALSE(inside(path)) << path;
  }
}

TEST_F(References, AreFollowedThroughLinks) {
  const fs::path drawings = folder_.path() / "drawings";
  fs::create_symlink("../secret.png", drawings / "harmless.png");
  fs::create_directory_symlink("..", drawings / "up");
  fs::create_symlink("more/plan.png", drawings / "plan.png");
  fs::create_symlink("ring.png", drawings / "ring.png");
  EXPECT_FALSE(inside("harmless.png"));
  EXPECT_FALSE(inside("up/secret.png"));
  EXPECT_FALSE(inside("up/not-there.png"));
  EXPECT_FALSE(inside("ring.png"));
  EXPECT_TRUE(inside("plan.png"));
  EXPECT_TRUE(inside("up/drawings/aerial.png"));
  // The folder of the map may be reached by a link.
  fs::create_directory_symlink("drawings", folder_.path() / "linked");
  const fs::path by_link = folder_.path() / "linked" / "yard.handmap";
  EXPECT_TRUE(staysInside({"key", "aerial.png"}, by_link));
  EXPECT_FALSE(staysInside({"key", "../secret.png"}, by_link));
}

TEST_F(References, AreSeenFromTheWorkingFolder) {
  EXPECT_TRUE(staysInside({"key", "aerial.png"}, "yard.handmap"));
  EXPECT_FALSE(staysInside({"key", "../aerial.png"}, "yard.handmap"));
}

TEST_F(References, OutsideAreRefusedUnlessAllowed) {
  expectBadInput([&] { check("../secret.png", Outside::Refused); },
                 {"yard.handmap: handmap:model: found \"../secret.png\", outside of the folder of "
                  "the map, expected a file in that folder",
                  "allow what lies outside"});
  EXPECT_NO_THROW(check("../secret.png", Outside::Allowed));
  EXPECT_NO_THROW(check("aerial.png", Outside::Refused));
  EXPECT_NO_THROW(check("not-yet.png", Outside::Refused));
}

TEST_F(References, ToWhatIsNoRegularFileAreRefused) {
  const fs::path pipe = folder_.path() / "drawings" / "pipe.png";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const char* path : {"pipe.png", "more"}) {
    expectBadInput([&] { check(path, Outside::Refused); }, {"handmap:model", "no regular file"});
  }
  expectBadInput([&] { check("/dev/zero", Outside::Allowed); }, {"no regular file"});
  expectBadInput([&] { check(std::string("aerial.png\0.txt", 15), Outside::Allowed); },
                 {"handmap:model", "the path of a file"});
}

fs::path modelTarget(const Map& map, const fs::path& map_file) {
  return targetOf(modelReference(map, map_file).value(), map_file);
}

Map mapNaming(const std::string& image, const std::string& model) {
  Map map;
  map.underlays.push_back({image, 0, 0, 0.2, 0, 1, {}});
  map.model = model;
  return map;
}

TEST(MovedReferences, LeadToTheSameFiles) {
  Map map = mapNaming("aerial.jpg", "yard.model.json");
  moveReferences(map, "maps/yard.handmap", "out/new/yard.handmap");
  EXPECT_EQ(map.underlays[0].image, "../../maps/aerial.jpg");
  EXPECT_EQ(modelTarget(map, "out/new/yard.handmap").lexically_normal(),
            fs::path("maps/yard.model.json"));
  const Map before = map;
  moveReferences(map, "out/new/yard.handmap", "out/new/other.handmap");
  EXPECT_EQ(map, before);
}

TEST(MovedReferences, OfAMapThatWasNeverSavedStay) {
  Map map = mapNaming("aerial.jpg", "yard.model.json");
  const Map before = map;
  moveReferences(map, "", "out/yard.handmap");
  EXPECT_EQ(map, before);
}

TEST(MovedReferences, ThatAreAbsoluteOrNoPathsStay) {
  for (const char* model : {"/models/yard.json", ""}) {
    Map map = mapNaming("/pictures/aerial.jpg", model);
    const Map before = map;
    moveReferences(map, "a.handmap", "b/a.handmap");
    EXPECT_EQ(map, before);
  }
}

Map mapWith(const std::string& member) {
  return parseMap(R"({"format":"handmap","version":1,"buildings":[])" + member + "}", "a.handmap");
}

TEST(ModelReference, IsNamedInTheFileOfTheMap) {
  Map map = mapWith("");
  EXPECT_FALSE(modelReference(map, "maps/yard.handmap"));
  map.model = referenceFrom("maps/yard.handmap", "maps/yard.model.json");
  const std::string text = formatMap(map);
  EXPECT_NE(text.find(R"("handmap:model": "yard.model.json")"), std::string::npos) << text;
  const Map read = parseMap(text, "yard.handmap");
  EXPECT_EQ(modelTarget(read, "elsewhere/yard.handmap"), fs::path("elsewhere/yard.model.json"));
  EXPECT_EQ(modelTarget(read, "yard.handmap"), fs::path("yard.model.json"));
}

TEST(ModelReference, ModelsAreBesideTheMap) {
  EXPECT_EQ(modelBeside("maps/my.yard.handmap"), fs::path("maps/my.yard.model.json"));
}

TEST(ModelReference, ThatIsNoPathIsRefused) {
  for (const char* member : {R"(,"handmap:model":3)", R"(,"handmap:model":"")",
                             R"(,"handmap:model":{"a":1})", R"(,"handmap:model":null)"}) {
    const Map map = mapWith(member);
    expectBadInput([&] { modelReference(map, "a.handmap"); },
                   {"a.handmap", "handmap:model: found"});
  }
}

}  // namespace
}  // namespace handmap
