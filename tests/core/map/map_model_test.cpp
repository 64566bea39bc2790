#include "core/map/map_model.h"

#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

Map mapWith(const std::string& member) {
  return parseMap(R"({"format":"handmap","version":1,"buildings":[])" + member + "}", "a.handmap");
}

TEST(MapModel, IsNamedInTheFileOfTheMap) {
  Map map = mapWith("");
  EXPECT_FALSE(modelOf(map, "maps/yard.handmap"));
  setModel(map, "maps/yard.model.json", "maps/yard.handmap");
  const std::string text = formatMap(map);
  EXPECT_NE(text.find(R"("handmap:model": "yard.model.json")"), std::string::npos) << text;
  const Map read = parseMap(text, "yard.handmap");
  EXPECT_EQ(modelOf(read, "elsewhere/yard.handmap"), fs::path("elsewhere/yard.model.json"));
  EXPECT_EQ(modelOf(read, "yard.handmap"), fs::path("yard.model.json"));
}

TEST(MapModel, IsBesideTheMap) {
  EXPECT_EQ(modelBeside("maps/my.yard.handmap"), fs::path("maps/my.yard.model.json"));
}

TEST(MapModel, ThatIsNoPathIsRefused) {
  for (const char* member : {R"(,"handmap:model":3)", R"(,"handmap:model":"")",
                             R"(,"handmap:model":{"a":1})", R"(,"handmap:model":null)"}) {
    const Map map = mapWith(member);
    test::expectBadInput([&] { modelOf(map, "a.handmap"); }, {"a.handmap", "handmap:model: found"});
  }
}

}  // namespace
}  // namespace handmap
