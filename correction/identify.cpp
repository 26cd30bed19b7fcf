#include "correction/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>

#include "correction/correction_subject.h"
#include "correction/numbers.h"
#include "correction/range.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "fit/distributions.h"
#include "fit/problem.h"
#include "record/series_channel.h"
#include "tolerance/thinned_record.h"
#include "verdict/compare.h"

namespace raceway::correction {
namespace {

/// From the first to the last row of a record [s].
double length_of(std::span<const double> time) {
  if (time.empty()) return 0.0;
  const auto [first, last] = std::minmax_element(time.begin(), time.end());
  return *last - *first;
}

constexpr double worth_a_section = 0.97;  // of the error held out: less is no reason for one more
constexpr double worth_a_channel = 0.95;

bool is_identified(const DrivenChannel& c) { return !c.element && !c.printed; }

/// With a section more, whose time constant a search will find.
void add_section(DrivenChannel& c) { c.sections.push_back({0.0, 3600.0}); }

class Search {
 public:
  Search(const Model& model, const record::Record& record, const IdentifyOptions& options)
      : options_(options), record_(std::make_shared<const record::Record>(record)), model_(model) {
    for (DrivenChannel& c : model_.channels) {
      if (!is_identified(c)) continue;
      // Of what the file has, the first sections are starts.
      const auto lowest = static_cast<std::size_t>(options.lowest_order);
      if (c.sections.size() > lowest) c.sections.resize(lowest);
      if (!c.sections.empty() || c.feedthrough == 0.0)
        while (c.sections.size() < lowest) add_section(c);
    }
    model_.free.clear();
  }

  Identification run() {
    if (model_.channels.empty() && !model_.kinematic) first_channel();
    Approximation best = fitted(model_);
    result_.tried.push_back(tried(model_, best, true));
    for (int round = 1;; ++round) {
      if (!improve(best, round)) break;
    }
    return finish(best);
  }

 private:
  using Approximation = tolerance::Approximation;

  [[nodiscard]] tolerance::ApproximationOptions search() const {
    return {.cancelled = options_.cancelled};
  }

  /// A search that was told to end leaves numbers that are none.
  void stop_where_cancelled() const {
    if (options_.cancelled && options_.cancelled()) throw fit::Cancelled();
  }

  [[nodiscard]] double in_SI(double weighted) const {
    return std::isfinite(model_.tolerance) ? weighted * model_.tolerance : weighted;
  }

  [[nodiscard]] std::shared_ptr<const fit::Subject> subject_of(const Model& model) const {
    const CorrectionSubject plain(model);
    plain.require(*record_);
    return plain.informed_by(*record_);
  }

  Approximation fitted(const Model& model) {
    const auto subject = subject_of(model);
    if (!recorded_)
      recorded_ = std::make_unique<tolerance::Recorded>(tolerance::recorded(
          *subject, tolerance::for_search(record_), tolerance::usual_width(*record_)));
    if (recorded_->means.list.size() < 3 * subject->free().size())
      throw std::invalid_argument(fmt::format(
          "{} readings of {} are too few for {} parameters: a fit needs three or more for each "
          "parameter. Rows that are close in time count as "
          "one reading: the record has {} rows over {:.4g} s. Is {} in seconds?",
          recorded_->means.list.size(), model.displacement->words, subject->free().size(),
          record_->rows(), length_of(record_->values(record::time)), record::time.name));
    Approximation a = tolerance::approximate(subject, *recorded_, subject->free(), search());
    stop_where_cancelled();
    if (a.fit.values.size() == 0)
      throw std::invalid_argument(
          "the start values of the model give no finite RMS error on this record; check the start "
          "values and the units of the columns");
    tolerance::hold_out(a, *recorded_);
    stop_where_cancelled();
    return a;
  }

  [[nodiscard]] StructureTried tried(const Model& model, const Approximation& a, bool taken) const {
    StructureTried t{.rms_held_out = in_SI(a.rms_held_out), .rms = in_SI(a.rms), .taken = taken};
    for (const DrivenChannel& c : model.channels) {
      t.channels.push_back(c.name);
      t.orders.push_back(static_cast<int>(c.sections.size()));
    }
    return t;
  }

  /// A model without any channel begins with the best of the columns that are offered.
  void first_channel() {
    if (options_.offered.empty())
      throw std::invalid_argument(
          "the model has no channel, and no input column is given: name input columns with "
          "--inputs, or use all columns with --lags auto");
    double least = std::numeric_limits<double>::infinity();
    Model best;
    for (const Channel* column : options_.offered) {
      Model with = model_;
      add_channel(with, *column);
      const Approximation a = fitted(with);
      result_.tried.push_back(tried(with, a, false));
      if (!(error(a) < least)) continue;
      least = error(a);
      best = std::move(with);
    }
    model_ = std::move(best);
  }

