#include "tests/correction_study/floors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>

namespace correction_study {
namespace {

using Values = std::vector<double>;

constexpr double ridge = 1e-7;  // on columns of length one
constexpr int lags = 10, lags_of_pairs = 8;
constexpr double shortest_lag = 90.0;  // [s]

/// How a body follows an input, row by row.
struct Following {
  double tau;                                   // [s]
  bool held;                                    // input holds until the next row, else straight
  std::function<double(std::size_t)> slower{};  // factor on tau from this row on
  std::function<double(std::size_t)> larger{};  // factor on the input from this row on
  double falling = 1.0;                         // factor on tau while the input is below the body
};

/// A body that follows, by the implicit midpoint rule; from the first row of every run.
Values follow(const Signals& s, const Values& input, const Following& how) {
  Values out(input.size(), 0.0);
  double first = input.front();
  for (std::size_t i = 1; i < input.size(); ++i) {
    if (s.run[i] != s.run[i - 1]) {
      first = input[i];
      continue;
    }
    const std::size_t from = i - 1;
    const double zero = how.held ? 0.0 : first;
    double mean = how.held ? input[from] : 0.5 * (input[from] + input[i]) - zero;
    if (how.larger) mean *= how.larger(from);
    double tau = how.tau * (how.slower ? how.slower(from) : 1.0);
    if (mean < out[from]) tau *= how.falling;
    const double h = (s.time[i] - s.time[from]) / tau;
    out[i] = out[from] + (mean - out[from]) * h / (1.0 + 0.5 * h);
  }
  return out;
}

/// Columns of which a model has some: one for each time constant, where it has one.
struct Choice {
  std::function<Values(const Signals&, double tau)> column;
  Values taus;  // [s]
  int pick;
  bool carried = true;  // to the record that was not fitted
};
using Form = std::vector<Choice>;

/// Rows that were read, each column without its mean over a run: a run has its own zero.
Eigen::MatrixXd readings(const Signals& s, const std::vector<Values>& columns) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < s.time.size(); ++i)
    if (!std::isnan(s.displacement[i])) rows.push_back(i);
  Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()),
                      static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t r = 0; r < rows.size(); ++r)
      out(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = columns[c][rows[r]];
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && s.run[rows[end]] == s.run[rows[begin]]) ++end;
    auto block =
        out.middleRows(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
    block.rowwise() -= block.colwise().mean().eval();
  }
  return out;
}

Eigen::VectorXd displacement(const Signals& s) { return readings(s, {s.displacement}).col(0); }

/// The best of all ways to pick the columns of a form.
class Search {
 public:
  Search(const Form& form, const Signals& train) : form_(form), measured_(displacement(train)) {
    std::vector<Values> values;
    for (const Choice& c : form)
      for (const double tau : c.taus) values.push_back(c.column(train, tau));
    Eigen::MatrixXd columns = readings(train, values);
    lengths_ = columns.colwise().norm().array() + 1e-12;
    columns.array().rowwise() /= lengths_.transpose().array();
    gram_ = columns.transpose() * columns;
    gram_.diagonal().array() += ridge;
    onto_ = columns.transpose() * measured_;
    pick(0, 0, 0, 0);
  }

  [[nodiscard]] double error() const {
    const double left = std::max(measured_.squaredNorm() - explained_, 0.0);
    return std::sqrt(left / static_cast<double>(measured_.size()));
  }

  /// Error on another record, with what was found.
  [[nodiscard]] double error(const Signals& later) const {
    Eigen::VectorXd left = displacement(later);
    for_each_picked([&](const Choice& c, double tau, Eigen::Index column, double gain) {
      if (c.carried)
        left -= gain / lengths_[column] * readings(later, {c.column(later, tau)}).col(0);
    });
    return std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  }

  /// The same columns with time constants around those that were found.
  [[nodiscard]] Form around_best(double factor) const {
    Form finer;
    for_each_picked([&](const Choice& c, double tau, Eigen::Index, double) {
      Choice one{c.column, {tau}, 1, c.carried};
      for (const double power : {-2.0, -1.0, 1.0, 2.0})
        if (c.taus.size() > 1) one.taus.push_back(tau * std::pow(factor, power));
      finer.push_back(std::move(one));
    });
    return finer;
  }

 private:
  /// Chooses `picked + 1` of choice `c`, whose columns begin at `begin`, from `next` on.
  void pick(std::size_t c, int picked, Eigen::Index next, Eigen::Index begin) {
    if (c == form_.size()) return solve();
    const auto have = static_cast<Eigen::Index>(form_[c].taus.size());
    if (picked == form_[c].pick) return pick(c + 1, 0, 0, begin + have);
    for (Eigen::Index i = next; i < have; ++i) {
      chosen_.push_back(begin + i);
      pick(c, picked + 1, i + 1, begin);
      chosen_.pop_back();
    }
  }

