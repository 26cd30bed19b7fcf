#include "verdict/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fit/several_records.h"
#include "verdict/detail/investigation.h"

namespace raceway::verdict {
namespace {

constexpr double surely_other = 4.0;  // standard errors of a datum of one record
constexpr double a_bound = 0.02;      // share of its range at either end
constexpr double clearly = 10.0;      // in -2 ln L with its penalty

Diagnosis investigated(const fit::Subject& subject, const record::Record& record,
                       const DiagnoseOptions& options) {
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

bool is_single(const Diagnosis& d) {
  return d.verdict == Verdict::nothing_missing || d.verdict == Verdict::effect ||
         d.verdict == Verdict::ambiguous;
}

double bic_of(const Diagnosis& d) {
  return (d.fits.empty() ? d.likelihood : d.fits.front().likelihood).bic();
}

/// Numbers that `found` has beside those of `given`, and that are surely not as entered; none where
/// one of them ends at a bound.
std::vector<const record::Parameter*> wrong_ones(const Diagnosis& found, const Diagnosis& given) {
  std::vector<const record::Parameter*> list;
  for (const record::Parameter& p : found.base) {
    if (std::any_of(given.base.begin(), given.base.end(),
                    [&](const record::Parameter& known) { return known.name == p.name; }))
      continue;
    const double share = (p.value - p.lower) / (p.upper - p.lower);
    if (!(share > a_bound && share < 1.0 - a_bound)) return {};
    if (std::abs(p.value - p.neutral) > surely_other * p.std) list.push_back(&p);
  }
  return list;
}

/// The verdict where each record has the data for itself that may be other ones in it; `given`,
/// that with the data of the model, unless those of some record are surely wrong, and one effect
/// at most is missing beside them.
Diagnosis with_data_of_each_record(Diagnosis given, const fit::Subject& subject,
                                   const record::Record& record, const DiagnoseOptions& options) {
  const auto* const several = dynamic_cast<const fit::SeveralRecords*>(&subject);
  if (!several || given.verdict == Verdict::nothing_missing) return given;
  const std::unique_ptr<fit::SeveralRecords> own = several->with_data_of_each_record(record);
  if (!own) return given;
  DiagnoseOptions again = options;
  again.tried_before = given.candidates_tried;
  again.other_bases = false;
  Diagnosis found;
  try {
    found = investigated(*own, record, again);
  } catch (const std::invalid_argument&) {
    return given;
  }
  const std::vector<const record::Parameter*> wrong = wrong_ones(found, given);
  if (!is_single(found) || wrong.empty()) return given;
  // One effect stays unless another oil is clearly better. Several at once, which another oil looks
  // like, stay only where they are clearly better and something is missing with that oil too.
  const double better = bic_of(given) - bic_of(found);
  if ((is_single(given) && !(better > clearly)) ||
      (given.verdict == Verdict::several_effects && found.verdict != Verdict::nothing_missing &&
       !(better > -clearly)))
    return given;
  for (const record::Parameter* const p : wrong) {
    const std::size_t dot = p->name.find('.'), at = p->name.rfind('@');
    const std::string id = p->name.substr(0, dot);
    found.messages.insert(
        found.messages.begin(),
        record::note::check_data(
            fmt::format("check the oil of {}: {}; --per-record {} gives each record its own value",
                        p->name.substr(at + 1), own->correction(id, std::array{p->value}),
                        fmt::join(own->own(), ","))));
  }
  return found;
}

}  // namespace

Diagnosis diagnose_by_noise(const fit::Subject& subject, const record::Record& record,
                            const DiagnoseOptions& options) {
  if (options.progress) options.progress(0.0, "estimating the noise");
  return with_data_of_each_record(investigated(subject, record, options), subject, record, options);
}

}  // namespace raceway::verdict
