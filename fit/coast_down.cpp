#include "fit/coast_down.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace raceway::fit {

namespace {

constexpr std::size_t largest_window = 32;  // blocks; longer windows are averaged to this first
constexpr double outlier_limit = 8.0;       // robust deviations
constexpr double gap_limit = 5.0;           // usual spacings, or half a window where that is more

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Standard deviation from the median magnitude, for residuals of which less than half are bad.
double robust_deviation(const Eigen::VectorXd& residuals) {
  const Eigen::VectorXd magnitude = residuals.cwiseAbs();
  return 1.4826 * median({magnitude.begin(), magnitude.end()});
}

/// Mean of consecutive samples; a block of one is the sample itself.
struct Block {
  double time = 0.0;
  double speed = 0.0;
  int line = 0;
  bearing::OperatingPoint point;
};

/// A parabola by least squares through consecutive blocks, about their mean time.
struct LocalParabola {
  double time;                     // mean [s]
  double speed;                    // value there [rad/s]
  double slope;                    // there [rad/s²]
  Eigen::VectorXd residual;        // measured minus parabola [rad/s]
  Eigen::VectorXd slope_gain;      // slope = slope_gain · speeds [1/s]
  Eigen::MatrixXd residual_maker;  // residual = residual_maker · speeds [1]
};

Eigen::MatrixX3d powers_of_time(std::span<const Block> blocks, double origin, double scale) {
  Eigen::MatrixX3d powers(static_cast<Eigen::Index>(blocks.size()), 3);
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const double u = (blocks[static_cast<std::size_t>(i)].time - origin) / scale;
    powers.row(i) << 1.0, u, u * u;
  }
  return powers;
}

double mean_time(std::span<const Block> blocks) {
  double sum = 0.0;
  for (const Block& b : blocks) sum += b.time;
  return sum / static_cast<double>(blocks.size());
}

Eigen::VectorXd speeds_of(std::span<const Block> blocks) {
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i)
    speeds[static_cast<Eigen::Index>(i)] = blocks[i].speed;
  return speeds;
}

LocalParabola local_parabola(std::span<const Block> blocks) {
  const double origin = mean_time(blocks);
  const double scale = blocks.back().time - blocks.front().time;
  const Eigen::MatrixX3d powers = powers_of_time(blocks, origin, scale);
  const Eigen::VectorXd speeds = speeds_of(blocks);
  const Eigen::MatrixXd inverse =
      powers.householderQr().solve(Eigen::MatrixXd::Identity(powers.rows(), powers.rows()));
  const Eigen::Vector3d c = inverse * speeds;
  LocalParabola fit;
  fit.time = origin;
  fit.speed = c[0];
  fit.slope = c[1] / scale;
  fit.slope_gain = inverse.row(1).transpose() / scale;
  fit.residual = speeds - powers * c;
  fit.residual_maker = -powers * inverse;
  fit.residual_maker.diagonal().array() += 1.0;
  return fit;
}

/// Residuals of a parabola that outliers do not bend: bisquare weights, started from the median.
Eigen::VectorXd robust_residuals(std::span<const Block> samples) {
  const Eigen::MatrixX3d powers =
      powers_of_time(samples, mean_time(samples), samples.back().time - samples.front().time);
  const Eigen::VectorXd speeds = speeds_of(samples);
  Eigen::Vector3d c(median({speeds.begin(), speeds.end()}), 0.0, 0.0);
  Eigen::VectorXd residual = speeds - powers * c;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double scale = std::max(robust_deviation(residual), 1e-9 * speeds.maxCoeff());
    const Eigen::ArrayXd u = residual.array() / (6.0 * scale);
    const Eigen::VectorXd root = (u.abs() < 1.0).select(1.0 - u.square(), 0.0).matrix();
    c = (root.asDiagonal() * powers).colPivHouseholderQr().solve(root.asDiagonal() * speeds);
    residual = speeds - powers * c;
  }
  return residual;
}

