#include <QLockFile>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "drivers/device/q_phrase.h"
#include "drivers/emulators/emulated_port.h"
#include "drivers/serial/byte_port.h"
#include "drivers/serial/line_buffer.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::waitUntil;

TEST(PortAddress, AreReadAndWritten) {
  EXPECT_EQ(parsePortAddress("/dev/ttyUSB0", 9600),
            PortAddress(SerialAddress{"/dev/ttyUSB0", 9600}));
  EXPECT_EQ(parsePortAddress("/dev/ttyUSB0@115200", 9600),
            PortAddress(SerialAddress{"/dev/ttyUSB0", 115200}));
  EXPECT_EQ(parsePortAddress("tcp://192.168.0.10:10940", 9600),
            PortAddress(TcpAddress{"192.168.0.10", 10940}));
  EXPECT_EQ(parsePortAddress("tcp://[::1]:80", 9600), PortAddress(TcpAddress{"::1", 80}));
  EXPECT_EQ(parsePortAddress("192.168.0.10", 9600, 10940),
            PortAddress(TcpAddress{"192.168.0.10", 10940}));
  EXPECT_EQ(parsePortAddress("192.168.0.10:4000", 9600, 10940),
            PortAddress(TcpAddress{"192.168.0.10", 4000}));
  EXPECT_EQ(parsePortAddress("laser.local", 9600, 10940),
            PortAddress(TcpAddress{"laser.local", 10940}));
  EXPECT_EQ(parsePortAddress("tcp://[::1]", 9600, 10940), PortAddress(TcpAddress{"::1", 10940}));
  EXPECT_EQ(parsePortAddress("ttyUSB0", 9600, 10940), PortAddress(SerialAddress{"ttyUSB0", 9600}));
  EXPECT_THROW(parsePortAddress("192.168.0.10", 9600), Error) << "no port is usual there";
  for (const char* text : {"/dev/ttyUSB0@9600", "tcp://robot:4000", "tcp://[fe80::1]:4000"}) {
    EXPECT_EQ(formatPortAddress(parsePortAddress(text, 1200)), text);
  }
}

