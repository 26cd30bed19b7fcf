#include "correction/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "correction/detail/learnt_parts.h"
#include "correction/series.h"
#include "correction/simulation.h"

namespace raceway::correction {
namespace {

constexpr double gate = 5.0;             // standard deviations
constexpr int refused_in_a_row = 3;      // are no more the probe's fault
constexpr double weight_of_level = 8.0;  // readings that the expectation counts as
constexpr double most_of_level = 32.0;   // readings that the level remembers
constexpr double least_level = 0.1;
constexpr std::size_t judged = 8;                // last readings that tell whether the model holds
constexpr double chi_squared_of_judged = 26.12;  // of 8, exceeded in 1 of 1000
constexpr double horizon = 30.0 * 24.0 * 3600.0;
constexpr std::size_t the_zero = 0;  // place among the unknowns

/// How large what the model leaves is, over what was expected of it, from innovations.
///
/// Of an innovation e with variances s of what the model leaves and r² of the reading, e² - r²
/// estimates level² s, with a variance as (level² s + r²)²: readings are weighted by how much of
/// their variance is s.
class Level {
 public:
  [[nodiscard]] double squared() const {
    return std::max((weight_of_level + sum_) / (weight_of_level + weights_),
                    least_level * least_level);
  }
  void learn(double innovation, double variance, double noise) {
    const double share = variance / (variance + noise / squared());
    const double weight = share * share;
    const double keep = weights_ < most_of_level ? 1.0 : 1.0 - 1.0 / most_of_level;
    sum_ = keep * sum_ + weight * (innovation * innovation - noise) / variance;
    weights_ = keep * weights_ + weight;
  }

 private:
  double sum_ = 0.0, weights_ = 0.0;
};

/// Sums of squares behind ErrorBetween.
struct Squares {
  double first = 0.0, zeroed = 0.0, learnt = 0.0;
};

/// Row by row; knows the rows before alone.
class Learner {
 public:
  Learner(const Model& model, const record::Record& record, const LearningOptions& options)
      : model_(model), options_(options), series_(record) {
    read_ = record.values(*model.displacement);
    if (std::all_of(read_.begin(), read_.end(), [](double v) { return std::isnan(v); }))
      throw std::invalid_argument(fmt::format("{} has no reading: there is nothing to learn from",
                                              model.displacement->name));
    result_.tolerance = model.tolerance;
    result_.misfit = chosen(options.misfit, model.tolerance, usual_misfit);
    result_.reading_std = chosen(options.reading_std, model.measured_std, usual_reading_std);
    noise_ = result_.reading_std * result_.reading_std;
    plain_.resize(series_.rows());
    simulate(model_, series_, plain_);
    parts_ = learnt_parts(model_, series_, options_, result_.misfit);
    std::vector<Unknown> unknowns = zero_and_misfits(model_, result_.misfit);
    first_part_ = unknowns.size();
    for (const LearntPart& p : parts_) unknowns.push_back(p.unknown);
    filter_.emplace(std::move(unknowns));
  }

  Learning run() {
    result_.predicted.assign(series_.rows(), unset);
    result_.std.assign(series_.rows(), unset);
    for (std::size_t row = 0; row < series_.rows(); ++row) {
      if (row == 0 || series_.zero()[row] != series_.zero()[row - 1]) begin_run(row);
      if (!std::isfinite(plain_[row])) continue;
      predict(row);
      if (std::isnan(read_[row])) continue;
      if (is_offered(row))
        offer(row);
      else if (has_zero_)
        judge(row);
    }
    finish();
    return std::move(result_);
  }

 private:
  static double chosen(double given, double of_model, double usual) {
    if (std::isfinite(given)) return given;
    return std::isfinite(of_model) ? of_model : usual;
  }

