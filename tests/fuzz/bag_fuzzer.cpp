// Bags of ROS 1 and 2, and the messages in them. The first byte is the kind.
#include <array>
#include <cmath>
#include <fstream>

#include "core/bag_import/bag_facts.h"
#include "core/bags/bag.h"
#include "core/bags/mcap_writer.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

namespace {

void readMessage(const Bag& bag, const BagMessage& message) {
  const BagTopic& topic = bag.topics()[message.topic];
  const FieldReader fields = bag.fieldsOf(message);
  if (ros::isImage(topic)) fuzz::require(!ros::readImage(fields, topic).empty());
  if (!ros::isScan(topic) && !ros::isPointCloud(topic)) return;
  for (const RangePoint& p : ros::readPoints(fields, topic).points) {
    fuzz::require(std::isfinite(p.x + p.y + p.z));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kKinds = {".bag", ".mcap", ".db3"};
  if (size == 0) return 0;
  const auto path = std::filesystem::temp_directory_path() /
                    fmt::format("handmap-fuzz-{}{}", getpid(), kKinds[data[0] % kKinds.size()]);
  std::ofstream(path, std::ios::binary) << fuzz::textOf(data + 1, size - 1);
  const int result = fuzz::takenOrRefused([&] {
    const auto bag = openBag(path);
    std::vector<std::string> notes;
    const BagFacts facts = factsOf(*bag, planOf(*bag, {}), notes, {});
    for (const StampedPose& pose : facts.odometry) fuzz::require(std::isfinite(pose.pose.heading));
    const std::vector<bool> all(bag->topics().size(), true);
    bag->read(all,
              [&](const BagMessage& message) {
                fuzz::takenOrRefused([&] { readMessage(*bag, message); });
              },
              {});
  });
  if (path.extension() == ".mcap") {
    fuzz::takenOrRefused([&] {
      finishMcap(path);
      fuzz::require(!finishMcap(path));
    });
  }
  std::filesystem::remove(path);
  return result;
}
