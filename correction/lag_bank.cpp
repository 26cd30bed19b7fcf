#include "correction/lag_bank.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "algebra/detail/decompositions.h"
#include "correction/alignment.h"
#include "correction/numbers.h"
#include "correction/range.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "fit/noise.h"
#include "fit/problem.h"
#include "record/digits.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double as_fast_as = 600.0;  // counts what acts at once [s]
constexpr double usual_weight = 5400.0;
constexpr double krpm = 1000.0 * rpm;
constexpr double of_friction = 1.5;  // exponent of a speed, beside 1
constexpr int cuts = 6;
constexpr double first_cut = 0.59, last_cut = 0.88;  // of the record
constexpr double favour = 4.0;  // of strengths with less error ahead, as a power
constexpr std::array speed_weights{0.1, 0.3, 1.0};
constexpr std::array strengths{0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0};

/// One column of the fit: an input through a lag.
struct LaggedInput {
  std::size_t channel = 0;
  double time_constant = 0.0;  ///< [s], 0: at once
  bool of_speed = false;
  double unit = 1.0;  ///< in which the input counts [SI]
};

class Bank {
 public:
  Bank(const Model& model, const record::Record& record, const LagBankOptions& options)
      : options_(options), record_(record), series_(record), model_(model) {
    require_bare();
    lags_ = options.time_constants.empty() ? usual_lags(series_) : options.time_constants;
    for (const double lag : lags_)
      if (!(lag >= 0.0) || !std::isfinite(lag))
        throw std::invalid_argument(
            fmt::format("lag = {:g} s: must be 0 or more, and finite", lag));
    for (const Channel* c : options.inputs) add(*c);
    collect();
  }

  Identification run() {
    accumulate();
    try_strengths();
    finish();
    return std::move(result_);
  }

 private:
  void require_bare() const {
    if (!model_.channels.empty() || model_.kinematic || !model_.effects.empty())
      throw std::invalid_argument(
          "a bank of lags replaces channels, effects and the kinematic law: remove them from the "
          "model");
    if (model_.initial_state == InitialState::free)
      throw std::invalid_argument(
          "a bank of lags starts from a machine at rest: remove initial_state = \"free\"");
    if (options_.inputs.empty())
      throw std::invalid_argument("a bank of lags needs input columns (--inputs)");
  }

  void add(const Channel& column) {
    DrivenChannel c{.name = std::string(column.variable),
                    .input = {.name = std::string(column.name), .columns = {&column}}};
    constexpr std::string_view ending = "_temperature";
    if (c.name.ends_with(ending)) c.name.erase(c.name.size() - ending.size());
    const bool of_speed = c.input.unit() == "rpm";
    add_channel(c, of_speed);
    if (!of_speed) return;
    c.name += "_of_friction";
    c.input.exponent = of_friction;
    add_channel(std::move(c), of_speed);
  }

  /// That of the file for temperatures and feeds, which go over some tens of it; else a tenth of
  /// the range of the column.
  [[nodiscard]] double unit_of(const Input& input) const {
    const Channel& column = *input.columns.front();
    if (record::is_temperature(column) || record::acts_by_amount(column)) return input.factor();
    const std::span<const double> values = record_.values(column);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high > *low ? 0.1 * (*high - *low) : input.factor();
  }

  void add_channel(DrivenChannel c, bool of_speed) {
    for (const double lag : lags_) {
      if (lag == 0.0 && of_speed) continue;
      if (lag > 0.0) c.sections.push_back({0.0, lag});
      inputs_.push_back({.channel = model_.channels.size(),
                         .time_constant = lag,
                         .of_speed = of_speed,
                         .unit = of_speed ? krpm : unit_of(c.input)});
    }
    model_.channels.push_back(std::move(c));
  }