  void add_channel(Model& model, const Channel& column) const {
    DrivenChannel c = driven_by(column, model);
    for (int k = 0; k < options_.lowest_order; ++k) add_section(c);
    model.channels.push_back(std::move(c));
  }

  /// On parts held out; in sample where nothing can be.
  [[nodiscard]] static double error(const Approximation& a) {
    return std::isfinite(a.rms_held_out) ? a.rms_held_out : a.rms;
  }

  [[nodiscard]] bool drives_a_channel(const Channel& column) const {
    return std::any_of(model_.channels.begin(), model_.channels.end(), [&](const DrivenChannel& c) {
      return std::find(c.input.columns.begin(), c.input.columns.end(), &column) !=
             c.input.columns.end();
    });
  }

  /// The best of all that are one step larger, where it is better by enough.
  bool improve(Approximation& best, int round) {
    Model next;
    Approximation found;
    double least = std::numeric_limits<double>::infinity(), needed = unset;
    std::size_t at = 0;
    const auto consider = [&](Model with, double worth) {
      if (options_.progress)
        options_.progress(std::min(0.9, 0.2 * round), "trying one more section or channel");
      Approximation a = fitted(with);
      if (error(a) < least) {
        least = error(a);
        needed = worth;
        next = with;
        found = std::move(a);
        at = result_.tried.size();
      }
      result_.tried.push_back(tried(with, error(a) == least ? found : a, false));
    };
    for (std::size_t c = 0; c < model_.channels.size(); ++c) {
      if (!is_identified(model_.channels[c]) ||
          static_cast<int>(model_.channels[c].sections.size()) >= options_.highest_order)
        continue;
      Model with = model_;
      add_section(with.channels[c]);
      consider(std::move(with), worth_a_section);
    }
    if (model_.channels.size() < options_.most_channels)
      for (const Channel* column : options_.offered) {
        if (drives_a_channel(*column)) continue;
        Model with = model_;
        add_channel(with, *column);
        consider(std::move(with), worth_a_channel);
      }
    if (!(least < needed * error(best))) return false;
    result_.tried[at].taken = true;
    model_ = std::move(next);
    best = std::move(found);
    return true;
  }

  Identification finish(const Approximation& best) {
    if (options_.progress) options_.progress(0.95, "repeating the fit with all rows");
    tolerance::Recorded rows, whole = *recorded_;
    whole.record = record_;
    const Approximation last = tolerance::refined(slowest_first(best), whole, rows);
    describe(last, best, rows);
    return std::move(result_);
  }

  /// The same with the sections of every channel in one order, whichever start led there.
  [[nodiscard]] Approximation slowest_first(Approximation a) const {
    const auto place = [&](const std::string& name) {
      return static_cast<Eigen::Index>(std::find(a.names.begin(), a.names.end(), name) -
                                       a.names.begin());
    };
    for (const DrivenChannel& c : model_.channels) {
      if (std::any_of(a.stays.begin(), a.stays.end(),
                      [&](const auto& p) { return p.name.starts_with(c.name + "."); }))
        continue;  // in the order of the file, which their priors are of
      std::vector<std::pair<double, double>> sections;  // time constant, gain
      for (std::size_t s = 1; s <= c.sections.size(); ++s)
        sections.emplace_back(a.fit.values[place(fmt::format("{}.time_constant_{}", c.name, s))],
                              a.fit.values[place(fmt::format("{}.gain_{}", c.name, s))]);
      std::sort(sections.begin(), sections.end(), std::greater<>());
      for (std::size_t s = 1; s <= sections.size(); ++s) {
        a.fit.values[place(fmt::format("{}.time_constant_{}", c.name, s))] = sections[s - 1].first;
        a.fit.values[place(fmt::format("{}.gain_{}", c.name, s))] = sections[s - 1].second;
      }
    }
    return a;
  }