  /// Of the unknowns at a row.
  [[nodiscard]] const std::vector<double>& weights(std::size_t row) {
    weights_.clear();
    for (std::size_t k = 0; k < first_part_; ++k)
      weights_.push_back(filter_->unknowns()[k].rate_of < 0 ? 1.0 : 0.0);
    for (const LearntPart& p : parts_) weights_.push_back(p.weights[row]);
    return weights_;
  }

  /// What the machine did meanwhile is unknown, its gains are the same.
  void begin_run(std::size_t row) {
    for (std::size_t k = 0; k < first_part_; ++k) filter_->reset(k);
    updated_ = series_.time()[row];
    offered_ = unset;
    learnt_.reset();
    has_zero_ = false;
    refused_ = 0;
  }

  void predict(std::size_t row) {
    const UnknownsFilter::Expected e =
        filter_->expected(weights(row), series_.time()[row] - updated_);
    result_.predicted[row] = plain_[row] + e.mean;
    variance_ = e.variance;
    if (!has_zero_) return;
    result_.std[row] = std::sqrt(level_.squared() * e.variance);
    if (!(result_.std[row] > result_.tolerance)) return;
    ++result_.rows_beyond_tolerance;
    double& good_for = result_.readings[*learnt_].good_for;
    if (std::isnan(good_for)) good_for = series_.time()[row] - updated_;
  }

  [[nodiscard]] bool is_offered(std::size_t row) const {
    constexpr double rounding = 1e-6;  // of the interval
    return std::isnan(offered_) || refused_ > 0 ||
           series_.time()[row] - offered_ >= (1.0 - rounding) * options_.every;
  }

  void offer(std::size_t row) {
    offered_ = series_.time()[row];
    const double off = read_[row] - result_.predicted[row];
    OfferedReading reading{.row = row,
                           .reading = read_[row],
                           .predicted = result_.predicted[row],
                           .std = std::sqrt(level_.squared() * variance_ + noise_)};
    const bool wild = has_zero_ && std::abs(off) > gate * reading.std;
    const bool agrees = refused_ > 0 && std::abs(off - refused_off_) <= gate * reading.std;
    if (wild && !agrees && refused_ + 1 < refused_in_a_row) {
      ++refused_;
      refused_off_ = off;
      result_.readings.push_back(reading);
      return;
    }
    reading.learnt = true;
    reading.zeroed = wild;
    result_.readings.push_back(reading);
    learnt_ = result_.readings.size() - 1;
    take(row, off);
  }

  /// Learns the reading of a row that is off by so much.
  void take(std::size_t row, double off) {
    filter_->advance(series_.time()[row] - updated_);
    updated_ = series_.time()[row];
    if (result_.readings.back().zeroed) {
      filter_->reset(the_zero);
      is_due(jumped, row,
             fmt::format("the readings jump by {:.3g} {}: a part of the setup was clamped again or "
                         "displaced, or the model is not valid",
                         off / um, unit_of(model_)));
    } else if (has_zero_) {
      remember(off, row);
    }
    refused_ = 0;
    const double difference = read_[row] - plain_[row];
    filter_->learn(weights(row), difference, std::sqrt(noise_ / level_.squared()));
    if (!has_zero_) first_zero_ = difference;
    last_zero_ = difference;
    has_zero_ = true;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (filter_->at_bound(first_part_ + k))
        is_due(bounded + k, row,
               fmt::format("the learnt gain of {} has reached its bound", parts_[k].unknown.name));
  }

  /// What an innovation says of the model: of its level, and whether it still holds.
  void remember(double off, std::size_t row) {
    level_.learn(off, variance_, noise_);
    last_.push_back(off * off / (variance_ + noise_));  // by what the model promised
    if (last_.size() < judged) return;
    if (last_.size() > judged) last_.erase(last_.begin());
    double sum = 0.0;
    for (const double s : last_) sum += s;
    if (sum > chi_squared_of_judged)
      is_due(too_far, row,
             fmt::format("{} consecutive readings have {:.2g} times the RMS error that is expected "
                         "for a model error of {:.3g} {}",
                         judged, std::sqrt(sum / static_cast<double>(judged)), result_.misfit / um,
                         unit_of(model_)));
  }

