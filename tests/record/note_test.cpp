#include "record/note.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace raceway::record {
namespace {

TEST(Note, HasTheKindOfItsCodeAndItsPlace) {
  const Note said = note::unit("temperature_C looks like kelvin", {.file = "a.csv", .line = 3});
  EXPECT_EQ(said.kind(), NoteKind::doubt);
  EXPECT_EQ(said.code->name, "unit");
  EXPECT_EQ(said.place.text(), "a.csv:3");
}

TEST(Note, EachCodeHasANameOfItsOwnAndAMeaning) {
  std::set<std::string_view> names;
  for (const NoteCode* code : note_codes()) {
    EXPECT_TRUE(names.insert(code->name).second) << code->name;
    EXPECT_FALSE(code->meaning.empty()) << code->name;
  }
}

}  // namespace
}  // namespace raceway::record
