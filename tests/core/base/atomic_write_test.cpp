#include <thread>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/text.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/file_size_limit.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;
using test::expectError;

class AtomicWrite : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }

  /// The names of all there is, also of what is hidden.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  using Names = std::vector<std::string>;
  const test::TemporaryFolder folder_;
};

unsigned permissionsOf(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(stat(path.c_str(), &status), 0);
  return status.st_mode & 07777U;
}

TEST_F(AtomicWrite, ReplacesTheWholeFile) {
  writeFileAtomically(at("file"), "new");
  EXPECT_EQ(folder_.read("file"), "new");
  writeFileAtomically(at("file"), "");
  EXPECT_EQ(folder_.read("file"), "");
  const std::string large(3'000'000, 'x');
  writeFileAtomically(at("file"), large);
  EXPECT_EQ(folder_.read("file"), large);
  EXPECT_EQ(names(), Names{"file"});
}

TEST_F(AtomicWrite, GivesNewFilesTheUsualPermissions) {
  const mode_t before = umask(027);
  writeFileAtomically(at("file"), "new");
  umask(before);
  EXPECT_EQ(permissionsOf(at("file")), 0640U);
}

TEST_F(AtomicWrite, KeepsPermissionsAndOwner) {
  folder_.write("file", "old");
  ASSERT_EQ(chmod(at("file").c_str(), 0604), 0);
  const bool root = geteuid() == 0;
  if (root) {
    ASSERT_EQ(chown(at("file").c_str(), 1234, 2345), 0);
  }
  writeFileAtomically(at("file"), "new");
  EXPECT_EQ(permissionsOf(at("file")), 0604U);
  struct stat status {};
  ASSERT_EQ(stat(at("file").c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, root ? 1234U : geteuid());
  if (root) {
    EXPECT_EQ(status.st_gid, 2345U);
  }
}

TEST_F(AtomicWrite, FollowsLinksAndLeavesThem) {
  folder_.write("deep/file", "old");
  fs::create_symlink("deep/file", at("relative"));
  fs::create_symlink(at("relative"), at("absolute"));
  fs::create_symlink("deep/new", at("dangling"));
  writeFileAtomically(at("absolute"), "new");
  writeFileAtomically(at("dangling"), "made");
  EXPECT_EQ(folder_.read("deep/file"), "new");
  EXPECT_EQ(folder_.read("deep/new"), "made");
  for (const char* link : {"relative", "absolute", "dangling"}) {
    EXPECT_TRUE(fs::is_symlink(at(link))) << link;
  }
  EXPECT_FALSE(fs::is_symlink(at("deep/file")));
  fs::create_symlink("ring", at("ring"));
  expectError(ErrorCode::RunFailed, [&] { writeFileAtomically(at("ring"), "x"); },
              {"ring: cannot be written: "});
}

TEST_F(AtomicWrite, LeavesWhatIsInTheWay) {
  expectError(ErrorCode::RunFailed, [&] { writeFileAtomically(at("no/file"), "x"); },
              {"no/file: cannot be written: No such file"});
  folder_.write("taken/inner", "kept");
  expectError(ErrorCode::RunFailed, [&] { writeFileAtomically(at("taken"), "x"); },
              {"taken: cannot be written: Is a directory"});
  EXPECT_EQ(folder_.read("taken/inner"), "kept");
  EXPECT_EQ(names(), Names{"taken"});
}

TEST_F(AtomicWrite, RefusesAFileThatMayNotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write to any file";
  folder_.write("file", "old");
  ASSERT_EQ(chmod(at("file").c_str(), 0444), 0);
  expectError(ErrorCode::RunFailed, [&] { writeFileAtomically(at("file"), "new"); },
              {"file: cannot be written: Permission denied"});
  EXPECT_EQ(folder_.read("file"), "old");
}

TEST_F(AtomicWrite, WritesIntoPipesAndLeavesThem) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = folder_.read("pipe"); });
  writeFileAtomically(at("pipe"), "bytes");
  reader.join();
  EXPECT_EQ(read, "bytes");
  EXPECT_TRUE(fs::is_fifo(at("pipe")));
  EXPECT_EQ(names(), Names{"pipe"});
}

TEST_F(AtomicWrite, PassesOverWhatAKilledProcessLeft) {
  for (int i = 0; i < 200; ++i) {
    folder_.write(".handmap-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".part", "");
  }
  writeFileAtomically(at("file"), "new");
  EXPECT_EQ(folder_.read("file"), "new");
  EXPECT_EQ(names().size(), 201U);
}

TEST_F(AtomicWrite, LeavesTheOldFileWhenTheNewOneMayNotGrow) {
  folder_.write("file", "old");
  {
    const test::FileSizeLimit limit(65'536);
    expectError(ErrorCode::RunFailed,
                [&] { writeFileAtomically(at("file"), std::string(200'000, 'x')); },
                {"file: cannot be written: File too large"});
  }
  EXPECT_EQ(folder_.read("file"), "old");
  EXPECT_EQ(names(), Names{"file"});
}

TEST_F(AtomicWrite, LeavesTheOldFileOnAFullDisk) {
  if (mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "no small disk can be mounted here";
  }
  folder_.write("file", "old");
  expectError(ErrorCode::RunFailed,
              [&] { writeFileAtomically(at("file"), std::string(200'000, 'x')); },
              {"file: cannot be written: No space left"});
  EXPECT_EQ(folder_.read("file"), "old");
  EXPECT_EQ(names(), Names{"file"});
  writeFileAtomically(at("file"), "small enough");
  EXPECT_EQ(folder_.read("file"), "small enough");
  EXPECT_EQ(umount(folder_.path().c_str()), 0);
}

}  // namespace
}  // namespace handmap
