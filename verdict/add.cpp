#include "verdict/add.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "verdict/detail/other_bases.h"
#include "verdict/effect_sizes.h"
#include "verdict/search.h"
#include "verdict/unknown_shape.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

constexpr std::string_view added_shape = "shape";  // the shape that a diagnosis prints
constexpr double clearly_better = within_reach;    // in -2 ln L, as for the set of a verdict

/// The base model among what is to be added; throws where anything stands beside it.
std::optional<fit::OtherBase> other_base_of(const fit::Subject& subject,
                                            std::span<const std::string> ids) {
  for (fit::OtherBase& base : subject.other_bases()) {
    if (std::find(ids.begin(), ids.end(), base.id) == ids.end()) continue;
    if (ids.size() > 1)
      throw std::invalid_argument(base.id +
                                  " must be added alone; then add effects to the new model");
    return std::move(base);
  }
  return std::nullopt;
}

/// Effects switched on, refitted, and judged.
class Addition {
 public:
  Addition(const fit::Subject& subject, std::span<const std::string> ids,
           const record::Record& record)
      : ids_(ids.begin(), ids.end()),
        record_(record),
        evidence_(gather_evidence(subject, record)),
        problem_(evidence_.problem),
        attribution_(evidence_),
        blockings_(fit::blocks_of_observations(subject, *problem_.record, problem_.observed)) {}

  AddResult run() {
    if (const auto base = other_base_of(*problem_.subject, ids_)) {
      take(*base);
    } else {
      find_members();
      found_ = attribution_.refit(members_);
      extended_ = problem_.subject->with_candidates(ids_);
    }
    AddResult result{.calibration = calibration()};
    describe_channels(result);
    result.before = likelihood_of(evidence_.base.misfit, evidence_.whitening,
                                  static_cast<int>(problem_.base.size()));
    result.gain = found_.gain;
    result.messages = result.calibration.messages;
    if (!found_.fit.converged) {
      result.refused = true;
      result.reason = "the fit with the effect did not converge";
      return result;
    }
    for (const std::size_t k : members_)
      if (const fit::Candidate& c = problem_.candidates[k].candidate; !c.datum.empty())
        result.messages.push_back(record::note::check_data(
            fmt::format("check {}: {}", c.datum, correction_text(problem_, found_, k))));
    hold_out(result);
    result.reason = refusal(result);
    result.refused = !result.reason.empty();
    return result;
  }

 private:
  /// Another base model in the place of the given one. Throws for one that cannot be tested.
  void take(const fit::OtherBase& base) {
    CalibratedBase found = calibrate_other_base(evidence_, base);
    if (!found.not_testable.empty())
      throw std::invalid_argument(fmt::format("{}: {}", base.id, found.not_testable));
    found_ = std::move(found.explanation);
    extended_ = base.subject;
  }

  /// Places of the effects among the candidates. Throws for one that the data cannot feed.
  void find_members() {
    for (const std::string& id : ids_) {
      const auto s = std::find_if(problem_.candidates.begin(), problem_.candidates.end(),
                                  [&](const fit::Screened& c) { return c.id() == id; });
      if (s == problem_.candidates.end())
        throw std::invalid_argument("add cannot fit an effect that has no parameter for its size");
      const auto k = static_cast<std::size_t>(s - problem_.candidates.begin());
      if (!s->not_testable.empty())
        throw std::invalid_argument(fmt::format("{}: {}", id, s->not_testable));
      if (attribution_.visibility(k) < invisible) {
        const std::string levels = problem_.subject->lacks_levels(id, *problem_.record);
        throw std::invalid_argument(
            levels.empty() ? fmt::format("{}: the free parameters of the model change these data "
                                         "in the same way, so the data cannot show this effect",
                                         id)
                           : fmt::format("{}: needs {}", id, levels));
      }
      members_.push_back(k);
    }
    std::sort(members_.begin(), members_.end());
  }

  /// The model as it will be written: effects in the order asked for, values where the refit ended.
  [[nodiscard]] Calibration calibration() const {
    std::vector<record::NamedValue> values;
    if (found_.fit.converged)
      for (std::size_t k = 0; k < found_.parameters.size(); ++k)
        values.push_back(
            {found_.parameters[k].name, found_.fit.values[static_cast<Eigen::Index>(k)]});
    Calibration result =
        calibration_of(extended_->with_values(values), found_.response, found_.fit,
                       problem_.observed, evidence_.base.prediction, evidence_.whitening);
    // Addresses are those of the model with the effects in the order asked for.
    for (const record::Parameter& p : extended_->parameters())
      for (record::Parameter& own : result.parameters)
        if (own.name == p.name) own.addresses = p.addresses;
    result.rows = static_cast<int>(evidence_.rows());
    result.rows_not_predicted = problem_.not_predicted;
    return result;
  }