  /// Rows with a reading, and the columns of the fit at them: first one for each zero.
  void collect() {
    const std::vector<double>& steps = series_.clock().steps;
    elapsed_.resize(steps.size());
    std::partial_sum(steps.begin(), steps.end(), elapsed_.begin());
    const std::span<const double> y = record_.values(*model_.displacement);
    for (std::size_t k = 0; k < y.size(); ++k)
      if (std::isfinite(y[k])) rows_.push_back(k);
    zeros_ = series_.zeros();
    const std::size_t count = inputs_.size() + static_cast<std::size_t>(zeros_);
    if (rows_.size() < 3 * count)
      throw std::invalid_argument(
          fmt::format("{} readings of {} are too few for {} parameters: a fit needs three or more "
                      "for each parameter",
                      rows_.size(), model_.displacement->words, count));
    x_.setZero(static_cast<Eigen::Index>(rows_.size()), static_cast<Eigen::Index>(count));
    y_.resize(x_.rows());
    for (Eigen::Index k = 0; k < x_.rows(); ++k) {
      const std::size_t row = rows_[static_cast<std::size_t>(k)];
      y_[k] = y[row] / um;
      x_(k, series_.zero()[row]) = 1.0;
    }
    for (std::size_t j = 0; j < inputs_.size(); ++j) {
      const LaggedInput& s = inputs_[j];
      const Input& input = model_.channels[s.channel].input;
      const Series::Values all =
          s.time_constant > 0.0 ? series_.lag(input, s.time_constant, {}) : series_.at_once(input);
      for (Eigen::Index k = 0; k < x_.rows(); ++k)
        x_(k, place(j)) = (*all)[rows_[static_cast<std::size_t>(k)]] / s.unit;
    }
  }

  [[nodiscard]] Eigen::Index place(std::size_t share) const {
    return zeros_ + static_cast<Eigen::Index>(share);
  }

  /// Through all runs [s].
  [[nodiscard]] double time(Eigen::Index reading) const {
    return elapsed_[rows_[static_cast<std::size_t>(reading)]];
  }

  /// Sums of products up to each cut, and over all.
  void accumulate() {
    const double end = time(x_.rows() - 1);
    Eigen::Index done = 0;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(x_.cols(), x_.cols());
    Eigen::VectorXd with_y = Eigen::VectorXd::Zero(x_.cols());
    for (int c = 0; c <= cuts; ++c) {
      step(0.8 * c / cuts, "summing the rows for each fit");
      const double share = c == cuts ? 1.0 : first_cut + (last_cut - first_cut) * c / (cuts - 1.0);
      Eigen::Index until = done;
      while (until < x_.rows() && (c == cuts || time(until) <= share * end)) ++until;
      const auto part = x_.middleRows(done, until - done);
      products.selfadjointView<Eigen::Lower>().rankUpdate(part.transpose());
      with_y += part.transpose() * y_.segment(done, until - done);
      done = until;
      sums_.push_back(
          {.readings = until, .from = share * end, .products = products, .with_y = with_y});
    }
    for (const Sums& s : sums_)
      if (s.readings < x_.cols() || (&s != &sums_.back() && s.readings == x_.rows()))
        throw std::invalid_argument(
            "the readings start too late for the fit or end too early for the test of the "
            "prediction: take readings over the whole record");
  }

  struct Sums {
    Eigen::Index readings = 0;
    double from = unset;  // [s]
    Eigen::MatrixXd products{};
    Eigen::VectorXd with_y{};
  };

  [[nodiscard]] Eigen::VectorXd solve(const Sums& s, double strength, double speed_weight) const {
    Eigen::MatrixXd m = s.products.selfadjointView<Eigen::Lower>();
    const auto readings = static_cast<double>(s.readings);
    // A zero that no reading so far tells of stays where it is.
    for (Eigen::Index z = 0; z < zeros_; ++z)
      if (m(z, z) == 0.0) m(z, z) = 1.0;
    for (std::size_t j = 0; j < inputs_.size(); ++j) {
      const double lag = std::max(inputs_[j].time_constant, as_fast_as) / usual_weight;
      const double weight = (inputs_[j].of_speed ? speed_weight : 1.0);
      m(place(j), place(j)) += strength * readings * weight * weight * lag;
    }
    return algebra::solve_symmetric(m, s.with_y);
  }

  /// [um]
  [[nodiscard]] double error_ahead(std::size_t cut, const Eigen::VectorXd& gains) const {
    const Eigen::Index rest = x_.rows() - sums_[cut].readings;
    return (y_.tail(rest) - x_.bottomRows(rest) * gains).norm() /
           std::sqrt(static_cast<double>(rest));
  }

