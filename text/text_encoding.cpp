#include "text/text_encoding.h"

#include <iconv.h>

#include <array>
#include <utility>

#include "text/error.h"

namespace raceway::text {

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t more = c < 0x80                ? 0
                             : c >= 0xc2 && c < 0xe0 ? 1
                             : c >= 0xe0 && c < 0xf0 ? 2
                                                     : 3;
    if (c >= 0x80 && (c < 0xc2 || c > 0xf4)) return false;
    if (i + more >= text.size()) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return false;
    i += more + 1;
  }
  return true;
}

namespace {

/// What the bytes 0x80 to 0x9f are in Windows-1252; they are control characters in Latin-1 proper.
constexpr char16_t of_windows[] = {0x20ac, 0xfffd, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                   0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0xfffd, 0x017d, 0xfffd,
                                   0xfffd, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                   0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0xfffd, 0x017e, 0x0178};

}  // namespace

std::string utf8_from_latin1(std::string_view text) {
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char byte : text) {
    const auto c = static_cast<unsigned char>(byte);
    if (c < 0x80) {
      result += byte;
    } else {
      const unsigned code = c < 0xa0 ? of_windows[c - 0x80] : c;
      if (code < 0x800) {
        result += static_cast<char>(0xc0 | (code >> 6));
      } else {
        result += static_cast<char>(0xe0 | (code >> 12));
        result += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
      }
      result += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return result;
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

std::string utf8_from_utf16(std::string_view text, const std::string& source) {
  const iconv_t converter = iconv_open("UTF-8", "UTF-16");
  if (converter == reinterpret_cast<iconv_t>(-1))
    throw InputError(source + ": is UTF-16 text; save it as UTF-8", {.file = source});
  std::string from(text), to(2 * text.size() + 4, '\0');
  char *in = from.data(), *out = to.data();
  std::size_t left = from.size(), room = to.size();
  const bool failed = iconv(converter, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
  iconv_close(converter);
  if (failed || left != 0)
    throw InputError(
        source + ": the file begins like UTF-16, but is not valid UTF-16; save it as UTF-8",
        {.file = source});
  to.resize(to.size() - room);
  return to;
}

std::string_view binary_kind(std::string_view text) {
  using std::string_view_literals::operator""sv;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kinds{
      {{"PK\x03\x04"sv,
        "is an Excel workbook (.xlsx) or another zip archive; save the sheet as CSV "
        "(in Excel: Save as, CSV UTF-8)"},
       {"\xd0\xcf\x11\xe0"sv,
        "is an old Excel workbook (.xls); save the sheet as CSV (in Excel: Save as, CSV)"},
       {"\x1f\x8b"sv, "is compressed (gzip); decompress it first"},
       {"PAR1"sv, "is a Parquet file; save it as CSV"},
       {"\x89HDF"sv, "is an HDF5 file (also MATLAB 7.3); save its columns as CSV"},
       {"MATLAB 5.0"sv, "is a MATLAB file (.mat); save its columns as CSV (writetable)"},
       {"TDSm"sv, "is a LabVIEW TDMS file; save it as CSV"},
       {"MDF "sv, "is a measurement file (MDF); save it as CSV"},
       {"%PDF"sv, "is a PDF; save the numbers as a table (CSV)"}}};
  for (const auto& [magic, words] : kinds)
    if (text.starts_with(magic)) return words;
  return {};
}

}  // namespace raceway::text
