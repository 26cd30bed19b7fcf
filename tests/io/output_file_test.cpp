#include "io/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/input_file.h"
#include "tests/io/message_of.h"

namespace raceway::io {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("raceway_output_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] long files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

TEST_F(OutputFile, TextIsWrittenAndNothingElseRemains) {
  write_text(path("a.csv"), "x\n1\n", IfExists::refuse);
  EXPECT_EQ(read_text(path("a.csv")), "x\n1\n");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, AnExistingFileIsKeptUnlessForced) {
  write_text(path("a.csv"), "old", IfExists::refuse);
  EXPECT_EQ(message_of([&] { write_text(path("a.csv"), "new", IfExists::refuse); }),
            path("a.csv") + ": exists already; --force replaces it");
  EXPECT_EQ(read_text(path("a.csv")), "old");
  write_text(path("a.csv"), "new", IfExists::replace);
  EXPECT_EQ(read_text(path("a.csv")), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, ReplacingKeepsPermissionsAndLinks) {
  write_text(path("a.csv"), "old", IfExists::refuse);
  fs::permissions(path("a.csv"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.csv", path("link.csv"));
  write_text(path("link.csv"), "new", IfExists::replace);
  EXPECT_TRUE(fs::is_symlink(path("link.csv")));
  EXPECT_EQ(read_text(path("a.csv")), "new");
  EXPECT_EQ(fs::status(path("a.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFile, FoldersAreNoFiles) {
  EXPECT_THAT(message_of([&] { write_text(folder_.string(), "x", IfExists::replace); }),
              HasSubstr("is a directory, a file to write is expected"));
  EXPECT_THAT(message_of([&] { write_text(path("no/a.csv"), "x", IfExists::refuse); }),
              HasSubstr("there is no folder"));
  EXPECT_THAT(message_of([] { write_text("", "x", IfExists::refuse); }), HasSubstr("is empty"));
}

TEST_F(OutputFile, AFolderWithoutPermissionIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(message_of([&] { require_writable(path("a.csv"), IfExists::refuse); }),
              HasSubstr("cannot be written"));
}

TEST_F(OutputFile, AFullDiskLeavesNothingBehind) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  EXPECT_THAT(
      message_of([] { write_text("/dev/full", std::string(100000, 'x'), IfExists::refuse); }),
      HasSubstr("cannot be written"));
  EXPECT_TRUE(fs::exists("/dev/full"));
}

}  // namespace
}  // namespace raceway::io