  /// Before and after over the rows that were used.
  void describe_channels(AddResult& result) const {
    const fit::Observations& observed = problem_.observed;
    const auto held = [&](const Eigen::VectorXd& prediction, std::size_t c, std::size_t fitted) {
      const std::span<const std::size_t> rows = observed.rows(c);
      std::vector<double> by_row(problem_.record->rows(), unset);
      for (std::size_t i = 0; i < rows.size(); ++i)
        by_row[rows[i]] = prediction[observed.first[c] + static_cast<Eigen::Index>(i)];
      Comparison comparison =
          compare(by_row, *problem_.record, observed.channels[c], static_cast<int>(fitted));
      const Eigen::VectorXd& std = evidence_.noise[c].whitening.std();
      for (std::size_t i = 0; i < comparison.errors.size(); ++i) {
        comparison.errors[i].row = problem_.rows[comparison.errors[i].row];
        comparison.errors[i].std = std[static_cast<Eigen::Index>(i)];
      }
      for (RowError& e : comparison.worst) e.row = problem_.rows[e.row];
      for (std::size_t& row : comparison.rows_not_predicted) row = problem_.rows[row];
      for (auto* errors : {&comparison.errors, &comparison.worst})
        for (RowError& e : *errors) e.line = record_.line(e.row);
      return comparison;
    };
    const bool after = found_.fit.converged;
    for (std::size_t c = 0; c < observed.channels.size(); ++c) {
      ChannelGain gain;
      gain.before = held(evidence_.base.prediction, c, problem_.base.size());
      gain.after = after ? held(found_.fit.prediction, c, found_.parameters.size()) : gain.before;
      gain.noise = evidence_.noise[c];
      gain.tolerance = observed.channels[c].tolerance;
      result.channels.push_back(std::move(gain));
    }
  }

  void hold_out(AddResult& result) const {
    const fit::Observations& observed = problem_.observed;
    const Eigen::VectorXd& std = evidence_.std();
    for (const fit::Blocking& b : blockings_)
      result.hold_out.push_back(fit::compare_held_out(
          fit::held_out_errors(evidence_.response, evidence_.base, observed.measured, std, b),
          fit::held_out_errors(found_.response, found_.fit, observed.measured, std, b), std,
          observed, b));
    const bool tolerance =
        std::any_of(observed.channels.begin(), observed.channels.end(),
                    [](const fit::Measured& m) { return std::isfinite(m.tolerance); });
    const auto error = tolerance ? held_out_within_range : held_out;
    const std::vector<double> before =
        error(evidence_, evidence_.response, evidence_.base, blockings_);
    const std::vector<double> after = error(evidence_, found_.response, found_.fit, blockings_);
    for (std::size_t c = 0; c < before.size(); ++c) {
      result.channels[c].rmse_held_out_before = before[c];
      result.channels[c].rmse_held_out_after = after[c];
    }
  }

  /// Why it is refused; empty if it is not.
  [[nodiscard]] std::string refusal(const AddResult& result) {
    // What else is missing shows as more than noise, and by chance a wrong effect takes part of it.
    const auto rows = static_cast<double>(problem_.observed.size());
    const double excess =
        std::max(1.0, found_.fit.misfit / (rows - static_cast<double>(found_.fit.values.size())));
    const double needed_each = excess * std::log(rows);
    const double needed =
        needed_each * static_cast<double>(std::max<std::size_t>(1, members_.size()));
    if (!fit::confirmed(result.hold_out) || found_.gain < needed) {
      std::vector<std::string> errors;
      for (const ChannelGain& c : result.channels)
        errors.push_back(fmt::format("{:.4g} -> {}", c.rmse_held_out_before / c.channel().factor,
                                     reading_text(c.channel(), c.rmse_held_out_after, 4)));
      return fmt::format(
          "not better than chance: RMS error {} on held-out rows; -2 ln L (L: likelihood) falls by "
          "{:.1f} (needed {:.1f})",
          joined(errors, "and"), found_.gain, needed);
    }
    if (const std::string material = immaterial(result); !material.empty()) return material;
    if (const std::string idle = idle_member(needed_each); !idle.empty())
      return idle + " explains nothing beyond the other effects";
    if (const auto rival = better_rival())
      return fmt::format(
          "{} leaves a systematic residual (p = {:.1g}), but {} explains these data down to the "
          "noise (p = {:.2g})",
          ids_.front(), found_.recheck.p_value(), problem_.candidates[rival->members.front()].id(),
          rival->recheck.p_value());
    return {};
  }