  /// Each reason once, at its first row.
  void is_due(std::size_t kind, std::size_t row, std::string reason) {
    if (std::find(told_.begin(), told_.end(), kind) != told_.end()) return;
    told_.push_back(kind);
    result_.due.push_back({row, std::move(reason)});
  }

  /// A reading that was not offered tells how good the prediction is.
  void judge(std::size_t row) {
    const auto square = [](double v) { return v * v; };
    const double off = read_[row] - plain_[row];
    squares_.first += square(off - first_zero_);
    squares_.zeroed += square(off - last_zero_);
    squares_.learnt += square(read_[row] - result_.predicted[row]);
    ++result_.error.readings;
  }

  void finish() {
    if (result_.error.readings > 0) {
      const auto n = static_cast<double>(result_.error.readings);
      result_.error.first = std::sqrt(squares_.first / n);
      result_.error.zeroed = std::sqrt(squares_.zeroed / n);
      result_.error.learnt = std::sqrt(squares_.learnt / n);
    }
    result_.level = std::sqrt(level_.squared());
    if (has_zero_ && std::isfinite(plain_.back())) result_.next_reading = until_unsure();
    std::vector<double> values;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      values.push_back(filter_->value(first_part_ + k));
      result_.gains.push_back({.name = parts_[k].unknown.name,
                               .value = values.back(),
                               .std = result_.level * filter_->std(first_part_ + k),
                               .is_lag = parts_[k].is_lag,
                               .at_bound = filter_->at_bound(first_part_ + k)});
    }
    result_.model = with_learnt(model_, parts_, values, filter_->value(the_zero), result_.misfit);
  }

  /// From the last row on, all that drives as it is there.
  [[nodiscard]] double until_unsure() {
    if (std::isnan(result_.tolerance)) return unset;
    const std::size_t row = series_.rows() - 1;
    const double now = series_.time()[row] - updated_;
    const std::vector<double> h = weights(row);
    const auto unsure = [&](double ahead) {
      return std::sqrt(level_.squared() * filter_->expected(h, now + ahead).variance) >
             result_.tolerance;
    };
    if (unsure(0.0)) return 0.0;
    double low = 0.0, high = horizon;
    if (!unsure(high)) return std::numeric_limits<double>::infinity();
    while (high - low > 1.0) {
      const double middle = 0.5 * (low + high);
      (unsure(middle) ? high : low) = middle;
    }
    return low;
  }

  enum Kind : std::size_t { jumped, too_far, bounded };

  const Model& model_;
  LearningOptions options_;
  Series series_;
  std::span<const double> read_;
  double noise_ = unset;  // variance of a reading [m²]
  std::vector<double> plain_;
  std::vector<LearntPart> parts_;
  std::size_t first_part_ = 0;  // place among the unknowns
  std::vector<double> weights_;
  std::optional<UnknownsFilter> filter_;
  Level level_;
  std::vector<double> last_;  // squares of innovations over what was promised
  std::vector<std::size_t> told_;
  // Of the run:
  double updated_ = 0.0;     // time that the filter stands at [s]
  double offered_ = unset;   // time of the last reading that was offered [s]
  double variance_ = unset;  // of the prediction of the row at hand, level 1
  bool has_zero_ = false;
  std::optional<std::size_t> learnt_;  // the last one
  int refused_ = 0;                    // in a row, the last ones
  double refused_off_ = unset;
  double first_zero_ = 0.0, last_zero_ = 0.0;
  Squares squares_;
  Learning result_;
};

}  // namespace

Learning learn(const Model& model, const record::Record& record, const LearningOptions& options) {
  return Learner(model, record, options).run();
}

}  // namespace raceway::correction
