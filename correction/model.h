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

/// Describes the displacement of a machine in the course of hours, with data from its control. The
/// model is a sum of lags of temperatures, power, speed and feeds, and of an instant part that
/// follows the speed.
namespace raceway::correction {

using record::Channel;

class OwnEffect;

/// Weight of a channel as a function of an axis position: 0 outside the outer points, 1 between the
/// inner points, and linear between an outer and an inner point.
struct Window {
  const Channel* column = nullptr;  ///< position of the axis
  std::array<double, 4> points{};   ///< rising positions [SI]; infinite on a side without an edge
  /// True if the window scales the input before the lags, for heat that arises in the window. False
  /// if the window scales the displacement, for a body that moves the tool only in the window.
  bool of_input = false;

  [[nodiscard]] double operator()(double position) const;
  /// Returns "300..600" in the unit of the column, or "300.." without an upper edge. If an edge is
  /// not sharp, the text contains all four points.
  [[nodiscard]] std::string range_text() const;
};

/// Coordinate on one axis of a friction table: a number, or the value of a column.
struct TableCoordinate {
  double value = unset;  ///< SI
  const Channel* column = nullptr;
};

/// Input of a channel.
///
/// Temperatures are taken relative to the first row of a run. For feeds, speeds and the coolant
/// state, the absolute value is used. Other columns keep their sign.
struct Input {
  std::string name{};                     ///< name in the file: "power_W", or the only column
  std::vector<const Channel*> columns{};  ///< the mean of these columns is the input
  const Channel* reference = nullptr;     ///< temperature whose rise is subtracted from the input
  /// Exponent for a speed n. The input is n (n/1000 rpm)^(exponent - 1). An exponent above 1
  /// describes heat that rises faster than n.
  double exponent = 1.0;
  Interval seen{};  ///< speed range of the fit [SI]; continued() extrapolates beyond it
  /// Friction table of a power input. The power is the torque from the table times the speed.
  std::shared_ptr<const FrictionTable> table{};
  TableCoordinate axial_load{}, radial_load{}, temperature{};  ///< other coordinates in the table
  Interval within{};                                           ///< limits of the power [W]
  std::optional<Window> window{};
  std::shared_ptr<const OwnEffect> formula{};  ///< user-defined function of columns
  std::vector<double> formula_values{};

