#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algebra/detail/decompositions.h"
#include "correction/baseline.h"
#include "correction/series.h"
#include "record/digits.h"
#include "record/median.h"

namespace raceway::correction {
namespace {

/// A record on an even grid, run after run.
struct Even {
  double step = unset;
  std::vector<double> y;                    ///< since the first reading of the run [um]
  std::vector<std::vector<double>> inputs;  ///< by input, in the units of the files
  std::vector<std::size_t> into_run;        ///< how many points of its run came before
  double first_reading = 0.0;               ///< [m]
};

/// Straight between two rows; `at` moves on.
double between(std::span<const double> time, std::span<const double> values,
               const std::vector<std::size_t>& rows, std::size_t& at, double t) {
  while (at + 2 < rows.size() && time[rows[at + 1]] < t) ++at;
  const double t0 = time[rows[at]], t1 = time[rows[at + 1]];
  const double share = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
  return (1.0 - share) * values[rows[at]] + share * values[rows[at + 1]];
}

class Grid {
 public:
  Grid(const Model& model, const std::vector<DrivenChannel>& channels, const record::Record& record)
      : record_(record),
        time_(record.values(record::time)),
        read_(record.values(*model.displacement)),
        channels_(channels) {
    const Series series(record);
    for (const DrivenChannel& c : channels) inputs_.push_back(series.input(c.input));
    even_.inputs.resize(channels.size());
  }

  Even made() {
    std::vector<std::vector<std::size_t>> runs;  // rows that were read
    std::vector<double> steps;
    for (std::size_t k = 0; k < time_.size(); ++k) {
      if (k == 0 || record_.run_of(k) != record_.run_of(k - 1)) runs.emplace_back();
      if (!std::isfinite(read_[k])) continue;
      if (!runs.back().empty()) steps.push_back(time_[k] - time_[runs.back().back()]);
      runs.back().push_back(k);
    }
    if (steps.size() < 3) throw std::invalid_argument("too few readings");
    even_.step = record::with_digits(record::median(steps), 9);
    for (const std::vector<std::size_t>& run : runs)
      if (run.size() > 2) {
        if (even_.y.empty()) even_.first_reading = read_[run.front()];
        add(run);
      }
    return std::move(even_);
  }

 private:
  void add(const std::vector<std::size_t>& run) {
    std::vector<std::size_t> all(run.back() - run.front() + 1);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = run.front() + k;
    std::vector<std::size_t> at(inputs_.size(), 0);
    std::size_t reading = 0, count = 0;
    const double end = time_[run.back()] + 1e-9 * even_.step;
    for (;; ++count) {
      const double t = time_[run.front()] + static_cast<double>(count) * even_.step;
      if (t > end) break;
      even_.y.push_back((between(time_, read_, run, reading, t) - read_[run.front()]) / um);
      for (std::size_t j = 0; j < inputs_.size(); ++j)
        even_.inputs[j].push_back(between(time_, *inputs_[j], all, at[j], t) /
                                  channels_[j].input.factor());
      even_.into_run.push_back(count);
    }
  }

  const record::Record& record_;
  std::span<const double> time_, read_;
  const std::vector<DrivenChannel>& channels_;
  std::vector<Series::Values> inputs_;
  Even even_;
};

/// Numbers of a row: readings before it, inputs of it and before it, one.
class Row {
 public:
  Row(const Even& even, int order) : even_(even), order_(static_cast<std::size_t>(order)) {}

  [[nodiscard]] Eigen::Index size() const {
    return static_cast<Eigen::Index>(order_ + even_.inputs.size() * (order_ + 1) + 1);
  }
  [[nodiscard]] bool has_past(std::size_t k) const { return even_.into_run[k] >= order_; }

  template <typename Out>
  void fill(std::size_t k, const std::vector<double>& y, Out&& out) const {
    Eigen::Index at = 0;
    for (std::size_t i = 1; i <= order_; ++i) out[at++] = y[k - i];
    for (const std::vector<double>& u : even_.inputs)
      for (std::size_t i = 0; i <= order_; ++i) out[at++] = u[k - i];
    out[at] = 1.0;
  }

 private:
  const Even& even_;
  std::size_t order_;
};

/// By least squares of the one-step prediction, over the points up to `end`.
Eigen::VectorXd one_step_fit(const Even& even, const Row& row, std::size_t end) {
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < end; ++k)
    if (row.has_past(k)) points.push_back(k);
  if (static_cast<Eigen::Index>(points.size()) < 3 * row.size())
    throw std::invalid_argument(
        "too few readings to fit the parameters of the ARX model: use a longer record or fewer "
        "inputs");
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(points.size()), row.size());
  Eigen::VectorXd y(columns.rows());
  for (std::size_t i = 0; i < points.size(); ++i) {
    row.fill(points[i], even.y, columns.row(static_cast<Eigen::Index>(i)));
    y[static_cast<Eigen::Index>(i)] = even.y[points[i]];
  }
  return algebra::minimum_norm_solution(columns, y);
}

