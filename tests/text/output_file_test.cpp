#include "text/output_file.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/support/message_of.h"
#include "text/error.h"
#include "text/input_file.h"

namespace raceway::text {
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
  EXPECT_EQ(tests::message_of([&] { write_text(path("a.csv"), "new", IfExists::refuse); }),
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
  EXPECT_THAT(tests::message_of([&] { write_text(folder_.string(), "x", IfExists::replace); }),
              HasSubstr(": is a directory; name a file"));
  EXPECT_THAT(tests::message_of([&] { write_text(path("no/a.csv"), "x", IfExists::refuse); }),
              HasSubstr(": cannot be written: this folder does not exist:"));
  EXPECT_THAT(tests::message_of([] { write_text("", "x", IfExists::refuse); }),
              HasSubstr("is empty"));
}

TEST_F(OutputFile, AFolderWithoutPermissionIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(tests::message_of([&] { require_writable(path("a.csv"), IfExists::refuse); }),
              HasSubstr("cannot be written"));
}

TEST_F(OutputFile, AFullDiskLeavesNothingBehind) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  EXPECT_THAT(tests::message_of(
                  [] { write_text("/dev/full", std::string(100000, 'x'), IfExists::refuse); }),
              HasSubstr("cannot be written"));
  EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(OutputFile, WhatAKilledWriterLeftBlocksNoOther) {
  // In a container the next run may well have its number.
  const std::string own = ".raceway-" + std::to_string(::getpid());
  for (const std::string& name :
       {own + "-0.part", own + "-1.part", ".a.csv." + std::to_string(::getpid()) + ".part"})
    std::ofstream(path(name)) << "half";
  write_text(path("a.csv"), "whole", IfExists::refuse);
  EXPECT_EQ(read_text(path("a.csv")), "whole");
  EXPECT_EQ(read_text(path(own + "-0.part")), "half");
  EXPECT_EQ(files(), 4);
}

TEST_F(OutputFile, OfTwoWritersWithoutForceOneIsTold) {
  constexpr int writers = 8;
  for (int round = 0; round < 20; ++round) {
    std::vector<pid_t> children;
    for (int k = 0; k < writers; ++k) {
      const pid_t child = ::fork();
      if (child == 0) {
        try {
          write_text(path("a.csv"), std::string(300'000, static_cast<char>('a' + k)),
                     IfExists::refuse);
        } catch (const InputError&) {
          ::_exit(1);
        }
        ::_exit(0);
      }
      children.push_back(child);
    }
    int written = 0, winner = -1;
    for (int k = 0; k < writers; ++k) {
      int status = 0;
      ::waitpid(children[static_cast<std::size_t>(k)], &status, 0);
      if (status != 0) continue;
      ++written;
      winner = k;
    }
    ASSERT_EQ(written, 1);
    EXPECT_EQ(read_text(path("a.csv")), std::string(300'000, static_cast<char>('a' + winner)));
    EXPECT_EQ(files(), 1);
    fs::remove(path("a.csv"));
  }
}

TEST_F(OutputFile, OneThatIsStoppedLeavesNoPart) {
  const std::string file = path("stopped.csv");
  for (int k = 0; k < 10; ++k) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::thread([&] {
        write_text(file, std::string(50'000'000, 'x'), IfExists::replace);
      }).detach();
      std::this_thread::sleep_for(std::chrono::milliseconds(4 * k));
      const std::vector<std::string> written = stop_writing();
      ::_exit(written.empty() || written.back() != file ? 1 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const bool whole = fs::exists(file);
    EXPECT_EQ(WEXITSTATUS(status), whole ? 0 : 1);
    EXPECT_EQ(files(), whole ? 1 : 0);
    fs::remove(file);
  }
}

TEST_F(OutputFile, OfTwoRunsOneHasWrittenAllOfASet) {
  constexpr int writers = 6;
  for (int round = 0; round < 40; ++round) {
    std::vector<pid_t> children;
    for (int k = 0; k < writers; ++k) {
      const pid_t child = ::fork();
      if (child == 0) {
        const std::string text(20'000, static_cast<char>('a' + k));
        write_files({{path("1"), text}, {path("2"), text}, {path("3"), text}}, IfExists::replace);
        ::_exit(0);
      }
      children.push_back(child);
    }
    for (const pid_t child : children) ::waitpid(child, nullptr, 0);
    EXPECT_EQ(read_text(path("1")), read_text(path("2")));
    EXPECT_EQ(read_text(path("1")), read_text(path("3")));
    EXPECT_EQ(files(), 3);
  }
}

TEST_F(OutputFile, ANameOfAnotherFormatIsRefused) {
  const auto refusal = [&](const std::string& name) {
    return tests::message_of([&] { require_writable(path(name), IfExists::refuse); });
  };
  EXPECT_THAT(refusal("st.xlsx"),
              HasSubstr("st.xlsx: this is the name of a workbook, but tables are written as CSV, "
                        "which Excel can open: use a name that ends with .csv"));
  EXPECT_THAT(refusal("st.PNG"), HasSubstr("pictures are written as SVG and pages as HTML"));
  EXPECT_THAT(refusal("st.mat"), HasSubstr("a binary file"));
  EXPECT_THAT(tests::message_of([&] { write_text(path("a.xls"), "1", IfExists::replace); }),
              HasSubstr("a workbook"));
  for (const char* name : {"st.csv", "st.svg", "st", "st.mo", "xlsx", "st.xlsx.csv"})
    require_writable(path(name), IfExists::refuse);
  EXPECT_EQ(files(), 0);
}

// A table in st.json and a picture in st.html were "written".
TEST_F(OutputFile, ANameOfAnotherOfOurFormatsIsRefused) {
  const auto refusal = [](const char* name, Written what) {
    return tests::message_of([&] { require_name_of(name, what); });
  };
  EXPECT_THAT(refusal("st.json", Written::table), HasSubstr("st.json: tables are written as CSV"));
  EXPECT_THAT(refusal("st.HTML", Written::picture),
              HasSubstr("as SVG; use a name that ends with .svg"));
  EXPECT_THAT(refusal("st.svg", Written::page),
              HasSubstr("as HTML; use a name that ends with .html"));
  for (const char* name : {"st.csv", "st", "st.txt", "st.mo", "st.2"})
    require_name_of(name, Written::table);
  require_name_of("st.svg", Written::picture);
  require_name_of("st.htm", Written::page);
}

TEST_F(OutputFile, WhereOneOfASetCannotBeWrittenNoneIs) {
  write_text(path("2"), "old", IfExists::refuse);
  EXPECT_THAT(tests::message_of([&] {
                write_files({{path("1"), "new"}, {path("2"), "new"}}, IfExists::refuse);
              }),
              HasSubstr("2: exists already"));
  EXPECT_EQ(files(), 1);
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  const std::string much(100'000, 'x');
  EXPECT_THAT(tests::message_of([&] {
                write_files({{path("2"), much}, {"/dev/full", much}}, IfExists::replace);
              }),
              HasSubstr("cannot be written"));
  EXPECT_EQ(read_text(path("2")), "old");
}

}  // namespace
}  // namespace raceway::text
