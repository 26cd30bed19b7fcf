#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "effects/effect.h"
#include "fit/data_set.h"
#include "fit/model.h"
#include "fit/response.h"

namespace raceway::fit {

/// One effect that the model lacks and the data may show.
struct Candidate {
  const effects::Description* description = nullptr;
  std::string id;
  std::vector<FitParameter> parameters{};  ///< as in the file; start is the initial value
  std::vector<double> neutral{};           ///< the value without effect; NaN for a shape
  bool one_sided = false;                  ///< only one sign of the size is physical
  /// Readings per unit of `unit_size`, at the neutral point: one column per trial value of the
  /// shapes, not whitened [N m].
  Eigen::MatrixXd scores{};
  double unit_size = 1.0;      ///< of the first parameter that has a neutral value
  std::size_t size_index = 0;  ///< of that parameter
  std::string not_testable{};  ///< what the data lack; empty where it can be tested

  [[nodiscard]] std::string qualified(std::size_t parameter) const;
};

/// A model, the rows it can predict, and what may be missing.
struct Problem {
  Model model;
  DataSet data{};  ///< in the one order of sort_rows(), only rows that can be predicted
  std::vector<int> rows_not_predicted{};  ///< their lines
  std::vector<std::string> base{};        ///< free parameters of the model
  std::vector<Candidate> candidates{};    ///< by id, so that their order does not matter
  Eigen::VectorXd measured{};
  std::vector<Balance> balances{};  ///< of the rows as entered; empty where nobody solved them
};

/// Readings of the problem's model with some candidates switched on: base parameters first, then
/// those of each candidate. `data` of the problem must outlive it.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Candidate* const> on);

/// Fills in what the candidates need to be screened: scores at the base values `base_values`, and
/// whether they can be tested at all.
void screen_candidates(Problem& problem, const Eigen::VectorXd& base_values);

/// Takes effects of the user's own that change nothing yet (a size of zero) out of the model: they
/// are candidates. One without such a parameter stays.
[[nodiscard]] std::vector<effects::Effect> take_user_made(Model& model);

/// An effect with its initial values: one of these, or one of the catalogue in the form for that
/// subject.
[[nodiscard]] std::optional<effects::Effect> find_effect(std::string_view id,
                                                         std::span<const effects::Effect> user_made,
                                                         effects::Subject subject);

/// What may be missing where that subject is measured: those of the catalogue that move it.
[[nodiscard]] std::vector<const effects::Description*> catalogue_of(effects::Subject subject);

/// Candidates of a catalogue that the model does not have yet.
[[nodiscard]] std::vector<Candidate> make_candidates(
    const Model& model, std::span<const effects::Description* const> descriptions);

}  // namespace raceway::fit
