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

/// Predicts the displacement of a machine tool over hours from signals of its control. The
/// predicted displacement is a sum: first-order lags driven by temperatures, powers, speeds and
/// feeds, and an instant displacement that depends on the speed.
namespace raceway::correction {

using record::Channel;

class OwnEffect;

/// Factor that multiplies a channel, as a function of an axis position. The factor is 0 outside the
/// outer two of four points, 1 between the inner two, and linear between an outer and an inner
/// point.
struct Window {
  const Channel* column = nullptr;  ///< position of the axis
  /// Four rising positions [SI]; infinite on a side without a limit.
  std::array<double, 4> points{};
  /// True: the factor scales the input before the lags, for heat that arises only in the window.
  /// False: the factor scales the displacement, for a body that moves the tool only in the window.
  bool of_input = false;

  [[nodiscard]] double operator()(double position) const;
  /// Returns the limits of the window as text in the unit of the column: "300..600", or "300.."
  /// without an upper limit. If the factor rises or falls gradually, the text contains all four
  /// points.
  [[nodiscard]] std::string range_text() const;
};

/// Coordinate on one axis of a friction table: a constant, or the value of a record column.
struct TableCoordinate {
  double value = unset;             ///< constant [SI]
  const Channel* column = nullptr;  ///< null: the constant `value`
};

/// Quantity that drives a channel of the displacement model.
///
/// For a temperature, the input is its change since the first row of the run. For a feed, a speed
/// or the coolant state, the input is the absolute value. Other columns keep their sign.
struct Input {
  std::string name{};                     ///< name in the model file: "power_W", or a column
  std::vector<const Channel*> columns{};  ///< the mean of these columns is the input
  /// Temperature whose change since the first row is subtracted from the input; null: none.
  const Channel* reference = nullptr;
  /// Exponent for a speed n: the input is n (n/1000 rpm)^(exponent - 1). An exponent above 1
  /// describes heat that rises faster than n.
  double exponent = 1.0;
  /// Speed range of the fit [SI]. Above this range, continued() extrapolates the power law of
  /// `exponent`.
  Interval seen{};
  /// Friction table of a power input. The power is the torque from the table times the speed.
  std::shared_ptr<const FrictionTable> table{};
  TableCoordinate axial_load{}, radial_load{}, temperature{};  ///< other axes of `table`
  Interval within{};  ///< range to which a calculated power is clipped [W]
  std::optional<Window> window{};
  std::shared_ptr<const OwnEffect> formula{};  ///< input as a user-defined formula of columns
  std::vector<double> formula_values{};