/// From the readings before each point, or from nothing but the first ones of each run.
std::vector<double> predicted(const Even& even, const Row& row, const Eigen::VectorXd& numbers,
                              bool from_readings) {
  std::vector<double> y = even.y;
  Eigen::VectorXd x(row.size());
  std::vector<double> result(y.size(), unset);
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!row.has_past(k)) continue;
    row.fill(k, y, x);
    result[k] = numbers.dot(x);
    if (!from_readings) y[k] = result[k];
  }
  return result;
}

Metrics metrics_um(std::span<const double> measured, const std::vector<double>& simulated) {
  std::vector<double> a, b;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    a.push_back(measured[k] * um);
    b.push_back(simulated[k] * um);
  }
  return metrics(a, b);
}

void find_poles(const Eigen::VectorXd& numbers, int order, double step, ArxFit& fit) {
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
  companion.row(0) = numbers.head(order).transpose();
  for (int i = 1; i < order; ++i) companion(i, i - 1) = 1.0;
  const Eigen::VectorXcd z = algebra::eigenvalues(companion);
  fit.poles.assign(z.begin(), z.end());
  std::sort(fit.poles.begin(), fit.poles.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  fit.stable = std::abs(fit.poles.front()) < 1.0;
  for (const std::complex<double>& pole : fit.poles) {
    const bool decays = std::abs(pole.imag()) < 1e-12 && pole.real() > 0.0 && pole.real() < 1.0;
    fit.time_constants.push_back(decays ? -step / std::log(pole.real()) : unset);
  }
}

/// Each input through a transfer function of its own; all have one denominator.
std::vector<DrivenChannel> transfer_functions(const Eigen::VectorXd& numbers, int order,
                                              std::vector<DrivenChannel> channels, double step) {
  std::vector<double> denominator{1.0};
  for (int i = 0; i < order; ++i) denominator.push_back(record::with_digits(-numbers[i], 15));
  Eigen::Index at = order;
  for (DrivenChannel& c : channels) {
    TransferFunction f{.numerator = {}, .denominator = denominator, .sampling = step};
    for (int i = 0; i <= order; ++i)
      f.numerator.push_back(record::with_digits(numbers[at++], 15) * um / c.input.factor());
    c.printed = std::move(f);
    c.feedthrough = 0.0;
  }
  return channels;
}

/// Steady-state response to the constant of the equation [um]: the zero of the readings.
double settled_constant(const Even& even, const Row& row, const Eigen::VectorXd& numbers) {
  double left = 1.0;
  const auto inputs = static_cast<Eigen::Index>(even.inputs.size());
  const Eigen::Index order = (row.size() - 1 - inputs) / (inputs + 1);
  for (Eigen::Index i = 0; i < order; ++i) left -= numbers[i];
  return left > 0.0 ? numbers[row.size() - 1] / left : 0.0;
}

ArxFit fit_of(const Even& even, int order, const std::vector<DrivenChannel>& channels) {
  ArxFit fit{.order = order};
  const Row row(even, order);
  const Eigen::VectorXd numbers = one_step_fit(even, row, even.y.size());
  fit.one_step = metrics_um(even.y, predicted(even, row, numbers, true));
  const std::vector<double> simulated = predicted(even, row, numbers, false);
  fit.simulated = metrics_um(even.y, simulated);
  fit.offset = even.first_reading + settled_constant(even, row, numbers) * um;
  find_poles(numbers, order, even.step, fit);
  fit.channels = transfer_functions(numbers, order, channels, even.step);
  const std::size_t half = even.y.size() / 2;
  std::vector<double> whole = predicted(even, row, one_step_fit(even, row, half), false);
  std::fill_n(whole.begin(), half, unset);
  fit.second_half = metrics_um(even.y, whole);
  return fit;
}

}  // namespace

const ArxFit* ArxBaseline::best() const {
  const ArxFit* best = nullptr;
  for (const ArxFit& f : fits)
    if (f.stable && std::isfinite(f.second_half.rms) &&
        (!best || f.second_half.rms < best->second_half.rms))
      best = &f;
  return best;
}

Model with_arx(const Model& model, const ArxBaseline& baseline, const ArxFit& fit) {
  Model with{.name = model.name,
             .displacement = model.displacement,
             .tolerance = model.tolerance,
             .measured_std = model.measured_std,
             .sampling = baseline.sampling,
             .offset = fit.offset,
             .channels = fit.channels};
  return with;
}

ArxBaseline arx_baseline(const Model& model, const std::vector<const Channel*>& offered,
                         const record::Record& record, int lowest, int highest) {
  ArxBaseline result;
  std::vector<DrivenChannel> channels = bare_channels(model, offered, result.messages);
  for (DrivenChannel& c : channels)
    if (c.input.window && !c.input.window->of_input) {
      result.messages.push_back(record::note::limits(
          fmt::format("channel {}: the window of this channel scales the displacement, which is "
                      "not possible in an ARX model; the window is ignored",
                      c.name),
          {.key = c.name}));
      c.input.window.reset();
    }
  for (const DrivenChannel& c : channels) result.inputs.push_back(c.name);
  const Even even = Grid(model, channels, record).made();
  result.sampling = even.step;
  result.rows = even.y.size();
  for (int order = lowest; order <= highest; ++order)
    result.fits.push_back(fit_of(even, order, channels));
  return result;
}

}  // namespace raceway::correction
