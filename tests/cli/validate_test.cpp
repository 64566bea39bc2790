#include <fstream>

#include "tests/cli/program.h"

namespace handmap {
namespace {

using Validate = CliTest;

TEST_F(Validate, NotesLikelySlipsOfADrawingThatIsWhole) {
  std::ofstream("yard.handmap") << R"({"format": "handmap", "version": 1, "buildings": [
      {"id": "A", "shape": "rectangle", "x": 0, "y": 0, "width": 10, "depth": 8, "heading_deg": 0},
      {"id": "B", "shape": "rectangle", "x": 7, "y": 0, "width": 10, "depth": 8, "heading_deg": 0}]})";
  const Outcome outcome = run({"validate", "yard.handmap"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "ok: yard.handmap: map of 2 buildings\n");
  EXPECT_EQ(outcome.err,
            "handmap-cli: note: yard.handmap: there is no start: a run needs to know where the "
            "robot begins\n"
            "handmap-cli: note: yard.handmap: A and B overlap by 24.0 m²\n");
}

}  // namespace
}  // namespace handmap
