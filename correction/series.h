#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "correction/beyond.h"
#include "correction/lag.h"
#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Changes that effects make to the gain and the time constant τ of the first-order lags of a
/// channel. A channel is the contribution of one input to the displacement.
struct Answer {
  double sensor_time_constant = 0.0;  ///< time constant of the sensor [s]: see effects/sensor_lag.h
  /// Factors on gain and τ while the coolant is off.
  double off_gain = 1.0, off_time_constant = 1.0;
  /// At the speed n, τ is multiplied by f = 1/(1 + speed_factor n/10 000 rpm), and the gain is
  /// multiplied by f^gain_power: see effects/speed_dependent_time_constant.h.
  double speed_factor = 0.0, gain_power = 1.0;
  /// Factor on τ while the state of the lag falls because the input is below the state.
  double falling = 1.0;
  /// Speed range of the fit [rpm]. Beyond this range, continued() extrapolates f and f^gain_power.
  Interval speed{};

  [[nodiscard]] bool is_plain() const {
    return sensor_time_constant == 0.0 && off_gain == 1.0 && off_time_constant == 1.0 &&
           speed_factor == 0.0 && falling == 1.0;
  }
};

/// Returns the input for a speed or feed n: |n| (|n|/1000 rpm)^(exponent - 1), see Input::exponent.
[[nodiscard]] double driving_size(double value, double exponent);

/// Time record prepared for simulation. The object stores computed inputs and lag responses, so
/// that later calls do not compute them again. Several threads may use one object.
class Series {
 public:
  /// `record` must live longer than this object. Throws std::invalid_argument if the column time_s
  /// is missing or does not increase within a run.
  explicit Series(const record::Record& record);

  [[nodiscard]] const record::Record& record() const { return record_; }
  [[nodiscard]] std::size_t rows() const { return clock_.rows(); }
  [[nodiscard]] const Clock& clock() const { return clock_; }
  /// Time since the first row of the run [s].
  [[nodiscard]] std::span<const double> time() const { return time_; }
  /// Returns the median time step between two rows of a run [s]; NaN if each run has one row.
  [[nodiscard]] double sampling() const;
  /// Returns the duration of the longest run [s].
  [[nodiscard]] double duration() const;
  /// Index of the reference (zero) of the displacement in each row. Each run has one reference for
  /// each value of setup_id.
  [[nodiscard]] std::span<const int> zero() const { return zero_; }
  [[nodiscard]] int zeros() const { return zeros_; }
  [[nodiscard]] std::span<const double> speed_rpm() const { return speed_rpm_; }
  /// Returns the value of coolant_on at every row. The span is empty if the record has no such
  /// column.
  [[nodiscard]] std::span<const double> coolant() const { return coolant_; }

  using Values = std::shared_ptr<const std::vector<double>>;
  /// Returns the input at every row [SI]: a rise of temperature [K], a power [W], the absolute
  /// value of a speed or feed, or another quantity. If the input has a window with
  /// `Window::of_input`, the result is multiplied by the factor of the window. Throws
  /// std::invalid_argument if the record lacks a column of the input.
  [[nodiscard]] Values input(const Input& input) const;
  /// Returns the input at the time of the reading in each row [SI], multiplied by the factor of the
  /// window if the input has one. A displacement without lag is proportional to this result.
  [[nodiscard]] Values at_once(const Input& input) const;
  /// Returns the window factor for the time of the reading in each row [1]. The displacement is
  /// multiplied by this factor. The result is null if the input has no window, or if input()
  /// already includes the factor (`Window::of_input`).
  [[nodiscard]] Values shown_share(const Input& input) const;
  /// Returns the number of rows in which the spindle turns and the operating point is outside the
  /// range of the friction table; 0 for an input without a friction table.
  [[nodiscard]] std::size_t rows_beyond_table(const Input& input) const;

  /// Returns the response of a lag with gain 1 to this input at every row, in the SI unit of the
  /// input. If the input has a window, the response includes the factor of the window (see Window).
  [[nodiscard]] Values lag(const Input& input, double time_constant, const Answer& answer) const;
  /// Returns n^(1 - B exp(-C n)) at every row: the kinematic law (shaft/kinematic_law.h) without
  /// its factor A, with the speed n in rpm. Above the speed range `seen` of the fit, continued()
  /// extrapolates the value. At standstill, the value is 0.
  [[nodiscard]] Values kinematic(double B, double C, const Interval& seen = {}) const;
  /// Returns the response of a lag at every row [1]. The input of the lag is exp(-n/n0) while the
  /// spindle turns at the speed n, and 0 at standstill; n0 is `decay_speed_rpm`. Beyond the speed
  /// range `seen` of the fit, continued() extrapolates the input.
  [[nodiscard]] Values motor(double decay_speed_rpm, double time_constant,
                             const Interval& seen = {}) const;
  /// Returns exp(-t/τ) at every row of the first run, and 0 in later runs. t is the time since the
  /// first row, and τ the time constant.
  [[nodiscard]] Values decay(double time_constant) const;
  /// Returns 1 - exp(-t/τ) at every row. t is the time since the first row of the record, without
  /// the breaks between runs, and τ the time constant.
  [[nodiscard]] Values settling(double time_constant) const;

 private:
  using Key = std::vector<double>;
  template <typename Make>
  [[nodiscard]] Values kept(Key key, const Make& make) const;
  [[nodiscard]] double id_of(const Input& input) const;
  [[nodiscard]] std::vector<FrictionTable::Point> points_of_table(const Input& input) const;
  [[nodiscard]] std::vector<double> power(const Input& input) const;
  [[nodiscard]] std::vector<double> formula(const Input& input) const;
  [[nodiscard]] Key key_of(const Input& input) const;
  void fill(const Input& input, std::vector<double>& out) const;
  [[nodiscard]] std::vector<double> shares(const Window& window) const;
  void answer(const std::vector<double>& input, record::Course course, double time_constant,
              const Answer& answer, std::vector<double>& state) const;

  const record::Record& record_;
  Clock clock_;
  std::vector<double> time_, whole_time_, speed_rpm_, coolant_;
  std::vector<int> zero_;
  int zeros_ = 1;
  mutable std::mutex mutex_;
  mutable std::vector<std::string> inputs_;  // key of each input; its index is the id
  mutable std::map<Key, Values> kept_;
};

}  // namespace raceway::correction