  /// With a tolerance: what was good enough before, beyond the noise, needs nothing.
  [[nodiscard]] static std::string immaterial(const AddResult& result) {
    bool given = false;
    for (const ChannelGain& c : result.channels) {
      if (std::isnan(c.tolerance)) continue;
      given = true;
      if (!(fit::beyond_noise(c.rmse_held_out_before, c.noise.rms) <= c.tolerance)) return {};
    }
    if (!given) return {};
    return fmt::format(
        "without the effect, the part of the held-out error that the noise does not explain is "
        "within the tolerance (held-out error {})",
        reading_text(result.channels.front().channel(),
                     result.channels.front().rmse_held_out_before));
  }

  /// The single effect that leaves nothing but noise, where what was asked for leaves structure.
  std::optional<Explanation> better_rival() {
    attribution_.recheck(found_);
    if (found_.members.size() > 1 || found_.recheck.p_value() >= passed) return std::nullopt;
    for (Explanation& single : attribution_.singles()) {
      if (!single.fit.converged || single.gain < found_.gain + clearly_better) break;
      attribution_.recheck(single);
      if (single.recheck.p_value() >= passed) return std::move(single);
    }
    return std::nullopt;
  }

  /// The id of a member without which the others explain as much; empty if none, or only one is
  /// there.
  [[nodiscard]] std::string idle_member(double needed) const {
    if (members_.size() < 2) return "";
    for (const std::size_t k : members_) {
      std::vector<std::size_t> others = members_;
      std::erase(others, k);
      const Explanation without = attribution_.refit(others);
      if (without.fit.converged && found_.gain - without.gain < needed)
        return problem_.candidates[k].id();
    }
    return "";
  }

  std::vector<std::string> ids_;
  const record::Record& record_;
  Evidence evidence_;
  const fit::Problem& problem_;
  Attribution attribution_;
  std::vector<fit::Blocking> blockings_;
  std::vector<std::size_t> members_;
  std::shared_ptr<const fit::Subject> extended_;  // as it will be written, at its start
  Explanation found_;
};

/// The subject with the shape of what is missing as a candidate of that id. Throws where there is
/// none.
std::unique_ptr<fit::Subject> with_found_shape(const fit::Subject& subject, const std::string& id,
                                               const record::Record& record) {
  const Evidence evidence = gather_evidence(subject, record);
  const std::optional<fit::Shape> shape = find_unknown_shape(evidence);
  std::unique_ptr<fit::Subject> with;
  if (shape) with = subject.with_shape(id, *shape);
  if (!with)
    throw std::invalid_argument(std::string(added_shape) +
                                ": no power law of the inputs describes the missing effect");
  return with;
}

/// "shape", or "shape-2" where the subject has one.
std::string id_of_shape(const fit::Subject& subject) {
  const std::vector<std::string> known = subject.catalogue();
  const std::vector<record::Parameter> numbers = subject.parameters();
  for (int count = 1;; ++count) {
    const std::string id =
        count == 1 ? std::string(added_shape) : fmt::format("{}-{}", added_shape, count);
    const bool taken = std::find(known.begin(), known.end(), id) != known.end() ||
                       std::any_of(numbers.begin(), numbers.end(), [&](const record::Parameter& p) {
                         return p.name.starts_with(id + ".");
                       });
    if (!taken) return id;
  }
}

}  // namespace

AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                       const record::Record& record) {
  if (ids.empty()) throw std::invalid_argument("no effect to add");
  if (other_base_of(subject, ids)) return Addition(subject, ids, record).run();
  std::vector<std::string> wanted(ids.begin(), ids.end());
  if (const auto shape = std::find(wanted.begin(), wanted.end(), added_shape);
      shape != wanted.end()) {
    *shape = id_of_shape(subject);
    const std::unique_ptr<fit::Subject> with = with_found_shape(subject, *shape, record);
    (void)with->with_candidates(wanted);
    return Addition(*with, wanted, record).run();
  }
  (void)subject.with_candidates(ids);  // throws for what is no candidate
  return Addition(subject, ids, record).run();
}

}  // namespace raceway::verdict
