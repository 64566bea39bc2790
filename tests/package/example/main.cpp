// A program of somebody else's that uses core: forgets a small world a little, and corrects it.
#include <cstdio>
#include <exception>

#include "core/evaluation/comparison.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

int main() try {
  using namespace handmap;
  const World world = twoRowWorld(1);
  const Map drawing = perturbed(world.map, 3.0, 1);
  RunSession session(drawing, simulate(world, {}, 1), {});
  for (int i = 0; i < 12 && session.step(); ++i) {
  }
  const double before = compareMaps(drawing, world.map, false).mean().front;
  const double after = compareMaps(session.refinedMap(), world.map, false).mean().front;
  std::printf("front walls off by %.2f m, then by %.2f m\n", before, after);
  return after < before ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
