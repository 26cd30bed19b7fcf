#include "verdict/diagnose.h"

#include "verdict/detail/investigation.h"

namespace raceway::verdict {

Diagnosis diagnose_by_noise(const fit::Subject& subject, const record::Record& record,
                            const DiagnoseOptions& options) {
  if (options.progress) options.progress(0.0, "estimating the noise");
  Investigation investigation(subject, record, options);
  investigation.look();
  if (investigation.is_anything_missing()) {
    investigation.attribute();
    investigation.confirm();
    investigation.try_other_bases();
    investigation.propose();
  }
  return investigation.conclude();
}

}  // namespace raceway::verdict
