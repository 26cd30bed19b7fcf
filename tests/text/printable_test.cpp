#include "text/printable.h"

#include <gtest/gtest.h>

namespace raceway::text {
namespace {

TEST(Printable, TextHasNoControlCharacter) {
  for (const char* text : {"", "rig 2", "a\tb", "40 °C, µm, Öl", "\u00a0", "日本", "\xc2"})
    EXPECT_FALSE(control_character(text)) << text;
}

/// C0, DEL and, of two bytes, C1.
TEST(Printable, TheFirstControlCharacterIsNamed) {
  EXPECT_EQ(control_character("a\x1b[0m\x07"), "U+001B");
  EXPECT_EQ(control_character("line\n"), "U+000A");
  EXPECT_EQ(control_character(std::string_view("nul\0", 4)), "U+0000");
  EXPECT_EQ(control_character("\x7f"), "U+007F");
  EXPECT_EQ(control_character("ö\xc2\x9b"
                              "0m"),
            "U+009B");
}

TEST(Printable, ControlCharactersAreWrittenOut) {
  EXPECT_EQ(printable("a\x1b[0m\t\xc2\x9b\x7f"), "a\\x1b[0m\\x09\\x9b\\x7f");
  EXPECT_EQ(printable("two\nlines\r", "\n"), "two\nlines\\x0d");
  EXPECT_EQ(printable("40 °C"), "40 °C");
}

}  // namespace
}  // namespace raceway::text