  /// Every strength at every cut, and what each is worth.
  void try_strengths() {
    gains_.assign(sums_.size(), {});
    for (const double weight : speed_weights) {
      step(0.8, "trying ridge penalties");
      for (const double strength : strengths) {
        StrengthTried t{.strength = strength, .speed_weight = weight, .rms_ahead = 0.0};
        for (std::size_t c = 0; c < sums_.size(); ++c) {
          gains_[c].push_back(solve(sums_[c], strength, weight));
          if (c + 1 < sums_.size()) t.rms_ahead += error_ahead(c, gains_[c].back()) / cuts;
        }
        result_.strengths.push_back(t);
      }
    }
    double sum = 0.0;
    for (StrengthTried& t : result_.strengths) sum += t.share = std::pow(t.rms_ahead, -favour);
    for (StrengthTried& t : result_.strengths) {
      t.share /= sum;
      t.rms_ahead *= um;
    }
  }

  /// Gains of a fit up to a cut, over all strengths.
  [[nodiscard]] Eigen::VectorXd mean_gains(std::size_t cut) const {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(x_.cols());
    for (std::size_t k = 0; k < gains_[cut].size(); ++k)
      mean += result_.strengths[k].share * gains_[cut][k];
    return mean;
  }

  void finish() {
    double sum = 0.0;
    for (std::size_t c = 0; c + 1 < sums_.size(); ++c) {
      result_.ahead.push_back({sums_[c].from, error_ahead(c, mean_gains(c)) * um});
      sum += result_.ahead.back().rms;
    }
    result_.rms_held_out = sum / cuts;
    const Eigen::VectorXd gains = mean_gains(sums_.size() - 1);
    if (!gains.allFinite())
      throw std::invalid_argument("the fitted gains of the bank of lags are not finite");
    model_.offset = gains[0] * um;
    for (std::size_t j = 0; j < inputs_.size(); ++j) {
      DrivenChannel& c = model_.channels[inputs_[j].channel];
      const double gain = gains[place(j)] * um / inputs_[j].unit;
      if (inputs_[j].time_constant == 0.0) {
        c.feedthrough = gain;
        continue;
      }
      for (Section& s : c.sections)
        if (s.time_constant == inputs_[j].time_constant) s.gain = gain;
    }
    see(model_, record_);
    model_.left = Left{.rms = result_.rms_held_out};
    model_.evidence = evidence_on(model_, record_, result_.rms_held_out);
    // A loop over seventy gains that belong together would find anything.
    if (model_.free.empty()) model_.free = {"offset"};
    result_.model = model_;
    result_.parameters = parameters(model_);
    result_.noise = std::isfinite(model_.measured_std)
                        ? model_.measured_std
                        : fit::noise_of_neighbours(record_, *model_.displacement);
    const auto subject = aligned(model_, record_, Zero::mean);
    result_.metrics =
        metrics(record_.values(*model_.displacement), fit::predict(*subject, record_));
    const auto best = std::min_element(
        result_.strengths.begin(), result_.strengths.end(),
        [](const StrengthTried& a, const StrengthTried& b) { return a.rms_ahead < b.rms_ahead; });
    if (best->strength == strengths.front() || best->strength == strengths.back())
      result_.messages.push_back(record::note::at_bound(fmt::format(
          "the best ridge penalty, {:g}, is the {} of the tested values", best->strength,
          best->strength == strengths.front() ? "smallest" : "largest")));
  }

  void step(double share, std::string_view what) const {
    if (options_.cancelled && options_.cancelled()) throw fit::Cancelled();
    if (options_.progress) options_.progress(share, what);
  }

  const LagBankOptions& options_;
  const record::Record& record_;
  const Series series_;
  Model model_;
  std::vector<double> lags_;
  std::vector<LaggedInput> inputs_;
  std::vector<double> elapsed_;
  std::vector<std::size_t> rows_;  // with a reading
  Eigen::Index zeros_ = 1;
  Eigen::MatrixXd x_;
  Eigen::VectorXd y_;                                // [um]
  std::vector<Sums> sums_;                           // up to each cut, and over all
  std::vector<std::vector<Eigen::VectorXd>> gains_;  // of each, by strength
  Identification result_;
};

}  // namespace

std::vector<double> usual_lags(const Series& series) {
  const std::span<const double> time = series.time();
  const double duration = *std::max_element(time.begin(), time.end());
  std::vector<double> list{0.0};
  // Two digits are enough, and are read more easily.
  for (double lag = duration / 100.0; lag > 0.0 && lag <= duration / 4.0; lag *= 3.0)
    list.push_back(record::with_digits(lag, 2));
  return list;
}

Identification identify_lag_bank(const Model& model, const record::Record& record,
                                 const LagBankOptions& options) {
  return Bank(model, record, options).run();
}

}  // namespace raceway::correction