  void solve() {
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;
    using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;
    const Eigen::Index n = static_cast<Eigen::Index>(chosen_.size());
    Small normal(n, n);
    Few right(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      right[i] = onto_[chosen_[static_cast<std::size_t>(i)]];
      for (Eigen::Index j = 0; j < n; ++j)
        normal(i, j) =
            gram_(chosen_[static_cast<std::size_t>(i)], chosen_[static_cast<std::size_t>(j)]);
    }
    const Few gains = Eigen::LLT<Small>(normal).solve(right);
    const double explained = gains.dot(right);
    if (explained <= explained_) return;
    explained_ = explained;
    best_ = chosen_;
    best_gains_ = gains;
  }

  template <typename Visit>
  void for_each_picked(const Visit& visit) const {
    std::size_t next = 0;
    Eigen::Index begin = 0;
    for (const Choice& c : form_) {
      for (int k = 0; k < c.pick; ++k, ++next)
        visit(c, c.taus[static_cast<std::size_t>(best_[next] - begin)], best_[next],
              best_gains_[static_cast<Eigen::Index>(next)]);
      begin += static_cast<Eigen::Index>(c.taus.size());
    }
  }

  Form form_;
  Eigen::VectorXd measured_, lengths_, onto_, best_gains_;
  Eigen::MatrixXd gram_;
  std::vector<Eigen::Index> chosen_, best_;
  double explained_ = -std::numeric_limits<double>::infinity();
};

/// Makes the forms of a pair of records.
class Forms {
 public:
  Forms(const Base& base, const Signals& train, int count = lags) : base_(base), train_(train) {
    const double longest = 0.5 * (train.time.back() - train.time.front());
    for (int i = 0; i < count; ++i)
      taus_.push_back(shortest_lag * std::pow(longest / shortest_lag, i / (count - 1.0)));
  }

  using Column = std::function<Values(const Signals&)>;

  [[nodiscard]] static Choice alone(const Column& column) {
    return {[column](const Signals& s, double) { return column(s); }, {0.0}, 1};
  }

  /// Bodies of all time constants that follow an input.
  [[nodiscard]] Choice followers(const Column& input, bool held, int pick) const {
    return {[input, held](const Signals& s, double tau) {
              return follow(s, input(s), {.tau = tau, .held = held});
            },
            taus_, pick};
  }

  using PerRow = std::function<double(const Signals&, std::size_t)>;

  /// The main channel's sections, where `slower`, `larger` and `falling` bend them.
  [[nodiscard]] Choice spindle(int sections, const PerRow& slower = {}, const PerRow& larger = {},
                               double falling = 1.0) const {
    const bool held = base_.power;
    return {[=](const Signals& s, double tau) {
              Following how{.tau = tau, .held = held, .falling = falling};
              if (slower) how.slower = [&](std::size_t i) { return slower(s, i); };
              if (larger) how.larger = [&](std::size_t i) { return larger(s, i); };
              return follow(s, s.spindle, how);
            },
            taus_, sections};
  }

  /// The base around a main channel.
  [[nodiscard]] Form around(Choice main_channel) const {
    Form form{std::move(main_channel)};
    if (base_.ambient) form.push_back(followers(&ambient, false, 1));
    if (base_.feedthrough) form.push_back(alone(&spindle_itself));
    return form;
  }

  [[nodiscard]] Form plain() const { return around(spindle(base_.sections)); }

  static Values ambient(const Signals& s) { return s.ambient; }
  static Values spindle_itself(const Signals& s) { return s.spindle; }
  static Values hidden(const Signals& s) { return s.hidden; }

  /// What an effect adds to the base, in each of its shapes. Empty: it bends the main channel, or
  /// has no column.
  [[nodiscard]] std::vector<Choice> additions(std::string_view id) const;
  /// The base with its main channel bent, in each shape of an effect.
  [[nodiscard]] std::vector<Form> bent(std::string_view id) const;

 private:
  Base base_;
  const Signals& train_;
  Values taus_;
};