TEST(PortAddress, OthersAreRefusedWithAWord) {
  for (const std::string text :
       {"", "@9600", "/dev/x@", "/dev/x@0", "/dev/x@9600baud", "tcp://", "tcp://host",
        "tcp://host:0", "tcp://host:65536", "tcp://:80", "tcp://a:b:80", "tcp://user@host:80",
        "http://host:80", "/dev/a b", "tcp://[::1:80"}) {
    try {
      parsePortAddress(text, 9600);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadInput);
      EXPECT_NE(std::string(error.what()).find("expected a device"), std::string::npos);
    }
  }
  EXPECT_THROW(parsePortAddress(std::string(100'000, 'a'), 9600), Error);
}

TEST(LineBuffer, LinesComeWholeWhateverThePieces) {
  LineBuffer buffer(10);
  std::vector<std::string> lines;
  for (const char* piece :
       {"on", "e\r", "\ntwo\n\nth", "ree\r\n", "0123456789ab\nnext\n", "rest"}) {
    buffer.feed(piece, [&](std::string_view line) { lines.emplace_back(line); });
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two", "three", "next"}));
  EXPECT_EQ(buffer.dropped(), 1);
}

struct Ends {
  explicit Ends(EmulatedPort::Kind kind)
      : far(kind), near(parsePortAddress(far.address(), 9600), 1) {
    QObject::connect(&far, &EmulatedPort::received, &far,
                     [this](const QByteArray& bytes) { heard_far += bytes; });
    QObject::connect(&near, &BytePort::received, &near,
                     [this](const QByteArray& bytes) { heard_near += bytes; });
    QObject::connect(&near, &BytePort::opened, &near, [this] { ++opened; });
    QObject::connect(&near, &BytePort::lost, &near, [this](const QString& reason) {
      ++lost;
      why = reason.toStdString();
    });
  }
  EmulatedPort far;
  BytePort near;
  QByteArray heard_far;
  QByteArray heard_near;
  int opened = 0;
  int lost = 0;
  std::string why;
};

class BytePortOf : public testing::TestWithParam<EmulatedPort::Kind> {};

TEST_P(BytePortOf, BytesGoBothWaysUnchanged) {
  Ends ends(GetParam());
  ends.near.open();
  ASSERT_TRUE(waitUntil([&] { return ends.opened == 1; }));
  QByteArray all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  ends.near.write({all.constData(), 256});
  ASSERT_TRUE(waitUntil([&] { return ends.heard_far.size() == 256; }));
  ends.far.write({all.constData(), 256});
  ASSERT_TRUE(waitUntil([&] { return ends.heard_near.size() == 256; }));
  EXPECT_EQ(ends.heard_far, all);
  EXPECT_EQ(ends.heard_near, all);
}

TEST_P(BytePortOf, IsOpenedAgainWhenItComesBack) {
  Ends ends(GetParam());
  ends.near.open();
  ASSERT_TRUE(waitUntil([&] { return ends.opened == 1; }));
  ends.near.delivers();
  for (int round = 1; round <= 2; ++round) {
    ends.far.unplug();
    ASSERT_TRUE(waitUntil([&] { return ends.lost >= round; }));
    EXPECT_NE(ends.why.find(ends.far.address()), std::string::npos) << ends.why;
    ends.far.plug();
    ASSERT_TRUE(waitUntil([&] { return ends.near.isOpen() && ends.opened == round + 1; }));
    ends.near.delivers();
  }
  ends.near.write("again");
  EXPECT_TRUE(waitUntil([&] { return ends.heard_far == "again"; }));
}

TEST_P(BytePortOf, WhatIsWrittenLastIsSentBeforeItCloses) {
  Ends ends(GetParam());
  ends.near.open();
  ASSERT_TRUE(waitUntil([&] { return ends.opened == 1; }));
  ends.near.write("bye");
  ends.near.close();
  EXPECT_FALSE(ends.near.isOpen());
  EXPECT_TRUE(waitUntil([&] { return ends.heard_far == "bye"; }));
  EXPECT_EQ(ends.lost, 0);
}

TEST_P(BytePortOf, WhoDoesNotTakeWhatIsSentIsGivenUp) {
  Ends ends(GetParam());
  ends.near.open();
  ASSERT_TRUE(waitUntil([&] { return ends.opened == 1; }));
  const std::string much(4096, 'x');
  for (int i = 0; i < 100 && ends.lost == 0; ++i) ends.near.write(much);  // nobody turns the loop
  EXPECT_EQ(ends.lost, 1);
  EXPECT_NE(ends.why.find("does not take"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BytePortOf,
                         testing::Values(EmulatedPort::Kind::PseudoTerminal,
                                         EmulatedPort::Kind::Tcp));

TEST(BytePort, AReasonIsNeverAnUnknownError) {
  for (const QString& said : {QString(), QStringLiteral("Unknown error")}) {
    EXPECT_EQ(qReason(said), "the other side closed the connection");
  }
  EXPECT_EQ(qReason("Connection refused"), "Connection refused");
}

std::string whyNotOpened(const std::string& path) {
  BytePort port(SerialAddress{path, 9600}, 1);
  std::string why;
  QObject::connect(&port, &BytePort::lost, &port,
                   [&](const QString& reason) { why = reason.toStdString(); });
  port.open();
  EXPECT_TRUE(waitUntil([&] { return !why.empty(); }));
  return why;
}

TEST(BytePort, WhatIsNotThereIsNamed) {
  for (const char* path : {"/dev/no-such-port", "no-such-port"}) {
    EXPECT_EQ(whyNotOpened(path), path + std::string(" is not there: is it plugged in?"));
  }
}

// Another program that looks for the same device holds its lock for a moment.
TEST(BytePort, WhatIsNotThereIsNamedWhoeverLooksForItToo) {
  QLockFile lock(QStringLiteral("/run/lock/LCK..no-such-port-either"));
  if (!lock.tryLock()) GTEST_SKIP() << "no lock can be held in /run/lock";
  EXPECT_EQ(whyNotOpened("/dev/no-such-port-either"),
            "/dev/no-such-port-either is not there: is it plugged in?");
}

}  // namespace
}  // namespace handmap
