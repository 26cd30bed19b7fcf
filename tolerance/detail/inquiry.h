#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tolerance/approximation.h"
#include "verdict/diagnose.h"

/// Steps of diagnose_approximation().
namespace raceway::tolerance {

inline constexpr double comes_near = 1.2;  ///< ratio of errors up to which fits are rivals

/// Returns the channel with the largest error in its tolerances; 0 if nothing was held out.
[[nodiscard]] std::size_t worst_channel(const std::vector<double>& errors);

/// Returns the held-out error of the worst channel in its tolerances; NaN if nothing was held out.
[[nodiscard]] double worst_held_out(const Approximation& a);

/// Fit with one or two candidates, or with a fault that the record shows.
struct Tried {
  std::vector<const fit::Candidate*> on{};
  const fit::Fault* shown = nullptr;  ///< instead: by the record itself
  Approximation fit{};
  [[nodiscard]] double error() const { return fit.rms_held_out; }
  [[nodiscard]] double worst() const { return worst_held_out(fit); }
  /// No number of a candidate has gone as far as it may.
  [[nodiscard]] bool is_within_bounds(std::size_t base) const {
    for (std::size_t k = base; k < fit.parameters.size(); ++k)
      if (fit.parameters[k].at_bound != record::Bound::none) return false;
    return true;
  }
  [[nodiscard]] std::vector<std::string> ids() const {
    std::vector<std::string> list;
    if (shown) list.push_back(shown->id);
    for (const fit::Candidate* c : on) list.push_back(c->id);
    return list;
  }
  [[nodiscard]] bool has_column() const {
    return std::any_of(on.begin(), on.end(), [](const auto* c) { return c->by_column; });
  }
  /// It says that data are wrong, not that something is missing.
  [[nodiscard]] bool is_wrong_data() const {
    return shown
               ? !shown->datum.empty()
               : std::all_of(on.begin(), on.end(), [](const auto* c) { return !c->datum.empty(); });
  }
  /// Kinds of the effects, sorted: second-time-constant of second-time-constant:ambient.
  [[nodiscard]] std::vector<std::string> kinds() const {
    std::vector<std::string> list;
    if (shown) list.push_back(shown->id);
    for (const fit::Candidate* c : on)
      list.push_back(c->by_column ? c->id : c->id.substr(0, c->id.find(':')));
    std::sort(list.begin(), list.end());
    return list;
  }
};

/// Carries out one diagnosis of a model that approximates its readings.
class Inquiry {
 public:
  Inquiry(const fit::Subject& subject, const record::Record& record,
          const verdict::DiagnoseOptions& options);
  verdict::Diagnosis run();

 private:
  // Steps that look at the record, and rules of the verdict.
  [[nodiscard]] std::string words_of_read() const;
  [[nodiscard]] double in_SI(double error, std::size_t of) const;
  [[nodiscard]] std::vector<double> in_SI(const std::vector<double>& errors) const;
  [[nodiscard]] ApproximationOptions search() const;
  void step(double share, std::string_view what) const;
  void require_readings();
  [[nodiscard]] fit::Means means_of_channel(std::size_t channel) const;
  void describe();
  [[nodiscard]] bool rivals(const Tried& other, const Tried& best) const;
  [[nodiscard]] std::vector<const Tried*> near_best(const std::vector<const Tried*>& list) const;
  [[nodiscard]] double independent_stretches() const;
  [[nodiscard]] bool is_worth_its_column(const Tried& t, double error_without) const;
  [[nodiscard]] std::vector<const Tried*> chosen(const std::vector<Tried>& list,
                                                 bool with_columns) const;
  [[nodiscard]] static std::vector<const Tried*> causes_first(std::vector<const Tried*> set);
  [[nodiscard]] double as_good_as_within() const;
  [[nodiscard]] bool explained_by(const std::vector<const Tried*>& list);
  [[nodiscard]] bool explained_by_pairs(const std::vector<const Tried*>& list);
  void decide();
  [[nodiscard]] bool is_believable(const Tried& t) const;
  [[nodiscard]] verdict::Course course_of_worst(const Approximation& a) const;

  // Fits with candidates.
  std::vector<Tried> fits_with(const std::vector<std::vector<const fit::Candidate*>>& sets,
                               const ApproximationOptions& with, double most, double from,
                               double to) const;
  [[nodiscard]] double promising(const std::vector<Tried>& list) const;
  void try_singles();
  [[nodiscard]] bool is_felt(const Tried& t) const;
  void leave_out_what_is_not_felt();
  [[nodiscard]] bool is_testable(const std::string& id) const;
  void look_at_record();
  static void sort(std::vector<Tried>& list);
  [[nodiscard]] std::vector<std::vector<const fit::Candidate*>> all_pairs() const;
  [[nodiscard]] std::vector<std::vector<const fit::Candidate*>> promising_pairs() const;
  [[nodiscard]] std::vector<const fit::Candidate*> partners_of(const Tried& best) const;
  void try_pairs();

  // Steps that write the result.
  [[nodiscard]] verdict::RankedEffect ranked(const Tried& t, std::size_t member) const;
  [[nodiscard]] std::vector<std::string> data_of(const Tried& t) const;
  [[nodiscard]] bool is_told(const std::string& id) const;
  void fill();
  void explain(const Tried& best);
  [[nodiscard]] std::string error(const Approximation& a) const;
  [[nodiscard]] std::string error(const Tried& t) const;
  [[nodiscard]] std::string found_text() const;
  [[nodiscard]] std::string sentence() const;
  [[nodiscard]] std::string course_text() const;
  verdict::Diagnosis conclude();

  const verdict::DiagnoseOptions& options_;
  const record::Record& record_;
  std::shared_ptr<const fit::Subject> subject_;
  std::vector<fit::Measured> channels_;  // with their tolerances
  bool few_readings_ = false;
  std::vector<std::size_t> told_;  // of these, in the results
  Recorded recorded_;
  std::vector<fit::Candidate> candidates_;
  std::vector<fit::Fault> faults_;
  Approximation base_;
  std::vector<Tried> singles_, pairs_;
  std::vector<const Tried*> found_;
  verdict::Diagnosis result_;
};

}  // namespace raceway::tolerance
