#pragma once

#include <string>
#include <vector>

#include "correction/baseline.h"
#include "correction/identify.h"
#include "correction/range.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "record/record.h"
#include "verdict/compare.h"

namespace raceway::results {

/// Errors of a model on a record that it did not see.
struct Validation {
  std::string data{};             ///< file of the record
  correction::Metrics metrics{};  ///< one constant removed
  double uncorrected = unset;     ///< RMS of the readings themselves, one constant removed [m]
  std::size_t rows_beyond_range = 0;
};

/// The document of `raceway identify --json`, of one displacement or several. `validations`: of
/// each of them, or empty.
[[nodiscard]] std::string identification_json(const std::string& model_file,
                                              const record::Record& record,
                                              const std::vector<correction::Identification>& found,
                                              const std::vector<Validation>& validations);

/// The document of `raceway identify --baseline arx --json`, of one displacement or several.
[[nodiscard]] std::string arx_json(
    const std::string& model_file, const record::Record& record,
    const std::vector<std::pair<const record::Channel*, correction::ArxBaseline>>& found);

/// The errors of a comparison by the definitions of papers.
[[nodiscard]] correction::Metrics metrics_of(const verdict::Comparison& comparison);

/// Result of a correction on a record.
struct Corrected {
  const record::Channel* displacement = nullptr;
  correction::InitialState initial_state = correction::InitialState::rest;
  std::vector<double> predicted{};  ///< [m]
  std::vector<correction::Contribution> parts{};
  correction::Metrics metrics{};  ///< one constant removed; empty where nothing was read
  correction::Beyond beyond{};
  std::vector<double> band{};  ///< half its width [m]; empty where none is known
  double noise = unset;        ///< of a single reading [m]
  /// Share of the readings that lie within it and their noise, one constant removed as in the
  /// metrics.
  double readings_in_band = unset;
  correction::Trust trust{};
};

/// time_s, predicted_um (of several displacements predicted_COLUMN), band_low_um and band_high_um
/// where a band is known, what each channel adds (of several displacements CHANNEL_COLUMN), and
/// where it was read the residual_um. An angle has urad in the place of um.
[[nodiscard]] std::string corrected_text(const record::Record& record,
                                         const std::vector<Corrected>& corrected);
[[nodiscard]] std::string corrected_json(const std::string& model_file,
                                         const record::Record& record,
                                         const std::vector<Corrected>& corrected,
                                         const std::vector<record::Note>& messages);

}  // namespace raceway::results
