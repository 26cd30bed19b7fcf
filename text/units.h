#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raceway::text {

/// Quantity measured by a unit.
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

/// A unit that may occur in files.
struct Unit {
  std::string_view suffix;  ///< as names of columns end: "Nmm"
  std::string_view words;   ///< for people: "N mm"
  Dimension dimension;
  double factor;        ///< SI = factor * value + offset
  double offset = 0.0;  ///< [K] for temperatures
  /// Other spellings, between blanks, as in_short() normalises the text of a file.
  std::string_view spellings = {};
  std::string_view names = {};  ///< further spellings, in small letters, read in any case

  [[nodiscard]] constexpr double to_SI(double value) const { return value * factor + offset; }
  [[nodiscard]] constexpr double in_unit(double si) const { return (si - offset) / factor; }
};

/// All units; the first of a dimension with names in channels is the unit of this program.
[[nodiscard]] std::span<const Unit> units();

/// Returns the unit with this spelling: "Nm", "N m", "N·m", "[1/min]", "min-1", "°C", "µm",
/// "rad_s", "minutes". Upper and lower case differ in symbols (mN, MN) and not in words. Null if
/// that dimension, or any, has no such unit.
[[nodiscard]] const Unit* find_unit(std::string_view spelling,
                                    std::optional<Dimension> dimension = std::nullopt);

/// True for texts in the place of a unit that state none: "-".
[[nodiscard]] bool states_no_unit(std::string_view text);

/// Units of a dimension, for messages: "rpm, 1_s, rad_s or krpm".
[[nodiscard]] std::string listed_units(Dimension dimension);

/// Describes a conversion for notes: "1 N m = 1000 N mm", "C = K - 273.15".
[[nodiscard]] std::string conversion(const Unit& from, const Unit& to);

/// Name and unit of a column header: {"Drehzahl", "1/min"} of "Drehzahl [1/min]", of "Drehzahl
/// (1/min)" and of "Drehzahl in 1/min", {"friction_torque", "Nm"} of "friction_torque_Nm". The unit
/// is empty if it is not known.
struct HeaderParts {
  std::string_view name, unit;
};
[[nodiscard]] HeaderParts header_parts(std::string_view header);

/// The text in the brackets at the end of a header: "1/min" of "Drehzahl [1/min]"; empty without.
[[nodiscard]] std::string_view in_brackets(std::string_view header);

/// Returns the unit of that dimension after the last blanks or comma of a header, of two letters or
/// more: "Torque, N m", "Speed rad/s". Null without.
[[nodiscard]] const Unit* unit_at_end(std::string_view header, Dimension dimension);

/// Returns the SI value of one unit of a column, from the end of its name: 1e-3 for "load_Nmm", 1
/// where the name ends in no unit (or in one that is SI already).
[[nodiscard]] double column_unit(std::string_view column);

}  // namespace raceway::text
