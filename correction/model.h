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
/// predicted displacement is a sum of first-order lags and of an instant displacement that depends
/// on the speed. Temperatures, powers, speeds and feeds drive the lags.
namespace raceway::correction {

using record::Channel;

class OwnEffect;

/// Factor that multiplies the input or the displacement of a channel, as a function of an axis
/// position. The window has four points. The factor is 0 outside the two outer points, 1 between
/// the two inner points, and linear between an outer and an inner point.
struct Window {
  const Channel* column = nullptr;  ///< position of the axis
  /// Four rising positions [SI]; infinite on a side without a limit.
  std::array<double, 4> points{};
  /// True: the factor multiplies the input before the lags. Set true if heat arises only while the
  /// axis is in the window. False: the factor multiplies the displacement. Set false if a machine
  /// part moves the tool only while the axis is in the window.
  bool of_input = false;

  [[nodiscard]] double operator()(double position) const;
  /// Returns the limits of the window as text, in the unit of the column, such as "300..600", or
  /// "300.." if there is no upper limit. If the factor rises or falls gradually, the text contains
  /// all four points.
  [[nodiscard]] std::string range_text() const;
};

/// Coordinate on one axis of a friction table: a constant, or the value in a column of the record.
struct TableCoordinate {
  double value = unset;             ///< constant [SI]
  const Channel* column = nullptr;  ///< null: the coordinate is the constant `value`
};

/// Quantity that drives a channel of the displacement model.
///
/// For a temperature, the input is its change since the first row of the run. For a feed, a speed
/// or the coolant state, the input is the absolute value. Other columns keep their sign.
struct Input {
  std::string name{};  ///< "power_W", a column name, or the id of a user-defined effect
  std::vector<const Channel*> columns{};  ///< the mean of these columns is the input
  /// Reference temperature; null: none. The change of this temperature since the first row of the
  /// run is subtracted from the input.
  const Channel* reference = nullptr;
  /// Exponent for a speed n: the input is n (n/1000 rpm)^(exponent - 1). An exponent above 1
  /// describes heat that rises faster than n.
  double exponent = 1.0;
  /// Speed range of the fit [SI]. Above this range, continued() extrapolates the power law with
  /// `exponent`.
  Interval seen{};
  /// Friction table of a power input; null for other inputs. The power is the torque from the table
  /// times the speed.
  std::shared_ptr<const FrictionTable> table{};
  /// Coordinates on the other axes of `table`.
  TableCoordinate axial_load{}, radial_load{}, temperature{};
  Interval within{};  ///< range to which a calculated power is limited [W]
  std::optional<Window> window{};
  /// User-defined formula that computes the input from columns.
  std::shared_ptr<const OwnEffect> formula{};
  std::vector<double> formula_values{};

  [[nodiscard]] bool is_power() const { return table != nullptr; }
  /// Returns true if no column, friction table or formula defines the input.
  [[nodiscard]] bool is_none() const { return columns.empty() && !table && !formula; }
  /// Returns the unit of the input, such as "m/min". Model files give gains per this unit.
  /// key_unit() returns this unit in the form for keys of model files, such as "m_min". factor()
  /// returns the SI value of this unit.
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
  /// Factor that multiplies the contribution of the channel, for example to adapt the model to
  /// another spindle of the same type.
  double scale = 1.0;
  /// Delay element, whose gain and time constant depend on the power or load. If it is set,
  /// `sections` are not used.
  std::optional<DelayElement> element{};
  /// Transfer function with published coefficients for one sampling time. If it is set, `sections`
  /// are not used.
  std::optional<TransferFunction> printed{};
};

/// Law of the kinematic displacement u [um] at the speed n [rpm], u = A n^(1 - B exp(-C n)): see
/// shaft/kinematic_law.h.
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
  std::vector<double> values{};           ///< parameter values in the units that EffectCard states
  /// User-defined effect; null for an effect of the catalogue.
  std::shared_ptr<const OwnEffect> own{};
  /// True: the model does not use this user-defined effect, but diagnose() and add() can test it.
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
  /// Column of the input; null if the input is the power of a channel.
  const Channel* column = nullptr;
  std::string name{};  ///< name of the column or the channel
  /// Limits of the input [SI]. For a temperature, these are absolute values [K], not changes.
  double lower = unset, upper = unset;
  /// For a temperature: longest time during which the reading was constant [s]; NaN: unknown.
  double still = unset;
};

/// Distribution of all inputs in the data of the fit. The distribution shows which combinations of
/// inputs never occurred, even if each input is within its own range.
struct SeenTogether {
  std::vector<const Channel*> columns{};  ///< input columns that vary in the data
  /// Mean and standard deviation of each column [SI]. For speeds, feeds and the coolant state, the
  /// absolute values are used.
  Eigen::VectorXd mean{}, std{};
  Eigen::MatrixXd correlation{};
  /// Largest distance of a row of the data from the mean [1]: see Distance in range.h.
  double farthest = unset;
};

/// Residual of the fitted model.
struct Left {
  /// Rms residual on held-out parts [m]; on all fitted data if no part was held out.
  double rms = unset;
  double correlation_time = unset;  ///< correlation time of the residual [s]
};

/// Error of a fitted model on readings that the fit did not use, and properties of the readings.
/// trust_of() rates the model from these values.
struct Evidence {
  /// Rms error on readings that the fit did not use [m]; NaN if the fit used all readings.
  double error = unset;
  /// Rms of the readings after the mean of each run is subtracted [m].
  double uncorrected = unset;
  double duration = unset;  ///< longest time from first to last reading of a run [s]
  bool one_way = false;     ///< true if the readings only rise or only fall, as in a warm-up
  /// True if `error` and `uncorrected` were computed from a record that the fit did not use.
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
  /// Names of free parameters, or of groups such as "gains". If the list is empty, free_names()
  /// selects the free parameters.
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