/// Marks samples far from a robust local parabola, in deviations of their part or of the whole run,
/// whichever is larger: a short part may look too good, a curved one has more than noise.
std::vector<bool> find_outliers(std::span<const Block> samples, std::size_t length) {
  const std::size_t parts = std::max<std::size_t>(1, samples.size() / length);
  std::vector<Eigen::VectorXd> residuals;
  std::vector<double> scales;
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t first = k * samples.size() / parts, last = (k + 1) * samples.size() / parts;
    residuals.push_back(robust_residuals(samples.subspan(first, last - first)));
    scales.push_back(robust_deviation(residuals.back()));
  }
  const double usual = median(scales);
  const double floor = 1e-9 * samples.front().speed;
  std::vector<bool> outlier;
  outlier.reserve(samples.size());
  for (std::size_t k = 0; k < parts; ++k)
    for (const double e : residuals[k])
      outlier.push_back(std::abs(e) > outlier_limit * std::max({scales[k], usual, floor}));
  return outlier;
}

std::vector<Block> averaged(std::span<const Block> samples, std::size_t length) {
  std::vector<Block> blocks;
  const std::size_t count = std::max<std::size_t>(1, samples.size() / length);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * samples.size() / count, last = (k + 1) * samples.size() / count;
    const Block& origin = samples[first];  // summed from here, so what is constant stays exact
    const double share = 1.0 / static_cast<double>(last - first);
    Block mean = origin;
    for (std::size_t i = first; i < last; ++i) {
      const Block& s = samples[i];
      const auto add = [share](double& sum, double value, double from) {
        sum += share * (value - from);
      };
      add(mean.time, s.time, origin.time);
      add(mean.speed, s.speed, origin.speed);
      add(mean.point.axial_load, s.point.axial_load, origin.point.axial_load);
      add(mean.point.radial_load, s.point.radial_load, origin.point.radial_load);
      add(mean.point.radial_load_z, s.point.radial_load_z, origin.point.radial_load_z);
      add(mean.point.moment_y, s.point.moment_y, origin.point.moment_y);
      add(mean.point.moment_z, s.point.moment_z, origin.point.moment_z);
      add(mean.point.temperature, s.point.temperature, origin.point.temperature);
    }
    mean.line = samples[(first + last) / 2].line;
    blocks.push_back(mean);
  }
  return blocks;
}

/// Cuts at gaps. Spacing may drift (samples per revolution), so it is judged against neighbours.
std::vector<std::span<const Block>> segments(std::span<const Block> samples, double limit) {
  std::vector<std::span<const Block>> parts;
  std::size_t first = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const std::size_t from = i > 6 ? i - 6 : 1, to = std::min(samples.size() - 1, i + 6);
    std::vector<double> spacing;
    for (std::size_t k = from; k <= to; ++k)
      spacing.push_back(samples[k].time - samples[k - 1].time);
    if (samples[i].time - samples[i - 1].time > limit * median(std::move(spacing))) {
      parts.push_back(samples.subspan(first, i - first));
      first = i;
    }
  }
  parts.push_back(samples.subspan(first));
  return parts;
}

/// Cuts a segment into windows. What is too short at the end goes to the last window.
std::vector<std::span<const Block>> windows(std::span<const Block> segment, std::size_t fewest,
                                            std::size_t most, double largest_fall) {
  std::vector<std::span<const Block>> parts;
  std::size_t first = 0;
  while (segment.size() - first >= fewest) {
    std::size_t last = first + fewest;
    while (last < segment.size() && last - first < most &&
           segment[last].speed > (1.0 - largest_fall) * segment[first].speed)
      ++last;
    if (segment.size() - last < fewest) last = segment.size();
    parts.push_back(segment.subspan(first, last - first));
    first = last;
  }
  return parts;
}

