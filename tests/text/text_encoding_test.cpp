#include "text/text_encoding.h"

#include "tests/support/message_of.h"

namespace raceway::text {
namespace {

TEST(TextEncoding, Utf8IsTold) {
  for (const char* text : {"", "rpm", "40 °C", "日本", "\xf0\x9f\x98\x80"})
    EXPECT_TRUE(is_utf8(text)) << text;
  for (const char* text : {"40 \xb0"
                           "C",
                           "\xc3", "\xe2\x82", "\xc0\xaf", "\xff", "\x80"})
    EXPECT_FALSE(is_utf8(text));
}

/// As a German Excel writes it: Latin-1, and between 0x80 and 0x9f euro, dashes and quotes.
TEST(TextEncoding, Windows1252BecomesUtf8) {
  EXPECT_EQ(utf8_from_latin1("\xd6l, 40 \xb0"
                             "C, \xb5m, N\xb7m, m\xb2"),
            "Öl, 40 °C, µm, N·m, m²");
  EXPECT_EQ(utf8_from_latin1("5 \x80 \x96 \x84wie neu\x93 \x85"), "5 € – „wie neu“ …");
  EXPECT_EQ(utf8_from_latin1("\x81"), "\xef\xbf\xbd") << "has no meaning there";
}

TEST(TextEncoding, EveryByteOfWindows1252BecomesUtf8) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_TRUE(is_utf8(utf8_from_latin1(std::string(1, static_cast<char>(byte))))) << byte;
}

TEST(TextEncoding, Utf16OfBothOrdersBecomesUtf8) {
  using namespace std::string_view_literals;
  for (const std::string_view text : {"\xff\xfe\xb0\0C\0"sv, "\xfe\xff\0\xb0\0C"sv}) {
    EXPECT_TRUE(is_utf16(text));
    EXPECT_EQ(utf8_from_utf16(text, "d.csv"), "°C");
  }
  EXPECT_FALSE(is_utf16("C"));
  EXPECT_EQ(tests::message_of([] { (void)utf8_from_utf16("\xff\xfe\xb0", "d.csv"); }),
            "d.csv: the file begins like UTF-16, but is not valid UTF-16; save it as UTF-8");
}

}  // namespace
}  // namespace raceway::text
