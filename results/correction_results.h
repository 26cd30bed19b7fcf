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

/// Errors of a model on a record that its fit did not use.
struct Validation {
  std::string data{};             ///< file of the record
  correction::Metrics metrics{};  ///< errors after subtracting one constant
  double uncorrected = unset;     ///< rms of the readings after subtracting one constant [m]
  std::size_t rows_beyond_range = 0;
};

/// Returns the document of `raceway identify --json` for one or several displacements.
/// `validations` has one entry for each displacement or is empty.
[[nodiscard]] std::string identification_json(const std::string& model_file,
                                              const record::Record& record,
                                              const std::vector<correction::Identification>& found,
                                              const std::vector<Validation>& validations);

/// Returns the document of `raceway identify --baseline arx --json` for one or several
/// displacements.
[[nodiscard]] std::string arx_json(
    const std::string& model_file, const record::Record& record,
    const std::vector<std::pair<const record::Channel*, correction::ArxBaseline>>& found);

/// Returns the errors of a comparison, computed by the definitions that papers use.
[[nodiscard]] correction::Metrics metrics_of(const verdict::Comparison& comparison);

/// Result of a correction on a record.
struct Corrected {
  const record::Channel* displacement = nullptr;
  correction::InitialState initial_state = correction::InitialState::rest;
  std::vector<double> predicted{};  ///< [m]
  std::vector<correction::Contribution> parts{};
  correction::Metrics metrics{};  ///< errors after subtracting one constant; empty without readings
  correction::Beyond beyond{};
  std::vector<double> band{};  ///< half width of the band [m]; empty if unknown
  double noise = unset;        ///< noise of a single reading [m]
  /// Share of the readings within the band that is widened by the noise of the readings, after
  /// subtracting one constant as in the metrics.
  double readings_in_band = unset;
  correction::Trust trust{};
};

/// Returns the columns time_s, predicted_um, band_low_um and band_high_um (if the band is known),
/// the contribution of each channel, and residual_um for rows with a reading. For several
/// displacements, the names are predicted_COLUMN and CHANNEL_COLUMN. The columns of an angle have
/// urad in place of um.
[[nodiscard]] std::string corrected_text(const record::Record& record,
                                         const std::vector<Corrected>& corrected);
[[nodiscard]] std::string corrected_json(const std::string& model_file,
                                         const record::Record& record,
                                         const std::vector<Corrected>& corrected,
                                         const std::vector<record::Note>& messages);

}  // namespace raceway::results
