#pragma once

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <array>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/model_data.h"
#include "results/sensitivity_results.h"
#include "session/sensitivity.h"
#include "text/number_range.h"

/// Computes the predictions of a model with changed data. Only sensitivity() uses this header.
namespace raceway::session::varied {

/// Numerical input of the request, for example the speed. The sensitivity to this input is computed
/// only if the request gives a single value for it.
struct Axis {
  std::string_view name, flag;
  std::vector<double> values;
  text::NumberRange range;
};

[[nodiscard]] std::vector<Axis> axes_of(const SensitivityQuestion& q, bool shaft);

/// Speed, loads and temperature of one operating point, one value for each Axis. NaN means the
/// value of the model.
using State = std::array<double, 4>;

/// Returns all combinations of the axis values; the speed varies fastest.
[[nodiscard]] std::vector<State> states_of(const std::vector<Axis>& axes);

inline constexpr std::string_view life = "life_h", stiffness = "axial_stiffness_N_um",
                                  hottest_ring = "hottest_ring_temperature_C";

/// Returns the names of all columns that can be requested.
[[nodiscard]] std::vector<std::string> known_columns(const model::Model& model, bool steady);

/// Computes the requested columns for changed data.
class Predictor {
 public:
  Predictor(const SensitivityQuestion& question, std::vector<std::string> wanted,
            const model::Model& model);

  [[nodiscard]] const std::vector<std::string>& wanted() const { return wanted_; }

  /// Returns the predictions [states x columns], in the units of the column names; NaN marks a
  /// missing value.
  [[nodiscard]] std::vector<double> operator()(const files::ModelFile& file,
                                               const std::vector<State>& states) const;

 private:
  [[nodiscard]] std::vector<double> at_once(const model::Model& model,
                                            const std::vector<State>& states) const;
  [[nodiscard]] std::vector<double> steady(const files::ModelFile& file,
                                           const std::vector<State>& states) const;

  const SensitivityQuestion& question_;
  std::vector<std::string> wanted_;
  std::size_t columns_ = 0;
  std::vector<std::size_t> places_;
  std::vector<double> units_;
};

/// Predictions with one set of changed data, or the reason why the model rejects these data.
struct Outcome {
  std::vector<double> values{};
  std::string refused{};
  [[nodiscard]] bool has_all() const {
    return refused.empty() &&
           std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  }
};

/// Input values ("data") of the model and of the request that can be varied.
class Data {
 public:
  Data(const files::ModelFile& file, const SensitivityQuestion& question,
       std::vector<State> states);

  [[nodiscard]] const std::vector<results::VariedDatum>& all() const { return all_; }
  [[nodiscard]] std::vector<results::VariedDatum>& all() { return all_; }

  /// Returns the index of a datum. If the question and the model have a datum of this name, returns
  /// the index of the datum of the question.
  [[nodiscard]] std::size_t find(const std::string& name) const;

  /// Returns true if the question names this datum, or if it names no data.
  [[nodiscard]] bool is_asked(std::size_t k) const;

  /// Returns the predictions with changed data. Each change consists of the index of a datum and
  /// its new value. Throws fit::Cancelled if the user cancels the calculation.
  [[nodiscard]] Outcome predict(const Predictor& predictor,
                                std::span<const std::pair<std::size_t, double>> changes) const;

 private:
  const SensitivityQuestion& question_;
  files::ModelData of_model_;
  std::vector<State> states_;
  std::vector<results::VariedDatum> all_;
  std::vector<std::size_t> asked_;
  // indices in `all_` of the data of the question, which follow the data of the model
  std::vector<std::size_t> axes_;
};

/// Calls `work(i)` for all i < count on all cores and reports progress from `from` to `to`.
template <typename Work>
void for_all(std::size_t count, const SensitivityQuestion& question, double from, double to,
             const Work& work) {
  std::mutex mutex;
  std::size_t ended = 0;
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        work(i);
        if (!question.progress) return;
        const std::lock_guard lock(mutex);
        question.progress(from +
                          (to - from) * static_cast<double>(++ended) / static_cast<double>(count));
      },
      tbb::simple_partitioner{});
}

}  // namespace raceway::session::varied
