#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verdict/detail/other_bases.h"
#include "verdict/diagnose.h"
#include "verdict/hidden_input.h"
#include "verdict/search.h"

/// Steps of diagnose().
namespace raceway::verdict {

/// Carries out one diagnosis step by step.
class Investigation {
 public:
  Investigation(const fit::Subject& subject, const record::Record& record,
                const DiagnoseOptions& options);

  /// Finds the effects that the data can show, and the error of the refitted model.
  void look();
  /// Returns true if the gate gives an alarm (Gate::alarm()) and, if a tolerance is given, the
  /// error of the refitted model exceeds the tolerance. Also returns true if the readings change
  /// mainly from run to run (HiddenInput).
  [[nodiscard]] bool is_anything_missing() const;
  /// Finds effects that explain the misfit.
  void attribute();
  /// Checks the explanation on held-out rows, and checks whether the sizes are plausible.
  void confirm();
  /// Compares other base models if no candidate explains the misfit, or if one candidate fits only
  /// with another law or an implausible size.
  void try_other_bases();
  /// Proposes measurements if the data cannot decide.
  void propose();
  /// Puts the verdict into words.
  [[nodiscard]] Diagnosis conclude();

 private:
  using Set = std::vector<const Explanation*>;

  // Steps that look at the data.
  void describe_channels();
  void describe_base();
  void tell_declared_noise();
  void tell_of_runs();
  void tell_of_records();
  void tell_of_growth();
  [[nodiscard]] bool base_is_identifiable() const;
  [[nodiscard]] bool outside_the_inputs() const { return hidden_ && hidden_->follows_the_runs(); }
  [[nodiscard]] double degrees() const;

  // Steps that confirm an explanation.
  void confirm_single();
  [[nodiscard]] bool is_a_shape_alone(const Set& set) const;
  [[nodiscard]] std::string doubt_about(const Explanation& best) const;
  [[nodiscard]] bool may_be_block_offsets(const Explanation& e) const;
  [[nodiscard]] std::string doubt_about_time(const Set& set) const;
  void confirm_several();
  void hold_out(const Explanation& best);
  void fill(const Set& set, const Explanation& best);
  void fill_verdict(const Set& set);
  void fill_ranking();
  void fill_explained(const Set& set);
  [[nodiscard]] RankedEffect rank(const Explanation& e, std::size_t member, bool validate) const;
  [[nodiscard]] std::vector<double> rms_of(const Explanation& e) const;
  [[nodiscard]] OtherBaseTried tried(CalibratedBase& found) const;
  [[nodiscard]] bool does_as_well(const CalibratedBase& found, const OtherBaseTried& tried) const;
  [[nodiscard]] std::shared_ptr<const Diagnosis> given(const CalibratedBase& found) const;
  void find_immaterial();
  void tell_of_all_rows();

  // Steps that write the sentences.
  [[nodiscard]] std::string sentence() const;
  [[nodiscard]] std::string data_text(const Set& set) const;
  [[nodiscard]] std::string single_text() const;
  [[nodiscard]] std::string several_text() const;
  [[nodiscard]] std::string instead_text() const;
  [[nodiscard]] std::string base_laws_text() const;
  [[nodiscard]] std::string bent_text() const;
  [[nodiscard]] std::string partly_text() const;
  [[nodiscard]] std::string unexplained_text() const;
  [[nodiscard]] std::string nearest_text() const;
  [[nodiscard]] std::string rivals_text() const;
  [[nodiscard]] std::string other_bases_text() const;
  [[nodiscard]] std::string remains_text() const;
  [[nodiscard]] std::string hidden_text() const;
  [[nodiscard]] std::string joined_sets(const Set& set) const;
  [[nodiscard]] std::string shifts() const;

  [[nodiscard]] const std::string& id(std::size_t candidate) const;
  [[nodiscard]] std::string id_of(const Explanation& e) const;
  void step(double share, std::string_view what) const;
  [[nodiscard]] bool cancelled() const;

  const record::Record& record_;
  const DiagnoseOptions& options_;
  Evidence evidence_;
  const fit::Problem& problem_;
  Attribution attribution_;
  std::vector<fit::Blocking> blockings_;
  std::optional<Search> search_;
  std::optional<HiddenInput> hidden_;
  Finding finding_;
  bool plausible_ = true, holds_ = true;
  std::string doubt_;
  double share_of_tolerance_ = unset;  // Search::share_of_tolerance() of the refitted base model
  Diagnosis result_;
};

}  // namespace raceway::verdict
