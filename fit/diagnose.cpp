#include "fit/diagnose.h"

#include "fit/approximation_loop.h"
#include "fit/investigation.h"

namespace raceway::fit {

Diagnosis diagnose(const Subject& subject, const Record& record, const DiagnoseOptions& options) {
  if (subject.approximates()) return diagnose_approximation(subject, record, options);
  if (options.progress) options.progress(0.0, "estimating the noise");
  Investigation investigation(subject, record, options);
  investigation.look();
  if (investigation.is_anything_missing()) {
    investigation.attribute();
    investigation.confirm();
    investigation.propose();
  }
  return investigation.conclude();
}

}  // namespace raceway::fit