/// Standard deviation of residuals that are mostly Gaussian: Huber's proposal 2 at k = 2.5, 99 %
/// efficient without outliers. Residuals come divided by sqrt(1 - leverage).
double robust_scale(const std::vector<double>& residuals) {
  constexpr double k = 2.5;
  const double phi = std::exp(-0.5 * k * k) / std::sqrt(2.0 * pi);
  const double tail = 0.5 * std::erfc(k / std::sqrt(2.0));
  const double expected = 1.0 - 2.0 * tail - 2.0 * k * phi + 2.0 * k * k * tail;
  double square = 0.0;
  for (const double e : residuals) square += e * e;
  square /= static_cast<double>(residuals.size());
  for (int iteration = 0; iteration < 100 && square > 0.0; ++iteration) {
    double sum = 0.0;
    for (const double e : residuals) sum += std::min(e * e / square, k * k);
    const double next = square * sum / (static_cast<double>(residuals.size()) * expected);
    const bool done = std::abs(next - square) <= 1e-10 * square;
    square = next;
    if (done) break;
  }
  return std::sqrt(square);
}

/// Noise of one run: standard deviation and first-order autocorrelation of the speed samples.
struct SpeedNoise {
  double std;
  double correlation;
};

Eigen::MatrixXd correlation_matrix(Eigen::Index size, double correlation) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      matrix(i, j) = std::pow(correlation, static_cast<double>(std::abs(i - j)));
  return matrix;
}

SpeedNoise speed_noise(const std::vector<LocalParabola>& fits) {
  std::vector<double> standardised;
  for (const LocalParabola& fit : fits)
    for (Eigen::Index i = 0; i < fit.residual.size(); ++i)
      standardised.push_back(fit.residual[i] / std::sqrt(fit.residual_maker(i, i)));
  const double scale = robust_scale(standardised);
  if (!(scale > 0.0)) return {.std = 0.0, .correlation = 0.0};

  // A fit leaves residuals that are correlated even if the noise is not: with residual maker P and
  // neighbours summed by A, E[e'Ae] = tr(A P R P), E[e'e] = tr(P R P) for noise of correlation R.
  // The correlation is the one whose expected ratio is the ratio found.
  double product = 0.0, square = 0.0, count = 0.0;
  std::vector<Eigen::MatrixXd> neighbour, plain;
  for (const LocalParabola& fit : fits) {
    const Eigen::MatrixXd& p = fit.residual_maker;
    const Eigen::Index n = fit.residual.size();
    Eigen::VectorXd e(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double limit = 2.5 * scale * std::sqrt(p(i, i));
      e[i] = std::clamp(fit.residual[i], -limit, limit);
    }
    product += e.head(n - 1).dot(e.tail(n - 1));
    square += e.squaredNorm();
    count += static_cast<double>(n);
    neighbour.push_back(p.topRows(n - 1).transpose() * p.bottomRows(n - 1));
    plain.push_back(p);  // P'P = P
  }
  const auto expected = [&](double correlation) {
    double numerator = 0.0, denominator = 0.0;
    for (std::size_t w = 0; w < plain.size(); ++w) {
      const Eigen::MatrixXd r = correlation_matrix(plain[w].rows(), correlation);
      numerator += neighbour[w].cwiseProduct(r).sum();
      denominator += plain[w].cwiseProduct(r).sum();
    }
    return std::pair{numerator, denominator};
  };
  const auto ratio = [&](double correlation) {
    const auto [numerator, denominator] = expected(correlation);
    return numerator / denominator;
  };
  const double white = expected(0.0).second;
  // Only a correlation beyond twice its own scatter is believed.
  if (product / square - ratio(0.0) < 2.0 / std::sqrt(count))
    return {.std = scale, .correlation = 0.0};
  double low = 0.0, high = 0.95;
  for (int iteration = 0; iteration < 40; ++iteration) {
    const double middle = 0.5 * (low + high);
    (ratio(middle) < product / square ? low : high) = middle;
  }
  return {.std = scale * std::sqrt(white / expected(low).second), .correlation = low};
}

