#pragma once

#include <memory>
#include <string>
#include <vector>

#include "correction/alignment.h"
#include "correction/correction_subject.h"
#include "correction/range.h"
#include "correction/record_check.h"
#include "fit/add.h"
#include "fit/check.h"
#include "fit/compare.h"
#include "fit/diagnosis.h"
#include "io/record_report.h"
#include "session/correction_input.h"
#include "session/loop_question.h"

/// What of the loop is asked in another way of a correction.
namespace raceway::session {

/// A correction with its record, ready for fit::diagnose(), fit::calibrate() and fit::add().
struct CorrectionLoop : CorrectionQuestion {
  std::shared_ptr<const correction::CorrectionSubject> subject{};
};

/// Opens both, and looks at the sensors. Throws io::InputError as ask_correction(), prepare_fit()
/// and Tolerance.
[[nodiscard]] CorrectionLoop ask_correction_loop(Messages& messages, const Source& model,
                                                 const std::vector<Source>& data,
                                                 const LoopOptions& options);

/// The effects that a person means by these names; see CorrectionSubject::meant_by(). Throws
/// io::InputError where several are meant.
[[nodiscard]] std::vector<std::string> meant(const CorrectionLoop& asked,
                                             const std::vector<std::string>& ids);

/// The report on what was asked, as one page.
[[nodiscard]] std::string diagnosis_page(const CorrectionLoop& asked,
                                         const fit::Diagnosis& diagnosis);
[[nodiscard]] std::string add_page(const CorrectionLoop& asked, const fit::AddResult& result);

/// The text of the file with the numbers of a calibration that grew out of its model, what its
/// record showed them, and how sure they are.
[[nodiscard]] std::string fitted_text(const CorrectionQuestion& asked,
                                      const fit::Calibration& found);

/// What a record over time can tell of a correction.
struct CheckedCorrection {
  CorrectionQuestion asked{};
  fit::Check check{};
  correction::RecordCheck over_time{};

  [[nodiscard]] std::string json() const;
};

/// Throws io::InputError as ask_correction(), and for a record of something else.
[[nodiscard]] CheckedCorrection check_correction(Messages& messages, const Source& model,
                                                 const std::vector<Source>& data,
                                                 const std::string& displacement,
                                                 const Reading& reading);

/// Corrections held against one record, in the order given.
struct ComparedCorrections {
  record::Record data{};
  std::vector<std::string> names{};                         ///< of the models, by their files
  std::vector<std::vector<fit::Comparison>> comparisons{};  ///< of each, by measured channel
  std::vector<correction::Beyond> beyond{};
  std::vector<io::DrawnModel> drawn{};

  [[nodiscard]] std::string json() const;
  /// The report, as one page.
  [[nodiscard]] std::string page() const;
};

/// Compares them with the constant of each run that `zero` means: "mean", "first" or "none". Those
/// of `refit` are fitted to the record before. Throws io::InputError: a model without correction,
/// parameters of each record, and as ask_correction().
[[nodiscard]] ComparedCorrections compare_corrections(
    Messages& messages, const std::vector<Source>& models, const std::vector<Source>& data,
    const std::vector<std::string>& refit, const std::string& zero, const LoopOptions& options);

}  // namespace raceway::session