std::vector<Choice> Forms::additions(std::string_view id) const {
  std::vector<Choice> out;
  if (id == "ambient-drift" && !train_.ambient.empty() && !base_.ambient) {
    out.push_back(followers(&ambient, false, 1));
  } else if (id == "motor-heat" && !train_.motor.empty()) {
    out.push_back(followers([](const Signals& s) { return s.motor; }, false, 1));
  } else if (id == "input" && !train_.column.empty()) {
    out.push_back(followers([](const Signals& s) { return s.column; }, false, 1));
  } else if (id == "motor-heat") {
    for (const double fade : {300.0, 700.0, 1500.0, 3000.0, 7000.0})
      out.push_back(followers(
          [fade](const Signals& s) {
            Values loss;
            for (const double n : s.speed)
              loss.push_back(n > 0.0 ? 1.0 / (1.0 + n / fade) / (1.0 + n / fade) : 0.0);
            return loss;
          },
          true, 1));
  } else if (id == "feed-axis-heat") {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!train_.feed[axis].empty())
        out.push_back(followers([axis](const Signals& s) { return s.feed[axis]; }, true, 1));
  } else if (id == "sensor-lag" && !base_.power && !base_.feedthrough) {
    out.push_back(alone(&spindle_itself));
  } else if (id == "kinematic-displacement") {
    for (const double bend : {300.0, 1000.0, 2500.0, 6000.0})
      out.push_back(alone([bend](const Signals& s) {
        Values u;
        for (const double n : s.speed) u.push_back(std::hypot(n, bend) - bend);
        return u;
      }));
  } else if (id == "slow-drift") {
    const double span = train_.time.back() - train_.time.front();
    Choice settling =
        followers([](const Signals& s) { return Values(s.time.size(), 1.0); }, true, 1);
    settling.taus.clear();
    for (const double part : {0.15, 0.3, 0.6, 1.2, 2.5, 5.0}) settling.taus.push_back(part * span);
    settling.carried = false;  // it cleans the record that it was seen in
    out.push_back(std::move(settling));
  } else if (id == "offset-jump" && !train_.hidden.empty()) {
    out.push_back(alone(&hidden));
  }
  return out;
}

std::vector<Form> Forms::bent(std::string_view id) const {
  std::vector<Form> out;
  if (id == "second-time-constant") {
    out.push_back(around(spindle(base_.sections + 1)));
  } else if (id == "speed-dependent-time-constant") {
    for (const double s : {0.5, 1.0, 2.0, 3.5, 6.0})
      for (const double g : {0.0, 0.5, 1.0, 1.5}) {
        const auto f = [s](const Signals& signals, std::size_t i) {
          return 1.0 / (1.0 + s * signals.speed[i] / 10000.0);
        };
        out.push_back(around(spindle(base_.sections, f, [=](const Signals& signals, std::size_t i) {
          return std::pow(f(signals, i), g);
        })));
      }
  } else if (id == "thermal-asymmetry") {
    for (const double ratio : {0.2, 0.3, 0.45, 0.65, 1.5, 2.2, 3.3, 5.0})
      out.push_back(around(spindle(base_.sections, {}, {}, ratio)));
  } else if (id == "cooling-switch" && !train_.coolant.empty()) {
    for (const double gain : {0.5, 1.0, 1.5, 2.0, 3.0, 4.5, 7.0})
      for (const double tau : {0.5, 1.0, 1.5, 2.0, 3.0, 4.5, 7.0}) {
        const auto off = [](double factor) {
          return [factor](const Signals& s, std::size_t i) {
            return s.coolant[i] > 0.5 ? 1.0 : factor;
          };
        };
        out.push_back(around(spindle(base_.sections, off(tau), off(gain))));
      }
  }
  return out;
}

std::optional<Fit> best_of(const std::vector<Form>& forms, const Signals& train,
                           const Signals& test) {
  std::optional<Search> best;
  for (const Form& form : forms)
    if (Search search(form, train); !best || search.error() < best->error()) best = search;
  if (!best) return std::nullopt;
  for (const double factor : {1.25, 1.07}) best = Search(best->around_best(factor), train);
  return Fit{best->error(), best->error(test)};
}

}  // namespace

Floors::Floors(const Base& base, const Signals& train, const Signals& test)
    : base_(base), train_(train), test_(test) {}

Fit Floors::base() const { return *best_of({Forms(base_, train_).plain()}, train_, test_); }

Fit Floors::with_hidden() const {
  const Forms forms(base_, train_);
  Form form = forms.plain();
  form.push_back(forms.alone(&Forms::hidden));
  return *best_of({form}, train_, test_);
}

std::optional<Fit> Floors::with(const std::vector<std::string_view>& effects) const {
  const Forms forms(base_, train_, effects.size() > 1 ? lags_of_pairs : lags);
  std::vector<Form> bodies{forms.plain()};
  std::vector<std::vector<Choice>> additions;
  for (const std::string_view id : effects) {
    if (std::vector<Form> bent = forms.bent(id); !bent.empty())
      bodies = std::move(bent);
    else
      additions.push_back(forms.additions(id));
  }
  for (const std::vector<Choice>& choices : additions) {
    std::vector<Form> longer;
    for (const Choice& addition : choices)
      for (Form form : bodies) {
        form.push_back(addition);
        longer.push_back(std::move(form));
      }
    bodies = std::move(longer);
  }
  const std::optional<Fit> best = best_of(bodies, train_, test_);
  // Every effect can be nothing, though its grid of shapes may leave that out.
  return best && best->train > base().train ? base() : best;
}

}  // namespace correction_study