std::string of_run(const std::string& run) { return run.empty() ? "" : "run " + run + ": "; }

/// The first few lines of a list, for messages.
std::string lines_text(const std::vector<int>& lines) {
  std::string text = lines.size() == 1 ? "line " : "lines ";
  for (std::size_t i = 0; i < lines.size() && i < 5; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", lines[i]);
  if (lines.size() > 5) text += ", ...";
  return text;
}

void check(const CoastDownRecord& record, const Rig& rig, const CoastDownOptions& options) {
  if (!(rig.inertia > 0.0) || !std::isfinite(rig.inertia))
    throw std::invalid_argument(fmt::format(
        "inertia = {} kg m2: a coast-down becomes a torque by M = -J dw/dt; it must be above 0",
        rig.inertia));
  if (options.windows < 1 || options.fewest_samples < 5 ||
      !(options.largest_fall > 0.0 && options.largest_fall < 1.0))
    throw std::invalid_argument(
        "coast-down options: windows from 1, fewest_samples from 5, largest_fall between 0 and 1");
  for (const CoastDownSample& s : record.samples)
    if (!std::isfinite(s.time) || !std::isfinite(s.speed))
      throw std::invalid_argument(
          fmt::format("{}, line {}: time and speed must be finite numbers", record.source, s.line));
}

void add_run(CoastDownTorque& result, const CoastDownRecord& record, int run, const Rig& rig,
             const CoastDownOptions& options) {
  CoastDownRun summary;
  if (run >= 0) summary.run = record.runs.at(static_cast<std::size_t>(run));
  std::vector<std::string>& notes = result.data.notes;

  std::vector<Block> samples;
  std::vector<int> slow;
  double last_time = -std::numeric_limits<double>::infinity();
  for (const CoastDownSample& s : record.samples) {
    if (s.run != run) continue;
    if (!(s.time > last_time))
      throw std::invalid_argument(fmt::format(
          "{}, line {}: time_s = {} does not grow within {} (before: {})", record.source, s.line,
          s.time, summary.run.empty() ? "the record" : "run " + summary.run, last_time));
    last_time = s.time;
    if (s.speed > 0.0 && s.speed >= rig.minimum_speed)
      samples.push_back({.time = s.time, .speed = s.speed, .line = s.line, .point = s.point});
    else
      slow.push_back(s.line);
  }
  if (!slow.empty())
    notes.push_back(fmt::format("{}{} samples at standstill or below {:.4g} rpm left out ({})",
                                of_run(summary.run), slow.size(), rig.minimum_speed / rpm,
                                lines_text(slow)));
  const auto fewest = static_cast<std::size_t>(options.fewest_samples);
  const auto require_enough = [&](std::size_t count) {
    if (count < fewest)
      throw std::invalid_argument(
          fmt::format("{}: {}{} samples are too few for a torque, at least {} are needed",
                      record.source, of_run(summary.run), count, fewest));
  };
  require_enough(samples.size());

  const std::size_t aim =
      std::max(fewest, samples.size() / static_cast<std::size_t>(options.windows));
  const std::vector<bool> outlier =
      find_outliers(samples, std::clamp<std::size_t>(aim, 2 * fewest, 64));
  std::vector<int> outlier_lines;
  std::vector<Block> kept;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (outlier[i])
      outlier_lines.push_back(samples[i].line);
    else
      kept.push_back(samples[i]);
  }
  if (!outlier_lines.empty())
    notes.push_back(fmt::format("{}{} samples stand out of the speed curve and are left out ({})",
                                of_run(summary.run), outlier_lines.size(),
                                lines_text(outlier_lines)));
  summary.outliers = static_cast<int>(outlier_lines.size());
  require_enough(kept.size());

  const std::size_t block = std::max<std::size_t>(1, (aim + largest_window - 1) / largest_window);
  const std::size_t most = std::max(fewest, aim / block);
  const double gap = std::max(gap_limit, 0.5 * static_cast<double>(aim));
  std::vector<std::vector<Block>> segment_blocks;
  std::vector<std::span<const Block>> parts;
  for (const std::span<const Block> segment : segments(kept, gap))
    segment_blocks.push_back(averaged(segment, block));
  for (const std::vector<Block>& segment : segment_blocks) {
    const std::vector<std::span<const Block>> cut =
        windows(segment, fewest, most, options.largest_fall);
    if (cut.empty())
      notes.push_back(
          fmt::format("{}{} samples between gaps are too few for a torque, left out (line {})",
                      of_run(summary.run), segment.size() * block, segment.front().line));
    parts.insert(parts.end(), cut.begin(), cut.end());
  }
  if (parts.empty()) require_enough(0);

  std::vector<LocalParabola> fits;
  for (const std::span<const Block> part : parts) fits.push_back(local_parabola(part));
  const SpeedNoise noise = speed_noise(fits);
  summary.samples = static_cast<int>(kept.size());
  summary.speed_noise = noise.std;
  summary.correlation = noise.correlation;

  std::vector<double> stds;
  std::vector<int> driven;
  for (std::size_t w = 0; w < fits.size(); ++w) {
    const LocalParabola& fit = fits[w];
    const std::vector<Block> mean = averaged(parts[w], parts[w].size());
    const Eigen::VectorXd& gain = fit.slope_gain;
    const double slope_std =
        noise.std * std::sqrt(gain.dot(correlation_matrix(gain.size(), noise.correlation) * gain));
    Row row;
    row.point = mean.front().point;
    row.point.speed = fit.speed;
    row.time = fit.time;
    row.measured = -rig.inertia * fit.slope;
    row.std = rig.inertia * slope_std;
    row.run = run;
    row.line = parts[w][parts[w].size() / 2].line;
    if (row.measured <= 0.0 || !(fit.speed > 0.0)) {
      driven.push_back(row.line);
      continue;
    }
    stds.push_back(row.std);
    result.data.rows.push_back(row);
  }
  if (!driven.empty())
    notes.push_back(fmt::format("{}{} windows in which the speed does not fall left out ({})",
                                of_run(summary.run), driven.size(), lines_text(driven)));
  summary.rows = static_cast<int>(stds.size());
  if (!stds.empty()) {
    summary.torque_std = median(stds);
    notes.push_back(fmt::format(
        "{}{} torques from {} speed samples by local regression, M = -J dw/dt with J = {:.6g} kg "
        "m2; "
        "standard deviation {:.3g} N mm (speed {:.3g} rpm{})",
        of_run(summary.run), summary.rows, summary.samples, rig.inertia, summary.torque_std / N_mm,
        noise.std / rpm,
        noise.correlation > 0.0 ? fmt::format(", neighbours correlate {:.2f}", noise.correlation)
                                : ""));
  }
  result.runs.push_back(summary);
}

}  // namespace

CoastDownTorque coast_down_torque(const CoastDownRecord& record, const Rig& rig,
                                  const CoastDownOptions& options) {
  check(record, rig, options);
  CoastDownTorque result;
  result.data.source = record.source;
  result.data.quantity = Quantity::friction_torque;
  result.data.noise = NoiseSource::regression;
  result.data.runs = record.runs;
  result.data.notes = record.notes;
  if (record.samples.empty())
    throw std::invalid_argument(record.source + ": the coast-down record has no samples");
  std::vector<int> runs;
  for (const CoastDownSample& s : record.samples)
    if (std::find(runs.begin(), runs.end(), s.run) == runs.end()) runs.push_back(s.run);
  for (const int run : runs) add_run(result, record, run, rig, options);
  if (result.data.rows.empty())
    throw std::invalid_argument(record.source + ": the speed falls nowhere, so there is no torque");
  return result;
}

}  // namespace raceway::fit