  void describe(const Approximation& last, const Approximation& best,
                const tolerance::Recorded& rows) {
    const tolerance::ApproximationErrors errors = tolerance::errors_of(last, rows);
    result_.rms_held_out = in_SI(best.rms_held_out);
    result_.condition = errors.condition;
    result_.correlation_time = errors.correlation_time;
    const fit::Noise noise =
        verdict::noise_of(*record_, CorrectionSubject(model_).measured().front());
    result_.noise = noise.rms;
    result_.noise_source = noise.source;
    const auto fitted = tolerance::fitted(last);
    result_.model = model_of(*fitted);
    result_.model.free = {};
    result_.parameters = last.parameters;
    fit::Covariance covariance;
    std::vector<Eigen::Index> sure;
    for (std::size_t k = 0; k < last.names.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      record::Parameter& p = result_.parameters[k];
      p.value = last.fit.values[at];
      p.std = std::sqrt(errors.covariance(at, at));
      if (last.fit.at_bound[k]) result_.at_bound.push_back(p.name);
      const bool of_the_model = !p.name.starts_with("zero.") && !p.name.starts_with("initial.");
      if (!std::isfinite(p.std) || !of_the_model) continue;
      covariance.names.push_back(p.name);
      sure.push_back(at);
    }
    if (!sure.empty()) {
      covariance.values = last.fit.values(sure);
      covariance.matrix = errors.covariance(sure, sure);
      add_stays(last.stays, covariance);
      result_.model.covariance = std::move(covariance);
    }
    see(result_.model, *record_);
    result_.model.left =
        Left{.rms = std::isfinite(result_.rms_held_out) ? result_.rms_held_out : in_SI(last.rms),
             .correlation_time = result_.correlation_time};
    result_.model.evidence = evidence_on(result_.model, *record_, result_.rms_held_out);
    std::vector<double> predicted = fit::predict(*fitted, *record_);
    result_.metrics = metrics(record_->values(*model_.displacement), predicted);
    result_.whiteness_p_value = whiteness(last.fit.residual);
    warn(rows);
  }

  /// Numbers that stayed at their priors, with the uncertainty of these.
  void add_stays(const std::vector<record::Parameter>& stays, fit::Covariance& covariance) {
    const auto fitted = std::ssize(covariance.names), all = fitted + std::ssize(stays);
    covariance.values.conservativeResize(all);
    covariance.matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(all, all));
    for (const record::Parameter& p : stays) {
      const auto at = std::ssize(covariance.names);
      covariance.names.push_back(p.name);
      covariance.values[at] = p.value;
      covariance.matrix(at, at) = p.std * p.std;
      result_.parameters.push_back(p);
      result_.messages.push_back(tolerance::stays_note(p));
    }
  }

  /// That what is left has no memory, by Ljung and Box over 20 lags.
  [[nodiscard]] static double whiteness(const Eigen::VectorXd& r) {
    constexpr Eigen::Index lags = 20;
    if (r.size() < 3 * lags || !(r.squaredNorm() > 0.0)) return unset;
    const auto n = static_cast<double>(r.size());
    double q = 0.0;
    for (Eigen::Index lag = 1; lag <= lags; ++lag) {
      const double rho = r.head(r.size() - lag).dot(r.tail(r.size() - lag)) / r.squaredNorm();
      q += rho * rho / (n - static_cast<double>(lag));
    }
    return fit::chi_squared_above(static_cast<double>(lags), n * (n + 2.0) * q);
  }

  void warn(const tolerance::Recorded& rows) {
    const auto tell = [&](record::Note said) { result_.messages.push_back(std::move(said)); };
    for (const std::string& name : result_.at_bound)
      tell(record::note::at_bound(
          fmt::format("{} is at a bound: the record does not determine it", name), {.key = name}));
    for (const record::Parameter& p : result_.parameters)
      if (p.unit == "s" && 3.0 * p.value > rows.duration)
        tell(record::note::not_identifiable(
            fmt::format(
                "{} = {:.3g} s: the record of {:.3g} s is shorter than three time constants",
                p.name, p.value, rows.duration),
            {.key = p.name}));
    if (std::isnan(result_.rms_held_out))
      tell(
          record::note::limits("there are too few readings for a held-out test, so the RMS error "
                               "of the fit determines the number of sections"));
    if (result_.condition > 1e6)
      tell(record::note::not_identifiable(fmt::format(
          "some fitted parameters are nearly dependent (condition number {:.1e}): the record "
          "determines only combinations of them, such as the sum of two gains; vary the inputs "
          "independently",
          result_.condition)));
  }

  const IdentifyOptions& options_;
  std::shared_ptr<const record::Record> record_;
  std::unique_ptr<tolerance::Recorded> recorded_;
  Model model_;
  Identification result_;
};

}  // namespace

DrivenChannel driven_by(const Channel& column, const Model& model) {
  std::string name(column.variable);
  if (name.ends_with("_temperature")) name.erase(name.size() - 12);
  while (find_channel(model, name) != nullptr) name += "_2";
  return {.name = name, .input = {.name = std::string(column.name), .columns = {&column}}};
}

Identification identify(const Model& model, const record::Record& record,
                        const IdentifyOptions& options) {
  return Search(model, record, options).run();
}

}  // namespace raceway::correction
