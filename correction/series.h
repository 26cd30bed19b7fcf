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

/// Response of a channel that is more than a lag.
struct Answer {
  double sensor_time_constant = 0.0;               ///< [s]: the input is T (1 + it s)
  double off_gain = 1.0, off_time_constant = 1.0;  ///< ratios where coolant_on is 0
  double speed_factor = 0.0, gain_power = 1.0;     ///< s and g of the card
  double falling = 1.0;                            ///< ratio where the input is below the state
  Interval speed{};                                ///< that was seen [rpm]: s and g go on beyond it

  [[nodiscard]] bool is_plain() const {
    return sensor_time_constant == 0.0 && off_gain == 1.0 && off_time_constant == 1.0 &&
           speed_factor == 0.0 && falling == 1.0;
  }
};

/// Effective size of a speed or feed that drives a channel, without its sign: see Input::exponent.
[[nodiscard]] double driving_size(double value, double exponent);

/// A record over time as the models of this folder need it: the time between its rows, inputs
/// counted from the first row of each run, and the answers of lags to them, kept as they are asked
/// for. One may be shared by several threads.
class Series {
 public:
  /// `record` outlives it. Throws std::invalid_argument for time that goes back, or is missing.
  explicit Series(const record::Record& record);

  [[nodiscard]] const record::Record& record() const { return record_; }
  [[nodiscard]] std::size_t rows() const { return clock_.rows(); }
  [[nodiscard]] const Clock& clock() const { return clock_; }
  /// Time since the first row of the run [s].
  [[nodiscard]] std::span<const double> time() const { return time_; }
  /// Index of the zero of the displacement for each row: one per run and clamping state.
  [[nodiscard]] std::span<const int> zero() const { return zero_; }
  [[nodiscard]] int zeros() const { return zeros_; }
  [[nodiscard]] std::span<const double> speed_rpm() const { return speed_rpm_; }
  /// Empty where coolant_on is not recorded.
  [[nodiscard]] std::span<const double> coolant() const { return coolant_; }

  using Values = std::shared_ptr<const std::vector<double>>;
  /// Input at every row, SI: a rise of temperature [K], a power [W], a speed, a feed, times the
  /// share of a window of the input. Throws
  /// std::invalid_argument for a column that the record lacks.
  [[nodiscard]] Values input(const Input& input) const;
  /// Input of a part that answers at once, as the reading in each row sees it; with its window.
  [[nodiscard]] Values at_once(const Input& input) const;
  /// Share with which the window of an input lets its channel act, as the reading in each row sees
  /// it; null for an input without a window of the displacement.
  [[nodiscard]] Values shown_share(const Input& input) const;
  /// Rows at which it turns and the power lies outside the axes of its friction table.
  [[nodiscard]] std::size_t rows_beyond_table(const Input& input) const;

  /// State of a lag of that input, in its unit; with its window.
  [[nodiscard]] Values lag(const Input& input, double time_constant, const Answer& answer) const;
  /// n^(1 - B exp(-C n)), of speed in rpm. Above the speeds that were seen it is continued(); below
  /// them it ends at rest, where it is known to be 0.
  [[nodiscard]] Values kinematic(double B, double C, const Interval& seen = {}) const;
  /// Lag of exp(-n/n0) where it turns, else of 0; beyond the speeds that were seen continued().
  [[nodiscard]] Values motor(double decay_speed_rpm, double time_constant,
                             const Interval& seen = {}) const;
  /// exp(-t/tau) from the first row of the first run; 0 in later ones.
  [[nodiscard]] Values decay(double time_constant) const;
  /// 1 - exp(-t/tau) from the first row of the record on, through all runs.
  [[nodiscard]] Values settling(double time_constant) const;

 private:
  using Key = std::vector<double>;
  template <typename Make>
  [[nodiscard]] Values kept(Key key, const Make& make) const;
  [[nodiscard]] double id_of(const Input& input) const;
  [[nodiscard]] std::vector<FrictionTable::Point> points_of_table(const Input& input) const;
  [[nodiscard]] std::vector<double> power(const Input& input) const;
  [[nodiscard]] std::vector<double> formula(const Input& input) const;
  /// Key of the stored values of `input`.
  [[nodiscard]] Key key_of(const Input& input) const;
  /// Input at every row, without a window.
  void fill(const Input& input, std::vector<double>& out) const;
  /// Share of a window at every row.
  [[nodiscard]] std::vector<double> shares(const Window& window) const;
  void answer(const std::vector<double>& input, record::Course course, double time_constant,
              const Answer& answer, std::vector<double>& state) const;

  const record::Record& record_;
  Clock clock_;
  std::vector<double> time_, whole_time_, speed_rpm_, coolant_;
  std::vector<int> zero_;
  int zeros_ = 1;
  mutable std::mutex mutex_;
  mutable std::vector<std::string> inputs_;  // what ids stand for
  mutable std::map<Key, Values> kept_;
};

}  // namespace raceway::correction
