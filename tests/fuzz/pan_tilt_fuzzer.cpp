// What a pan-tilt head says, in pieces; the first byte of each tells how long it is and what is
// asked of the head before.
#include <algorithm>

#include "drivers/pan_tilt/ptu_protocol.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest = fuzz::textOf(data, size);
  PtuProtocol protocol;
  protocol.start(0.0);
  for (double now_s = 0.0; !rest.empty(); now_s += 0.3) {
    const auto first = static_cast<unsigned char>(rest.front());
    rest.remove_prefix(1);
    const std::size_t length = std::min<std::size_t>(first & 0x3fU, rest.size());
    if ((first & 0xc0U) == 0x40U) protocol.lookAt({0.1 * double(length) - 3.0, 0.2}, now_s);
    if ((first & 0xc0U) == 0x80U) protocol.halt(now_s);
    protocol.feed(rest.substr(0, length), now_s);
    protocol.tick(now_s);
    rest.remove_prefix(length);
    fuzz::require(protocol.takeOutput().find("DS") == std::string::npos);
    if (const auto arrival = protocol.takeArrival()) {
      fuzz::require(std::abs(arrival->pan) <= 7.0 && std::abs(arrival->tilt) <= 7.0);
    }
  }
  return 0;
}
