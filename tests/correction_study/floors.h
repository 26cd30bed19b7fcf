#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

/// How close each class of model can come to a record, found apart from the library: gains by least
/// squares, time constants and shapes by trying a grid of them. What is hidden must matter, and be
/// told from what it resembles, by these numbers.
namespace correction_study {

/// What the columns of a record say, at every row. Empty: no such column.
struct Signals {
  std::vector<double> time;  ///< [s]
  std::vector<int> run;
  std::vector<double> displacement;           ///< [um], NaN where not read
  std::vector<double> speed;                  ///< [rpm]
  std::vector<double> spindle;                ///< input of the main channel [K] or [W]
  std::vector<double> ambient;                ///< mean of its sensors [C]
  std::vector<double> motor;                  ///< [C]
  std::vector<double> column;                 ///< of the machine [C]
  std::array<std::vector<double>, 3> feed{};  ///< of an axis, absolute [m/min]
  std::vector<double> coolant;                ///< 0 or 1
  std::vector<double> hidden;                 ///< what is hidden moves, known to the generator [um]
};

/// What the user believes.
struct Base {
  bool power = false;        ///< the main channel is driven by friction power, else by temperature
  int sections = 2;          ///< of the main channel
  bool ambient = false;      ///< has a channel of one section on the room
  bool feedthrough = false;  ///< of the main channel
};

/// Error of a class that is fitted to one record, there and on another one [um].
struct Fit {
  double train, test;
};

class Floors {
 public:
  Floors(const Base& base, const Signals& train, const Signals& test);

  [[nodiscard]] Fit base() const;
  /// The base and effects of the catalogue; empty where the records have no column for one.
  [[nodiscard]] std::optional<Fit> with(const std::vector<std::string_view>& effects) const;
  /// The base and what is hidden itself, its size free.
  [[nodiscard]] Fit with_hidden() const;

 private:
  const Base base_;
  const Signals& train_;
  const Signals& test_;
};

}  // namespace correction_study
