#pragma once

// Parts of the C++20 library that this project uses and that libc++ 13 lacks, and a function of
// Linux. libc++ 13 is the library of em++ in Debian. Only em++ includes this header, before each
// source of the project (packages.cmake). Numbers are read and written with the same digits as with
// libstdc++, because strtod and printf of musl round exactly.

/// Replaces the test for instruction sets of the processor. WebAssembly has none of the instruction
/// sets that the numerical kernels need.
#define __builtin_cpu_supports(set) false

#include <unistd.h>

#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

/// Renames a file, but only if no file has the new name, like renameat2() of Linux. The check and
/// the renaming are separate steps. In the browser, no other program can create a file with this
/// name between these steps.
#define RENAME_NOREPLACE 1
inline int renameat2(int, const char* from, int, const char* to, unsigned) {
  if (access(to, F_OK) != 0) return std::rename(from, to);
  errno = EEXIST;
  return -1;
}

namespace std {

template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

namespace raceway_charconv {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the end of the decimal number that from_chars reads at `first`; `first` if there is no
/// number.
constexpr const char* end_of_number(const char* first, const char* last) {
  const char* at = first != last && *first == '-' ? first + 1 : first;
  int digits = 0;
  for (; at != last && is_digit(*at); ++at) ++digits;
  if (at != last && *at == '.') {
    const char* const point = at++;
    for (; at != last && is_digit(*at); ++at) ++digits;
    if (digits == 0) at = point;
  }
  if (digits == 0) return first;
  if (at == last || (*at != 'e' && *at != 'E')) return at;
  const char* power = at + 1;
  if (power != last && (*power == '+' || *power == '-')) ++power;
  if (power == last || !is_digit(*power)) return at;
  while (power != last && is_digit(*power)) ++power;
  return power;
}

/// Reads infinity and not-a-number like from_chars. Returns the end of the word, or nullptr if the
/// text is neither infinity nor not-a-number.
inline const char* end_of_word(const char* first, const char* last, double& value) {
  const bool negative = first != last && *first == '-';
  const char* const word = negative ? first + 1 : first;
  const auto begins = [&](string_view name) {
    if (static_cast<size_t>(last - word) < name.size()) return false;
    for (size_t k = 0; k < name.size(); ++k)
      if ((word[k] | 0x20) != name[k]) return false;
    return true;
  };
  for (const string_view name : {"infinity", "inf", "nan"})
    if (begins(name)) {
      value =
          name == "nan" ? numeric_limits<double>::quiet_NaN() : numeric_limits<double>::infinity();
      if (negative) value = -value;
      return word + name.size();
    }
  return nullptr;
}

}  // namespace raceway_charconv

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* const end = raceway_charconv::end_of_number(first, last);
  if (end == first) {
    const char* const word = raceway_charconv::end_of_word(first, last, value);
    return word ? from_chars_result{word, errc()}
                : from_chars_result{first, errc::invalid_argument};
  }
  const string digits(first, end);
  const double read = strtod(digits.c_str(), nullptr);
  const bool has_digits =
      digits.substr(0, digits.find_first_of("eE")).find_first_of("123456789") != string::npos;
  if (isinf(read) || (read == 0.0 && has_digits)) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                                int precision) {
  char text[512];
  const char* const form = format == chars_format::scientific ? "%.*e"
                           : format == chars_format::fixed    ? "%.*f"
                                                              : "%.*g";
  const int size = snprintf(text, sizeof text, form, precision, value);
  if (size < 0 || size >= static_cast<int>(sizeof text) || size > last - first)
    return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(size));
  return {first + size, errc()};
}

/// Writes the number with the fewest digits that give exactly the same number when read again.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  for (int precision = 0;; ++precision) {
    const to_chars_result written = to_chars(first, last, value, format, precision);
    double read = 0.0;
    if (precision == 17 || written.ec != errc()) return written;
    if (from_chars(first, written.ptr, read).ec == errc() && read == value) return written;
  }
}

}  // namespace std
