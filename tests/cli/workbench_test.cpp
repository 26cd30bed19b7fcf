// `raceway workbench`: the page beside an installed program, with a model and records inside.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_program.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// The program as it is installed: bin/raceway, beside which share/raceway holds a page.
class Workbench : public testing::Test {
 protected:
  Workbench() {
    fs::create_directories(scratch_.file("bin"));
    fs::create_directories(scratch_.file("share/raceway"));
    fs::copy_file(tests::program(), scratch_.file("bin/raceway"));
    scratch_.write("share/raceway/workbench.html", "<p>engine</p><!--@LOADED@--><p>end</p>");
  }
  [[nodiscard]] Result workbench(const std::string& arguments) const {
    return run_shell("cd " + scratch_.path().string() + " && bin/raceway workbench " + arguments);
  }
  /// What the page opens with.
  [[nodiscard]] json loaded(const std::string& page) const {
    const std::string text = file_text(scratch_.file(page));
    const std::string begin = "<script type=\"application/json\" id=\"loaded\">";
    const std::size_t at = text.find(begin), end = text.find("</script><p>end</p>");
    if (at == text.npos || end == text.npos) return {};
    return json::parse(text.substr(at + begin.size(), end - at - begin.size()));
  }
  const ScratchFolder scratch_;
};

TEST_F(Workbench, WritesThePageWithModelRecordsAndMap) {
  scratch_.write("my.toml", model_text);
  scratch_.write("rig.csv", data_text);
  scratch_.write("map.toml", "[columns]\n");
  const Result r = workbench("my.toml rig.csv rig.csv --columns map.toml -o page.html");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("page.html written"));
  const json data = {{"name", "rig.csv"}, {"text", data_text}};
  EXPECT_EQ(loaded("page.html"), (json{{"model", {{"name", "my.toml"}, {"text", model_text}}},
                                       {"data", {data, data}},
                                       {"map", "[columns]\n"}}));
}

TEST_F(Workbench, NeedsNoFilesAndReplacesNoPage) {
  EXPECT_EQ(workbench("").status, 0);
  EXPECT_EQ(loaded("raceway-workbench.html"), (json{{"data", json::array()}}));
  const Result again = workbench("");
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("raceway-workbench.html: exists already"));
  EXPECT_EQ(workbench("--force").status, 0);
}

TEST_F(Workbench, NothingInAFileEndsTheScript) {
  scratch_.write("rig.csv", "a\n</script><script>alert(1)</script><!--\n");
  ASSERT_EQ(workbench("rig.csv -o page.html").status, 0);
  const std::string page = file_text(scratch_.file("page.html"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(loaded("page.html")["data"][0]["text"], "a\n</script><script>alert(1)</script><!--\n");
}

TEST_F(Workbench, FilesInOtherEncodingsOpenAsText) {
  scratch_.write("rig.csv",
                 "temperature_\xb0"
                 "C\n20\n");
  ASSERT_EQ(workbench("rig.csv -o page.html").status, 0);
  EXPECT_EQ(loaded("page.html")["data"][0]["text"], "temperature_°C\n20\n");
}

TEST_F(Workbench, SaysWhatItCannotOpen) {
  scratch_.write("a.toml", model_text);
  scratch_.write("b.toml", model_text);
  const Result two = workbench("a.toml b.toml");
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.err,
              HasSubstr(": the page can open only one model; name one file that ends with .toml"));
  const Result none = workbench("none.csv");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("none.csv: no such file"));
  EXPECT_FALSE(fs::exists(scratch_.file("raceway-workbench.html")));
}

TEST_F(Workbench, SaysThatThereIsNoPage) {
  scratch_.write("share/raceway/workbench.html", "an older page");
  const Result old = workbench("");
  EXPECT_EQ(old.status, 1);
  EXPECT_THAT(old.err, HasSubstr("is not a workbench page of this version"));
  fs::remove(scratch_.file("share/raceway/workbench.html"));
  const Result none = workbench("");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("raceway workbench: this installation has no workbench page "
                                  "(share/raceway/workbench.html); build the page with cmake "
                                  "--preset wasm and cmake --build --preset wasm"));
}

}  // namespace
}  // namespace raceway::tests
