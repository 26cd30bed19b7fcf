#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/beyond.h"
#include "correction/delay_element.h"
#include "correction/friction_table.h"
#include "correction/transfer_function.h"
#include "fit/covariance.h"
#include "record/parameter.h"
#include "record/record.h"
#include "record/series_channel.h"

/// The displacement of a machine over hours, from what its control knows: a sum of lags of
/// temperatures, power, speed and feeds, and of what follows the speed at once.
namespace raceway::correction {

using record::Channel;

class OwnEffect;

/// Share with which a channel acts at a position of an axis: 0 outside of the outer points, 1
/// between the inner ones, straight between an outer and an inner one.
struct Window {
  const Channel* column = nullptr;  ///< the position
  std::array<double, 4> points{};   ///< rising, SI; infinite where it has no edge
  /// True: the window scales the input, before the lags, as for heat that arises in it. False: it
  /// scales the displacement, as for a body that moves the tool only there.
  bool of_input = false;

  [[nodiscard]] double operator()(double position) const;
  /// "300..600" in the unit of the column, "300.." without an upper edge, all four points where its
  /// edges are not sharp.
  [[nodiscard]] std::string range_text() const;
};

/// Point on one axis of a friction table at which it is read: a number, or the value of a column.
struct TableCoordinate {
  double value = unset;  ///< SI
  const Channel* column = nullptr;
};

/// Input of a channel.
///
/// Temperatures count from the first row of a run. Feeds and speeds act by their absolute value,
/// other columns with their sign.
struct Input {
  std::string name{};                     ///< as the file has it: "power_W", or the only column
  std::vector<const Channel*> columns{};  ///< of which the mean drives
  const Channel* reference = nullptr;     ///< its rise is subtracted from the rise of the input
  /// Exponent for a speed n, which then counts as n (n/1000 rpm)^(exponent - 1): heat rises faster
  /// than n.
  double exponent = 1.0;
  Interval seen{};  ///< range of that speed in the fit [SI]; the power is continued() beyond it
  std::shared_ptr<const FrictionTable> table{};  ///< power: its torque at the speed times the speed
  TableCoordinate axial_load{}, radial_load{}, temperature{};  ///< at which that table is read
  Interval within{};                                           ///< to which the power is held [W]
  std::optional<Window> window{};
  std::shared_ptr<const OwnEffect>
      formula{};  ///< of columns, and of these values of its parameters
  std::vector<double> formula_values{};

  [[nodiscard]] bool is_power() const { return table != nullptr; }
  /// Nothing drives.
  [[nodiscard]] bool is_none() const { return columns.empty() && !table && !formula; }
  /// Unit of the input in gains: "K", "W", "m/min" or "rpm" for people, "K", "W", "m_min", "rpm" in
  /// keys, and one of them in SI.
  [[nodiscard]] std::string_view unit() const;
  [[nodiscard]] std::string_view key_unit() const;
  [[nodiscard]] double factor() const;
  [[nodiscard]] record::Course course() const;
};

/// A lag: where a step of the input by one leads to, and how fast.
struct Section {
  double gain = unset;           ///< [m] per SI unit of the input
  double time_constant = unset;  ///< [s]
};

/// A body that moves, described by one input.
struct DrivenChannel {
  std::string name{};
  Input input{};
  std::vector<Section> sections{};
  double feedthrough = 0.0;  ///< [m] per SI unit of the input, at once
  double scale = 1.0;        ///< of all of it: the gain of a sister spindle
  /// Instead of sections: a gain and a time constant that go with the power.
  std::optional<DelayElement> element{};
  /// Instead of sections: coefficients as printed, for one sampling time; um/K whatever the input.
  std::optional<TransferFunction> printed{};
};

/// The law of instant displacement, u = A n^(1 - B exp(-C n)): see shaft/kinematic_law.h.
struct Kinematic {
  double A = unset, B = unset, C = unset;  ///< [um], [1], [1/rpm]
};

/// An effect of the catalogue, as it is switched on.
struct Effect {
  std::string id{};
  std::string where{};                     ///< channel or axis that it acts on; empty without
  std::vector<const Channel*> columns{};   ///< of which the mean drives it
  std::optional<Window> window{};          ///< in which it acts
  std::vector<double> values{};            ///< of its numbers, in the units of its card
  std::shared_ptr<const OwnEffect> own{};  ///< one that the user wrote; null for the catalogue's
  bool off = false;  ///< one of the user's own that waits to be added: a candidate
};

/// Initial state of the machine at the start of its record.
enum class InitialState { rest, free };
/// "rest" or "free"
[[nodiscard]] constexpr std::string_view name(InitialState state) {
  return state == InitialState::free ? "free" : "rest";
}

/// Knowledge of a number of a model before the next fit, in the unit of the files.
struct NumberPrior {
  std::string name{};  ///< of the parameter, "spindle.scale"
  record::Prior prior{};
};

/// Range of a column in the data of the fit.
struct SeenRange {
  const Channel* column = nullptr;      ///< null: the power of a channel
  std::string name{};                   ///< of the column, or of the channel
  double lower = unset, upper = unset;  ///< SI; of temperatures as they stand, not their rise
  double still = unset;  ///< longest time that a temperature stood still, where it is known [s]
};

/// The inputs at once, as a cloud of points: each may stand where it has stood before, and all of
/// them where they never were together.
struct SeenTogether {
  std::vector<const Channel*> columns{};  ///< those that varied
  Eigen::VectorXd mean{}, std{};          ///< SI; of all but temperatures of their amount
  Eigen::MatrixXd correlation{};
  double farthest = unset;  ///< distance of the farthest point from the mean [1]: see range.h
};

/// Residual of the fitted model.
struct Left {
  double rms = unset;               ///< on parts that no fit saw, where there are any [m]
  double correlation_time = unset;  ///< [s]
};

/// Evidence for a fitted model from readings that its fit did not see; trust.h judges by it.
struct Evidence {
  double error = unset;        ///< RMS on them, NaN where there are none [m]
  double uncorrected = unset;  ///< RMS of the readings, one constant taken off each run [m]
  double duration = unset;     ///< of the readings of the longest run [s]
  bool one_way = false;        ///< the readings go from one state to another once
  bool other_record = false;   ///< error and uncorrected are of another record than the fit
};

struct Model {
  std::string name{};
  const Channel* displacement = nullptr;
  double tolerance = unset;     ///< [m]
  double measured_std = unset;  ///< [m]
  InitialState initial_state = InitialState::rest;
  double sampling = unset;  ///< [s], of printed coefficients
  double offset = 0.0;      ///< [m]
  std::vector<DrivenChannel> channels{};
  std::optional<Kinematic> kinematic{};
  std::vector<Effect> effects{};
  /// Names of parameters, and groups of them: see groups().
  std::vector<std::string> free{};
  std::vector<NumberPrior> priors{};
  std::vector<SeenRange> range{};
  std::optional<SeenTogether> together{};
  std::optional<fit::Covariance> covariance{};
  std::optional<Left> left{};
  std::optional<Evidence> evidence{};
};

/// Unit of the displacement: "um", or "urad" of an angle.
[[nodiscard]] inline std::string_view unit_of(const Model& model) {
  return model.displacement ? model.displacement->unit : "um";
}
/// Name or unit of a number, which is written for a length: see record::in_unit_of().
[[nodiscard]] inline std::string in_unit_of(const Model& model, std::string_view text) {
  return model.displacement ? record::in_unit_of(*model.displacement, text) : std::string(text);
}

}  // namespace raceway::correction
