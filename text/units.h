#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raceway::text {

/// Physical quantity that a unit measures.
enum class Dimension {
  moment,
  force,
  length,
  speed,
  feed,
  temperature,
  time,
  angle,
  pressure,
  power,
  viscosity,
  stiffness,
  voltage,
  current,
  flow,
  share
};

/// A unit that may occur in files; units() returns all of them.
struct Unit {
  std::string_view suffix;  ///< ending of column names: "Nmm"
  std::string_view words;   ///< text for readers: "N mm"
  Dimension dimension;
  double factor;        ///< SI = factor * value + offset
  double offset = 0.0;  ///< [K] for temperatures
  /// Other spellings, separated by blanks. In a spelling, brackets, blanks and product signs are
  /// left out, the micro sign is "u", the degree sign is "deg", and a slash is "_". find_unit()
  /// converts a text in the same way before the comparison.
  std::string_view spellings = {};
  /// Words for the unit, in lower case, separated by blanks; files may also use upper case.
  std::string_view names = {};

  [[nodiscard]] constexpr double to_SI(double value) const { return value * factor + offset; }
  [[nodiscard]] constexpr double in_unit(double si) const { return (si - offset) / factor; }
};

[[nodiscard]] std::span<const Unit> units();

/// Returns the unit with this spelling: "Nm", "N m", "N·m", "[1/min]", "min-1", "°C", "µm",
/// "rad_s", "minutes". Upper and lower case differ in symbols (mN, MN) but not in words. Returns
/// null if no unit has this spelling, or if the unit does not measure the given dimension.
[[nodiscard]] const Unit* find_unit(std::string_view spelling,
                                    std::optional<Dimension> dimension = std::nullopt);

/// Returns true for a text that means "no unit", such as "-".
[[nodiscard]] bool states_no_unit(std::string_view text);

/// Returns the units of a dimension as text for messages, such as "rpm, 1_s, rad_s, deg_s or krpm".
[[nodiscard]] std::string listed_units(Dimension dimension);

/// Returns the conversion between two units as text for notes, such as "1 N m = 1000 N mm".
[[nodiscard]] std::string conversion(const Unit& from, const Unit& to);

/// Name and unit of a column header: {"Drehzahl", "1/min"} for "Drehzahl [1/min]", "Drehzahl
/// (1/min)" and "Drehzahl in 1/min"; {"friction_torque", "Nm"} for "friction_torque_Nm". If the
/// unit is unknown, `unit` is empty.
struct HeaderParts {
  std::string_view name, unit;
};
[[nodiscard]] HeaderParts header_parts(std::string_view header);

/// Returns the text in brackets at the end of a header: "1/min" for "Drehzahl [1/min]"; empty if
/// there are no brackets.
[[nodiscard]] std::string_view in_brackets(std::string_view header);

/// Returns a unit of this dimension at the end of a header, after a blank or a comma: "Torque, N
/// m", "Speed rad/s". The unit must have at least two characters. Returns null if the header does
/// not end with such a unit.
[[nodiscard]] const Unit* unit_at_end(std::string_view header, Dimension dimension);

/// Returns the factor that converts the values of a column to SI. The end of the column name gives
/// the unit: the factor is 1e-3 for "load_Nmm", and 1 for a name with an SI unit or without a unit.
[[nodiscard]] double column_unit(std::string_view column);

}  // namespace raceway::text