  [[nodiscard]] bool is_power() const { return table != nullptr; }
  /// Returns true if no column, friction table or formula defines the input.
  [[nodiscard]] bool is_none() const { return columns.empty() && !table && !formula; }
  /// Returns the unit of the input to which gains refer: unit() in the form for text, such as "K"
  /// or "m/min", and key_unit() in the form for keys, such as "K" or "m_min". factor() returns the
  /// SI value of this unit.
  [[nodiscard]] std::string_view unit() const;
  [[nodiscard]] std::string_view key_unit() const;
  [[nodiscard]] double factor() const;
  [[nodiscard]] record::Course course() const;
};

/// First-order lag with a gain and a time constant. The gain is the final displacement per unit
/// step of the input.
struct Section {
  double gain = unset;           ///< [m] per SI unit of the input
  double time_constant = unset;  ///< [s]
};

/// Channel: a contribution to the displacement that one input drives.
struct DrivenChannel {
  std::string name{};
  Input input{};
  std::vector<Section> sections{};
  double feedthrough = 0.0;  ///< instant displacement [m] per SI unit of the input
  /// Factor on the whole channel, for example for another spindle of the same type.
  double scale = 1.0;
  /// If set, replaces `sections` by a gain and a time constant that depend on the power or load.
  std::optional<DelayElement> element{};
  /// If set, replaces `sections` by a transfer function with published coefficients for one
  /// sampling time.
  std::optional<TransferFunction> printed{};
};

/// Law of the kinematic displacement, u = A n^(1 - B exp(-C n)): see shaft/kinematic_law.h.
struct Kinematic {
  double A = unset, B = unset, C = unset;  ///< A [um], B [1], C [1/rpm]
};

/// An effect that a model contains: a physical mechanism from the catalogue, or a user-defined
/// formula.
struct Effect {
  std::string id{};
  std::string where{};                    ///< name of the channel or axis on which the effect acts
  std::vector<const Channel*> columns{};  ///< the mean of these columns drives the effect
  std::optional<Window> window{};         ///< range of an axis in which the effect acts
  std::vector<double> values{};           ///< parameter values in the units of EffectCard
  /// User-defined effect; null for an effect of the catalogue.
  std::shared_ptr<const OwnEffect> own{};
  /// True: user-defined effect that diagnose() and add() can test. The effect contributes nothing.
  bool off = false;
};

/// State of the lags at the start of a record: zero (`rest`), or fitted to the readings (`free`).
enum class InitialState { rest, free };
/// Returns "rest" or "free".
[[nodiscard]] constexpr std::string_view name(InitialState state) {
  return state == InitialState::free ? "free" : "rest";
}

/// Prior of a parameter for the next fit, in the unit of the parameter in the model file.
struct NumberPrior {
  std::string name{};  ///< name of the parameter, such as "spindle.scale"
  record::Prior prior{};
};

/// Range of an input in the data of the fit.
struct SeenRange {
  const Channel* column = nullptr;      ///< column of the input; null: the power of a channel
  std::string name{};                   ///< name of the column or the channel
  double lower = unset, upper = unset;  ///< [SI]; a temperature in K, not its change
  double still = unset;  ///< longest time without a change of a temperature [s]; NaN: unknown
};

/// Distribution of all inputs in the data of the fit. The distribution shows which combinations of
/// inputs never occurred, even if each input is within its own range.
struct SeenTogether {
  std::vector<const Channel*> columns{};  ///< input columns that vary in the data
  /// Mean and standard deviation of each column [SI]; of the absolute values for speeds, feeds and
  /// the coolant state.
  Eigen::VectorXd mean{}, std{};
  Eigen::MatrixXd correlation{};
  /// Largest distance of a row of the data from the mean [1]: see Distance in range.h.
  double farthest = unset;
};

/// Residual of the fitted model.
struct Left {
  double rms = unset;  ///< rms on held-out parts, or of the fit if no part was held out [m]
  double correlation_time = unset;  ///< correlation time of the residual [s]
};

/// Error of a fitted model on readings that the fit did not use, and properties of the readings.
/// trust_of() rates the model from them.
struct Evidence {
  double error = unset;  ///< rms error on readings that the fit did not use; NaN without them [m]
  /// Rms of the readings after the mean of each run is subtracted [m].
  double uncorrected = unset;
  double duration = unset;  ///< longest time from first to last reading of a run [s]
  bool one_way = false;     ///< true if the readings change only once, in one direction
  /// True if `error` and `uncorrected` come from another record than the fit.
  bool other_record = false;
};

struct Model {
  std::string name{};
  const Channel* displacement = nullptr;
  double tolerance = unset;     ///< largest acceptable rms error [m]
  double measured_std = unset;  ///< standard deviation of the noise of a reading [m]
  InitialState initial_state = InitialState::rest;
  double sampling = unset;  ///< sampling interval of published coefficients [s]
  double offset = 0.0;      ///< displacement if all inputs are 0 [m]
  std::vector<DrivenChannel> channels{};
  std::optional<Kinematic> kinematic{};
  std::vector<Effect> effects{};
  /// Names of free parameters, or of groups such as "gains"; empty: the default of free_names().
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
/// Returns the name or unit of a parameter with "um" replaced by the unit of the displacement: see
/// record::in_unit_of().
[[nodiscard]] inline std::string in_unit_of(const Model& model, std::string_view text) {
  return model.displacement ? record::in_unit_of(*model.displacement, text) : std::string(text);
}

}  // namespace raceway::correction
