#include <QtEndian>
#include <memory>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "drivers/foxglove/foxglove_server.h"
#include "tests/drivers/devices/foxglove_viewer.h"
#include "tests/drivers/devices/peer.h"

namespace handmap {
namespace {

using test::json;
using test::Peer;
using test::Viewer;
using test::waitUntil;

std::shared_ptr<const Map> oneBuilding() {
  auto map = std::make_shared<Map>();
  map->buildings.resize(1);
  map->buildings[0].id = "Ä\xff";  // no UTF-8: it must not end the program
  map->buildings[0].shape = Rectangle{{10.0, 5.0}, 8.0, 4.0, 0.0};
  return map;
}

void tellMap(FoxgloveServer& server) {
  server.publishAndKeep(FoxgloveTopic::Buildings, [] { return sceneUpdate(5.0, *oneBuilding()); });
}

void tellPose(FoxgloveServer& server, double time_s, const Pose2& pose) {
  server.publish(FoxgloveTopic::Pose, [&] { return poseInFrame(time_s, pose); });
}

TEST(FoxgloveServer, NothingListensUnlessAskedAndThenOnTheLoopback) {
  FoxgloveServer server;
  EXPECT_EQ(server.port(), 0);
  server.listen(0);
  EXPECT_NE(server.port(), 0);
  FoxgloveServer other;
  EXPECT_THROW(other.listen(server.port()), Error);
  const quint16 port = server.port();
  server.close();
  EXPECT_NO_THROW(other.listen(port));
}

class FoxgloveServerOf : public testing::TestWithParam<const char*> {};

TEST_P(FoxgloveServerOf, TellsWhatThereIsAndSendsWhatIsAskedFor) {
  FoxgloveServer server;
  server.listen(0);
  tellMap(server);
  Viewer viewer(server.port(), QString::fromLatin1(GetParam()));
  ASSERT_TRUE(viewer.hears(2));
  EXPECT_EQ(viewer.socket.subprotocol().toStdString(), GetParam());
  EXPECT_EQ(viewer.texts[0]["op"], "serverInfo");
  ASSERT_EQ(viewer.texts[1]["channels"].size(), 7U);
  tellPose(server, 5.0, {0.0, 0.0, 0.0});  // nobody asked for it
  viewer.send({{"op", "subscribe"},
               {"subscriptions",
                json::array({{{"id", 7}, {"channelId", 1}}, {{"id", 8}, {"channelId", 2}}})}});
  ASSERT_TRUE(waitUntil([&] { return viewer.frames.size() == 1; }));
  EXPECT_EQ(qFromLittleEndian<quint32>(viewer.frames[0].constData() + 1), 8U);
  tellPose(server, 1234.5, {1.5, 2.0, 0.0});
  ASSERT_TRUE(waitUntil([&] { return viewer.frames.size() == 2; }));
  EXPECT_EQ(viewer.frames[1][0], 1);
  EXPECT_EQ(qFromLittleEndian<quint32>(viewer.frames[1].constData() + 1), 7U);
  const json pose = json::parse(viewer.frames[1].mid(13).toStdString());
  EXPECT_EQ(pose["pose"]["position"]["x"], 1.5);
  EXPECT_EQ(pose["frame_id"], "map");
  EXPECT_EQ(pose["timestamp"], json({{"sec", 1234}, {"nsec", 500'000'000}}));
  viewer.send({{"op", "unsubscribe"}, {"subscriptionIds", {7}}});
  test::pass(100);
  tellPose(server, 5.0, {3.0, 2.0, 0.0});
  tellMap(server);
  ASSERT_TRUE(waitUntil([&] { return viewer.frames.size() == 3; }));
  EXPECT_EQ(qFromLittleEndian<quint32>(viewer.frames[2].constData() + 1), 8U);
}

INSTANTIATE_TEST_SUITE_P(Protocols, FoxgloveServerOf,
                         testing::Values("foxglove.websocket.v1", "foxglove.sdk.v1"));

TEST(FoxgloveServer, WhatItDoesNotUnderstandIsSaid) {
  FoxgloveServer server;
  server.listen(0);
  Viewer viewer(server.port());
  ASSERT_TRUE(viewer.hears(2));
  const std::vector<std::string> bad = {
      "nonsense",
      "[]",
      R"({"op":"advertise"})",
      R"({"op":"subscribe","subscriptions":5})",
      R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":99}]})",
      R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
      std::string(50'000, '[')};
  for (const std::string& text : bad) viewer.socket.sendTextMessage(QString::fromStdString(text));
  ASSERT_TRUE(viewer.hears(2 + bad.size()));
  for (std::size_t i = 2; i < viewer.texts.size(); ++i) EXPECT_EQ(viewer.texts[i]["op"], "status");
  viewer.socket.sendTextMessage(QString(200'000, QLatin1Char(' ')));
  EXPECT_TRUE(waitUntil([&] { return server.clients() == 0; }));  // too large to be listened to
}

TEST(FoxgloveServer, OthersAreTurnedAwayAndPlacesAreFew) {
  FoxgloveServer server;
  server.listen(0);
  Viewer stranger(server.port(), {});
  std::vector<std::unique_ptr<Viewer>> viewers;
  for (int i = 0; i < 10; ++i) viewers.push_back(std::make_unique<Viewer>(server.port()));
  ASSERT_TRUE(waitUntil([&] { return server.clients() == 8; }));
  test::pass(200);
  EXPECT_EQ(server.clients(), 8);
  EXPECT_TRUE(stranger.texts.empty());
}

TEST(FoxgloveServer, WhoPingsAndDoesNotReadIsLetGo) {
  FoxgloveServer server;
  server.listen(0);
  test::DeafViewer viewer(server.port());
  ASSERT_TRUE(viewer.isLetIn());
  qint64 sent = 0;
  EXPECT_TRUE(waitUntil([&] {
    for (int i = 0; i < 1000 && viewer.socket.bytesToWrite() < 1 << 20; ++i, sent += 131) {
      viewer.ping();
    }
    return server.clients() == 0;
  }));
  EXPECT_LT(sent, 100 << 20) << "bytes of pings, each with its pong";
}

TEST(FoxgloveServer, WhoAnswersNoPingIsLetGoAndWhoDoesStays) {
  FoxgloveServer server({.patience_ms = 500});
  server.listen(0);
  Viewer viewer(server.port());
  std::vector<std::unique_ptr<test::DeafViewer>> deaf;
  for (int i = 0; i < 3; ++i) deaf.push_back(std::make_unique<test::DeafViewer>(server.port()));
  ASSERT_TRUE(waitUntil([&] { return server.clients() == 4; }));
  EXPECT_TRUE(waitUntil([&] { return server.clients() == 1; }));
  EXPECT_EQ(viewer.socket.state(), QAbstractSocket::ConnectedState);
}

TEST(FoxgloveServer, WhoLooksAtNothingMakesWay) {
  FoxgloveServer server;
  server.listen(0);
  const auto subscribed = [&](Viewer& viewer) {
    if (!viewer.hears(2)) return false;
    viewer.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 8}, {"channelId", 2}}}}});
    return waitUntil([&] { return !viewer.frames.empty(); });
  };
  tellMap(server);
  std::vector<std::unique_ptr<Viewer>> idle;
  for (int i = 0; i < 8; ++i) idle.push_back(std::make_unique<Viewer>(server.port()));
  ASSERT_TRUE(waitUntil([&] { return server.clients() == 8; }));
  std::vector<std::unique_ptr<Viewer>> looking;
  for (int i = 0; i < 8; ++i) {
    looking.push_back(std::make_unique<Viewer>(server.port()));
    ASSERT_TRUE(subscribed(*looking.back())) << i;
  }
  EXPECT_EQ(server.clients(), 8);
  Viewer late(server.port());
  EXPECT_TRUE(waitUntil([&] { return late.socket.closeCode() == 1008; })) << "all places are used";
  for (const auto& viewer : looking) {
    EXPECT_EQ(viewer->socket.state(), QAbstractSocket::ConnectedState);
  }
}

TEST(FoxgloveServer, ForeignWebPagesAreTurnedAwayUnlessAllowed) {
  FoxgloveServer server({.origins = {"https://viewer.example"}});
  QString turned_away;
  QObject::connect(&server, &FoxgloveServer::turnedAway, &server,
                   [&](const QString& origin) { turned_away = origin; });
  server.listen(0);
  for (const char* origin :
       {"", "file://", "http://localhost:8080", "http://127.0.0.1", "https://[::1]:3000",
        "https://app.foxglove.dev", "https://viewer.example"}) {
    test::DeafViewer viewer(server.port(), origin);
    EXPECT_TRUE(viewer.isLetIn()) << origin;
  }
  EXPECT_TRUE(turned_away.isEmpty()) << turned_away.toStdString();
  for (const char* origin :
       {"null", "https://evil.example", "https://app.foxglove.dev.evil.example",
        "http://localhost.evil.example", "https://viewer.example:444", "http://viewer.example"}) {
    test::DeafViewer viewer(server.port(), origin);
    EXPECT_FALSE(viewer.isLetIn()) << origin;
    EXPECT_EQ(turned_away.toStdString(), origin);
  }
}

TEST(FoxglovePeer, FoxglovesOwnClientUnderstandsPoseAndMap) {
  const std::string missing = Peer::missing(QStringLiteral("@foxglove/ws-protocol"));
  if (!missing.empty()) GTEST_SKIP() << missing;
  for (const char* protocol : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    FoxgloveServer server;
    server.listen(0);
    tellMap(server);
    Peer peer(
        QStringLiteral("foxglove_peer.mjs"),
        {QStringLiteral("ws://127.0.0.1:%1").arg(server.port()), QString::fromLatin1(protocol)});
    EXPECT_TRUE(peer.says("SERVER Handmap")) << peer.said;
    EXPECT_TRUE(peer.says("CHANNEL foxglove.PoseInFrame foxglove.PoseInFrame json")) << peer.said;
    EXPECT_TRUE(peer.says("CHANNEL foxglove.SceneUpdate foxglove.SceneUpdate json")) << peer.said;
    EXPECT_TRUE(peer.says("MAP 1 5")) << peer.said;
    tellPose(server, 5.0, {-3.25, 0.0, 0.0});
    EXPECT_TRUE(peer.says("POSE -3.25 true")) << peer.said;
  }
}

}  // namespace
}  // namespace handmap
