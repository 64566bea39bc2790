#include "drivers/scanner/rplidar_protocol.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

using namespace rplidar;

// As SLAMTEC's description of the protocol prints them.
TEST(Rplidar, RequestsAreAsDescribed) {
  EXPECT_EQ(request(Request::Stop), "\xA5\x25");
  EXPECT_EQ(request(Request::ExpressScan, std::string(5, '\0')),
            std::string("\xA5\x82\x05\0\0\0\0\0\x22", 9));
}

TEST(Rplidar, ANodeIsReadAndItsCheckBitsAreLookedAt) {
  // 90° and 1 m: 90·64 = 5760, 1000·4 = 4000.
  const std::array<std::uint8_t, 5> node = {0x3e, 0x01, 0x2d, 0xa0, 0x0f};
  const auto measurement = parseNode(node);
  ASSERT_TRUE(measurement);
  EXPECT_NEAR(measurement->angle_rad, kPi / 2.0, 1e-9);
  EXPECT_NEAR(measurement->range_m, 1.0, 1e-9);
  EXPECT_FALSE(measurement->begins_turn);
  for (const unsigned bit : {0U, 1U}) {
    auto bad = node;
    bad[0] = static_cast<std::uint8_t>(bad[0] ^ (1U << bit));
    EXPECT_FALSE(parseNode(bad));
  }
  auto bad = node;
  bad[1] = 0;
  EXPECT_FALSE(parseNode(bad));
}

std::array<std::uint8_t, 84> capsuleAt(double angle_deg, std::uint8_t fill) {
  std::array<std::uint8_t, 84> bytes{};
  const auto start = static_cast<unsigned>(angle_deg * 64.0);
  bytes[2] = static_cast<std::uint8_t>(start & 0xffU);
  bytes[3] = static_cast<std::uint8_t>(start >> 8U);
  std::fill(bytes.begin() + 4, bytes.end(), fill);
  unsigned sum = 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) sum ^= bytes[i];
  bytes[0] = static_cast<std::uint8_t>(0xa0U | (sum & 0xfU));
  bytes[1] = static_cast<std::uint8_t>(0x50U | sum >> 4U);
  return bytes;
}

TEST(Rplidar, EveryBitOfACapsuleIsChecked) {
  const auto good = capsuleAt(350.0, 0x40);
  ASSERT_TRUE(parseCapsule(good));
  for (std::size_t bit = 0; bit < 84 * 8; ++bit) {
    auto bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << bit % 8));
    EXPECT_FALSE(parseCapsule(bad)) << bit;
  }
}

TEST(Rplidar, CapsulesAreSpreadOverTheWayToTheNext) {
  const auto first = parseCapsule(capsuleAt(350.0, 0x40));
  const auto next = parseCapsule(capsuleAt(6.0, 0x40));
  for (const auto& [kind, count] :
       {std::pair(Answer::Dense, 40U), std::pair(Answer::Capsule, 32U)}) {
    const auto all = expand(*first, *next, kind);
    ASSERT_EQ(all.size(), count);
    EXPECT_NEAR(all[0].angle_rad, toRadians(350.0), 1e-6);
    EXPECT_NEAR(all[count / 2].angle_rad, toRadians(358.0), 1e-6);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](auto& m) { return m.begins_turn; }), 1);
    // 0x4040 is 16.448 m of whole millimetres, and 4112 mm where the two lowest bits are angle.
    EXPECT_NEAR(all[0].range_m, kind == Answer::Dense ? 16.448 : 4.112, 1e-9);
  }
}

TEST(Rplidar, AnswersAreFoundAmongNoiseAndInPieces) {
  RplidarReader reader;
  const std::string stream =
      "RP LIDAR System.\r\n\xA5\x5A\xff\xA5" + std::string("\xA5\x5A\x14\0\0\0\x04", 7) + "\x18" +
      std::string(19, 'i') + std::string("\xA5\x5A\x03\0\0\0\x06\x02\0\0", 10);
  std::optional<std::string> info;
  std::optional<std::uint8_t> health;
  for (const char byte : stream) {
    const auto events = reader.feed({&byte, 1});
    if (events.info) info = events.info;
    if (events.health) health = events.health;
  }
  ASSERT_TRUE(info && health);
  EXPECT_EQ(info->front(), '\x18');
  EXPECT_EQ(*health, 2);
}

TEST(Rplidar, AnAnswerThatComesOnceIsNoStream) {
  for (const auto* begins : {"\xA5\x5A\x03\0\0\x40\x06", "\xA5\x5A\x14\0\0\x40\x04"}) {
    RplidarReader reader;
    reader.feed(std::string(begins, 7));
    const auto events = reader.feed(std::string(3, '\xA5') + std::string(40, 'i'));
    EXPECT_TRUE(events.measurements.empty());
    EXPECT_FALSE(events.info || events.health);
  }
}

TEST(Rplidar, AfterALostByteTheCapsulesAreFoundAgain) {
  RplidarReader reader;
  reader.feed(std::string("\xA5\x5A\x54\0\0\x40\x85", 7));
  std::size_t measurements = 0;
  for (int i = 0; i < 20; ++i) {
    const auto capsule = capsuleAt(10.0 * i, 0x20);
    std::string bytes(capsule.begin(), capsule.end());
    if (i == 10) bytes.erase(40, 1);
    measurements += reader.feed(bytes).measurements.size();
  }
  EXPECT_EQ(measurements, 40U * (19 - 2));
  EXPECT_GE(reader.damaged(), 1);
}

TEST(Rplidar, TurnsAreWhole) {
  RplidarTurns turns;
  int told = 0;
  for (int i = 0; i < 1000; ++i) {
    const double angle = std::fmod(1.0 + i * 2.0 * kPi / 200.0, 2.0 * kPi);
    const auto turn = turns.add({angle, i % 2 == 0 ? 2.0 : 0.0, false});
    if (!turn) continue;
    ++told;
    EXPECT_EQ(turn->size(), 100U);
  }
  EXPECT_EQ(told, 4);
}

TEST(Rplidar, NoiseIsNoMeasurementsForEver) {
  RandomStream random(5);
  RplidarReader reader;
  RplidarTurns turns;
  reader.feed(std::string("\xA5\x5A\x05\0\0\x40\x81", 7));
  for (int i = 0; i < 1000; ++i) {
    std::string noise(1000, '\0');
    for (char& byte : noise) byte = static_cast<char>(random());
    for (const auto& measurement : reader.feed(noise).measurements) {
      EXPECT_GE(measurement.angle_rad, 0.0);
      EXPECT_LT(measurement.angle_rad, 2.0 * kPi);
      turns.add(measurement);
    }
  }
}

}  // namespace
}  // namespace handmap
