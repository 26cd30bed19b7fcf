#include "tolerance/residual_course.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway::tolerance {
namespace {

constexpr std::size_t most_intervals = 5;
constexpr double far_off = 1.5;       // times the rms: an interval that is shown, or
constexpr double near_the_top = 0.9;  // of the largest, as a swing is nowhere 1.5 times its rms
constexpr double as_good = 0.85;      // of the best correlation: the period is the shortest such
constexpr double comes_back = 0.3;    // correlation after a period that is one
constexpr int grid_points = 512;

/// On an even grid over the record; straight between means.
std::vector<double> evenly(const fit::Means& means, const Eigen::VectorXd& left, double& step) {
  const double begin = means.list.front().time, end = means.list.back().time;
  step = (end - begin) / (grid_points - 1);
  std::vector<double> result;
  std::size_t k = 0;
  for (int i = 0; i < grid_points; ++i) {
    const double t = begin + i * step;
    while (k + 2 < means.list.size() && means.list[k + 1].time < t) ++k;
    const double t0 = means.list[k].time, t1 = means.list[k + 1].time;
    const double share = t1 > t0 ? std::clamp((t - t0) / (t1 - t0), 0.0, 1.0) : 0.0;
    const auto at = static_cast<Eigen::Index>(k);
    result.push_back((1.0 - share) * left[at] + share * left[at + 1]);
  }
  return result;
}

double correlation_after(const std::vector<double>& r, std::size_t lag) {
  double product = 0.0, first = 0.0, second = 0.0;
  for (std::size_t i = lag; i < r.size(); ++i) {
    product += r[i] * r[i - lag];
    first += r[i] * r[i];
    second += r[i - lag] * r[i - lag];
  }
  return first > 0.0 && second > 0.0 ? product / std::sqrt(first * second) : 0.0;
}

/// The lag of the first maximum behind the first minimum that is as good as the best, where it
/// comes back often enough to be a period: multiples of a period are as good as it. NaN where none
/// is.
double period_of(const std::vector<double>& correlation) {
  const std::size_t end = correlation.size() * 2 / 3;
  std::size_t k = 0;
  while (k < end && correlation[k] >= 0.0) ++k;
  double best = comes_back;
  for (std::size_t i = k; i < end; ++i) best = std::max(best, correlation[i]);
  for (std::size_t i = k + 1; i + 1 < end; ++i)
    if (correlation[i] > comes_back && correlation[i] >= as_good * best &&
        correlation[i] >= correlation[i - 1] && correlation[i] >= correlation[i + 1])
      return static_cast<double>(i);
  return unset;
}

}  // namespace

verdict::Course course_of(const fit::Means& means, const Eigen::VectorXd& left) {
  verdict::Course course;
  if (left.size() < 8) return course;
  double step = 0.0;
  std::vector<double> r = evenly(means, left, step);
  double mean = 0.0, square = 0.0;
  for (const double v : r) mean += v / static_cast<double>(r.size());
  for (double& v : r) {
    v -= mean;
    square += v * v;
  }
  const double rms = std::sqrt(square / static_cast<double>(r.size()));
  if (!(rms > 0.0)) return course;
  std::vector<double> correlation;
  for (std::size_t lag = 0; lag < r.size() / 2; ++lag)
    correlation.push_back(correlation_after(r, lag));
  const auto falls = std::find_if(correlation.begin(), correlation.end(),
                                  [](double c) { return c < std::exp(-1.0); });
  if (falls != correlation.end())
    course.time_constant = static_cast<double>(falls - correlation.begin()) * step;
  course.period = period_of(correlation) * step;
  struct Stretch {
    double from, to, square;
  };
  std::vector<Stretch> stretches;
  const double begin = means.list.front().time;
  double largest = 0.0;
  for (const double v : r) largest = std::max(largest, std::abs(v));
  const double far = std::min(far_off * rms, near_the_top * largest);
  for (std::size_t i = 0; i < r.size();) {
    if (std::abs(r[i]) < far) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    double sum = 0.0;
    for (; i < r.size() && std::abs(r[i]) >= rms; ++i) sum += r[i] * r[i];
    stretches.push_back(
        {begin + static_cast<double>(first) * step, begin + static_cast<double>(i) * step, sum});
  }
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.square > b.square; });
  if (stretches.size() > most_intervals) stretches.resize(most_intervals);
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  for (const Stretch& s : stretches) course.when.push_back({s.from, s.to});
  return course;
}

}  // namespace raceway::tolerance