  [[nodiscard]] bool is_power() const { return table != nullptr; }
  /// Returns true if the channel has no input.
  [[nodiscard]] bool is_none() const { return columns.empty() && !table && !formula; }
  /// Returns the unit of the input in gains: "K", "W", "m/min" or "rpm" in text, and "K", "W",
  /// "m_min" or "rpm" in keys. factor() gives the SI value of one such unit.
  [[nodiscard]] std::string_view unit() const;
  [[nodiscard]] std::string_view key_unit() const;
  [[nodiscard]] double factor() const;
  [[nodiscard]] record::Course course() const;
};

/// A lag, described by its final response to a unit step of the input and by a time constant.
struct Section {
  double gain = unset;           ///< [m] per SI unit of the input
  double time_constant = unset;  ///< [s]
};

/// Contribution to the displacement that one input drives.
struct DrivenChannel {
  std::string name{};
  Input input{};
  std::vector<Section> sections{};
  double feedthrough = 0.0;  ///< instant response [m] per SI unit of the input
  double scale = 1.0;  ///< factor on the whole channel, for example for a spindle of the same type
  /// Replaces the sections by a gain and a time constant that depend on the power or load.
  std::optional<DelayElement> element{};
  /// Replaces the sections by a transfer function with published coefficients for one sampling
  /// time.
  std::optional<TransferFunction> printed{};
};

/// Law of the kinematic displacement, u = A n^(1 - B exp(-C n)): see shaft/kinematic_law.h.
struct Kinematic {
  double A = unset, B = unset, C = unset;  ///< units [um], [1], [1/rpm]
};

/// An effect of the catalogue that is switched on.
struct Effect {
  std::string id{};
  std::string where{};                    ///< channel or axis of the effect; empty without one
  std::vector<const Channel*> columns{};  ///< the mean of these columns drives the effect
  std::optional<Window> window{};         ///< window in which the effect acts
  std::vector<double> values{};           ///< parameter values in the units of EffectCard
  /// user-defined effect; null for an effect of the catalogue
  std::shared_ptr<const OwnEffect> own{};
  bool off = false;  ///< true: a user-defined effect that is only a candidate
};

/// Initial state of the machine at the start of its record.
enum class InitialState { rest, free };
/// Returns "rest" or "free".
[[nodiscard]] constexpr std::string_view name(InitialState state) {
  return state == InitialState::free ? "free" : "rest";
}

/// Prior of a parameter for the next fit, in the units of the files.
struct NumberPrior {
  std::string name{};  ///< name of the parameter, such as "spindle.scale"
  record::Prior prior{};
};

/// Range of a column in the data of the fit.
struct SeenRange {
  const Channel* column = nullptr;      ///< null for the power of a channel
  std::string name{};                   ///< name of the column or the channel
  double lower = unset, upper = unset;  ///< [SI]; a temperature itself, not its rise
  double still = unset;                 ///< longest time with a constant temperature, if known [s]
};

/// Joint range of all inputs in the data of the fit, as a cloud of points. Each input may be within
/// its own range although the combination never occurred.
struct SeenTogether {
  std::vector<const Channel*> columns{};  ///< columns that varied
  /// [SI]; of absolute values for speeds, feeds and the coolant state.
  Eigen::VectorXd mean{}, std{};
  Eigen::MatrixXd correlation{};
  /// Largest distance of a point from the mean [1]: see Distance in range.h.
  double farthest = unset;
};

/// Residual of the fitted model.
struct Left {
  double rms = unset;               ///< rms on held-out parts if there are any [m]
  double correlation_time = unset;  ///< [s]
};

/// Evidence for a fitted model from readings that the fit did not use. trust_of() judges it.
struct Evidence {
  double error = unset;  ///< rms error on readings that the fit did not use; NaN without them [m]
  /// Rms of the readings after subtracting one constant from each run [m].
  double uncorrected = unset;
  double duration = unset;  ///< duration of the readings of the longest run [s]
  bool one_way = false;     ///< true if the readings only move once from one state to another
  /// True if `error` and `uncorrected` come from another record than the fit.
  bool other_record = false;
};

struct Model {
  std::string name{};
  const Channel* displacement = nullptr;
  double tolerance = unset;     ///< [m]
  double measured_std = unset;  ///< [m]
  InitialState initial_state = InitialState::rest;
  double sampling = unset;  ///< sampling interval of published coefficients [s]
  double offset = 0.0;      ///< [m]
  std::vector<DrivenChannel> channels{};
  std::optional<Kinematic> kinematic{};
  std::vector<Effect> effects{};
  /// Names of free parameters or of groups such as "gains": see free_names(). Empty: the default.
  std::vector<std::string> free{};
  std::vector<NumberPrior> priors{};
  std::vector<SeenRange> range{};
  std::optional<SeenTogether> together{};
  std::optional<fit::Covariance> covariance{};
  std::optional<Left> left{};
  std::optional<Evidence> evidence{};
};

/// Returns the unit of the displacement: "um", or "urad" for an angle.
[[nodiscard]] inline std::string_view unit_of(const Model& model) {
  return model.displacement ? model.displacement->unit : "um";
}
/// Converts the name or unit of a parameter from length to the model's unit: see
/// record::in_unit_of().
[[nodiscard]] inline std::string in_unit_of(const Model& model, std::string_view text) {
  return model.displacement ? record::in_unit_of(*model.displacement, text) : std::string(text);
}

}  // namespace raceway::correction
