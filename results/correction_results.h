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

/// Errors of a correction model on a record that was not used to fit the model.
struct Validation {
  std::string data{};  ///< file of the record
  /// Error statistics, after the mean error of each run is subtracted.
  correction::Metrics metrics{};
  double uncorrected = unset;  ///< RMS of the readings minus their mean in each run [m]
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

/// Returns the error statistics of a comparison of predictions with readings.
[[nodiscard]] correction::Metrics metrics_of(const verdict::Comparison& comparison);

/// Displacement that a correction predicts for a record, with errors and uncertainty.
struct Corrected {
  const record::Channel* displacement = nullptr;
  correction::InitialState initial_state = correction::InitialState::rest;
  std::vector<double> predicted{};  ///< [m]
  std::vector<correction::Contribution> parts{};
  /// Statistics of the errors, after the mean error of each run is subtracted. All statistics are
  /// NaN if the record has no readings.
  correction::Metrics metrics{};
  correction::Beyond beyond{};
  std::vector<double> band{};  ///< half width of the 95 % band in each row [m]; empty if unknown
  double noise = unset;        ///< noise of a single reading [m]
  /// Share of the readings whose error, minus the mean error of the run, is inside the band [1].
  /// For this share, the band is widened by the noise of a reading.
  double readings_in_band = unset;
  correction::Trust trust{};
};

/// Returns CSV with the columns time_s, predicted_um, the contribution of each channel, and
/// residual_um (reading minus prediction). If the band is known, the columns band_low_um and
/// band_high_um are added. In a row without a reading, residual_um is empty. For several
/// displacements, each name ends with the column name of the displacement instead of the unit, such
/// as predicted_COLUMN. Angles have the unit urad instead of um.
[[nodiscard]] std::string corrected_text(const record::Record& record,
                                         const std::vector<Corrected>& corrected);
[[nodiscard]] std::string corrected_json(const std::string& model_file,
                                         const record::Record& record,
                                         const std::vector<Corrected>& corrected,
                                         const std::vector<record::Note>& messages);

}  // namespace raceway::results
