#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fit/candidates.h"
#include "fit/noise_model.h"
#include "fit/screening.h"

namespace raceway::fit {

/// The model with one or two candidates, refitted with all base parameters free.
struct Explanation {
  std::vector<std::size_t> members{};  ///< indices into Problem::candidates, rising
  Response response{};                 ///< empty where the law is bent
  ResponseFit fit{};
  std::vector<FitParameter> parameters{};  ///< base, then those of the members
  double gain = unset;  ///< fall of -2 ln L against the base, less ln N for each shape that is free
  Gate recheck{};       ///< of what is left, against the rest of the catalogue
  bool rechecked = false;
  double least_loss = unset;  ///< rise of -2 ln L when the lesser member of a pair is dropped
  bool elastic = false;       ///< with exponents that bend the law
  double speed_exponent = 0.0, load_exponent = 0.0, viscosity_exponent = 0.0;
  std::size_t exponents = 0;  ///< how many of them were free: of inputs that vary
  /// True if an exponent ended at the limit to which the law may be bent.
  [[nodiscard]] bool bent_to_a_bound() const;
};

/// All that is needed to hold an extended model against the data, and the fits made so far.
class Attribution {
 public:
  Attribution(const Problem& problem, const NoiseModel& noise, const ResponseFit& base,
              const Eigen::VectorXd& size);

  [[nodiscard]] const Gate& gate() const { return gate_; }
  /// Column of the gate's scores at which a candidate's begin, and how many it has.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> score_range(std::size_t candidate) const;
  /// Largest visibility of its scores.
  [[nodiscard]] double visibility(std::size_t candidate) const;

  /// Refits one candidate from two or more starts.
  [[nodiscard]] Explanation refit(const std::vector<std::size_t>& members,
                                  const std::vector<Eigen::VectorXd>& extra_starts = {}) const;
  /// Every testable, visible candidate alone; best first.
  [[nodiscard]] std::vector<Explanation> singles() const;
  /// Pairs that may beat the best single, refitted; best first. All are weighed linearised, those
  /// within reach of the best are refitted.
  [[nodiscard]] std::vector<Explanation> pairs(const std::vector<Explanation>& singles,
                                               const std::function<bool()>& cancelled) const;
  /// The law of one candidate bent by powers of speed, load and viscosity within +-0.2.
  [[nodiscard]] Explanation elastic(const Explanation& single) const;
  /// The gate again on an extended model.
  void recheck(Explanation& explanation) const;

 private:
  const Problem& problem_;
  const NoiseModel& noise_;
  const ResponseFit& base_;
  Eigen::MatrixXd surface_, scores_;  // whitened
  std::vector<bool> one_sided_;
  std::vector<std::size_t> owner_;  // candidate of each score
  NullDraws draws_;
  Gate gate_;
};

}  // namespace raceway::fit
