#include <algorithm>
#include <cmath>
#include <limits>

// Last: see text/detail/toml_text.h.
#include "files/detail/formula_section.h"

namespace raceway::files {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Key formula_number[]{
    {"value", between(-infinity, infinity), is_required,
     "value of the parameter; NAME = number is the short form"},
    {"unit", a_text, "1", "unit of the parameter in results"},
    {"lower", between(-infinity, infinity), unset, "lower bound of the parameter in a fit"},
    {"upper", between(-infinity, infinity), unset, "upper bound of the parameter in a fit"},
};

/// A name that muParser takes for a variable.
bool valid_name(std::string_view name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9');
  });
}

/// A part of a unit that is another one than that of the files, as m or kN; empty where there is
/// none. A unit of a formula's parameter is a label: nothing is converted by it.
std::string unit_of_no_file(std::string_view unit) {
  static const Names others{"Nm", "mNm", "kNm", "Ncm",  "uNm", "kN",  "MN", "m",
                            "cm", "rad", "Hz",  "krpm", "F",   "lbf", "in", "inch"};
  std::string word;
  for (std::size_t at = 0; at <= unit.size(); ++at) {
    const char c = at < unit.size() ? unit[at] : ' ';
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
      word += c;
      continue;
    }
    if (std::find(others.begin(), others.end(), word) != others.end()) return word;
    word.clear();
  }
  return {};
}

}  // namespace

std::vector<KeyTable> formula_tables() { return {{"effect.PARAMETER", formula_number}}; }

void fail_formula(const Section& s, const std::string& key, const std::string& id,
                  const std::string& formula, const record::FormulaError& error,
                  const Names& known) {
  std::string hint;
  if (!error.unknown_name.empty()) {
    hint = text::suggestion(error.unknown_name, known);
    if (hint.empty()) {
      if (valid_name(error.unknown_name))
        hint = fmt::format("; if {0} is a parameter, give {0} = {{value = 1.0, unit = \"N mm\"}}",
                           error.unknown_name);
      hint += "; a formula can use " + text::listed(known);
    }
  }
  const toml::source_position at = s.find(key)->source().begin;
  // Exact for a formula in plain quotes, which has no escapes.
  throw text::InputError(fmt::format("{}:{}:{}: effect {}: {}: {}{}\n  {}\n  {:>{}}", s.source(),
                                     at.line, at.column + 1 + error.position, id, key, error.what(),
                                     hint, formula, "^", error.position + 1),
                         s.at(key));
}

FormulaNumber read_formula_number(const Section& s, const std::string& id, const std::string& name,
                                  const toml::node& node, const Names& taken) {
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    s.fail(name,
           fmt::format("{}: a variable of formulas has this name; choose another name", name));
  if (!valid_name(name))
    s.fail(name,
           fmt::format("{}: must consist of letters, digits and _, and must not begin with a digit",
                       name));
  FormulaNumber number{.name = name, .unit = "1"};
  if (!node.is_table()) {
    number.value = *s.number(formula_number[0].as(name, ""));
    return number;
  }
  number.in_braces = true;
  const Section t(s.source(), fmt::format("effect {}, {}", id, name), node.as_table(),
                  {formula_number});
  number.unit = t.text("unit").value_or("1");
  if (const std::string other = unit_of_no_file(number.unit); !other.empty())
    t.fail("unit",
           fmt::format(
               "{}: unit = \"{}\": formulas have the units of the files: N mm, N, rpm, C, mm2/s, "
               "mm, s. The program does not convert {}; give the value in one of these units",
               name, number.unit, other));
  t.take("lower", number.lower);
  t.take("upper", number.upper);
  const double from = std::isnan(number.lower) ? -infinity : number.lower;
  const double to = std::isnan(number.upper) ? infinity : number.upper;
  if (!(from < to))
    t.fail("upper", fmt::format("{}: upper = {} must be above lower = {}", name, to, from));
  Key value = t.key("value").as("value", number.unit);
  value.form.lower = from;
  value.form.upper = to;
  number.value = *t.number(value);
  return number;
}

}  // namespace raceway::files
