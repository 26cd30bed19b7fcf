#include "record/note.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "tests/places.h"

namespace raceway::record {
namespace {

TEST(Note, HasTheKindOfItsCodeAndItsPlace) {
  const Note said = note::unit("temperature_C looks like kelvin", {.file = "a.csv", .line = 3});
  EXPECT_EQ(said.kind(), NoteKind::doubt);
  EXPECT_EQ(said.code->name, "unit");
  EXPECT_EQ(said.place.text(), "a.csv:3");
}

TEST(Note, EachCodeIsListedOnceInThePagesToo) {
  std::ifstream page(tests::source_dir() + "/docs/files.md");
  std::stringstream text;
  text << page.rdbuf();
  std::set<std::string_view> names;
  for (const NoteCode* code : note_codes()) {
    EXPECT_TRUE(names.insert(code->name).second) << code->name;
    const std::string row = "| `" + std::string(code->name) + "` | " +
                            std::string(name(code->kind)) + " | " + std::string(code->meaning) +
                            " |\n";
    EXPECT_NE(text.str().find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace raceway::record
