#include <fmt/format.h>

#include <algorithm>

#include "correction/numbers.h"
#include "files/correction_file.h"
#include "record/digits.h"
#include "record/nearest_names.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/correction_prior.h"

namespace raceway::files {
namespace {

constexpr Key prior_keys[]{
    {"value", between(-1e12, 1e12), is_required,
     "expected value of PARAMETER before the next fit, in its unit; written by step-response and "
     "join"},
    {"std", between(0, 1e12), is_required,
     "standard uncertainty of the value, above 0; the smaller it is, the closer the next fit keeps "
     "the parameter to the value"},
};

}  // namespace

std::vector<KeyTable> prior_tables() { return {{"correction.prior.PARAMETER", prior_keys}}; }

void read_priors(const Section& correction, correction::Model& model) {
  const toml::node* const node = correction.find("prior");
  if (!node) return;
  if (!node->is_table())
    correction.fail("prior", fmt::format("prior = {}: must be a table, written as "
                                         "[correction.prior]",
                                         text::shown(*node)));
  const Section all(correction.source(), "correction.prior", node->as_table());
  std::vector<std::string> known;
  for (const record::Parameter& p : correction::parameters(model)) known.push_back(p.name);
  for (const auto& [key, prior] : *node->as_table()) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) == known.end())
      all.fail(name, fmt::format("{}: unknown parameter; nearest: {}", name,
                                 record::nearest_names(name, known, 3)));
    if (!prior.is_table())
      all.fail(name, fmt::format("{} = {}: must be {{ value = ..., std = ... }}", name,
                                 text::shown(prior)));
    const Section one(correction.source(), fmt::format("correction.prior.\"{}\"", name),
                      prior.as_table(), {prior_keys});
    const record::Prior read{.value = one.required("value"), .std = one.required("std")};
    if (!read.is_known()) one.fail("std", "std = 0: must be above 0");
    model.priors.push_back({name, read});
  }
}

std::string prior_text(const correction::Model& model) {
  if (model.priors.empty()) return {};
  std::string text =
      "[correction.prior]  # values before the next fit, with standard uncertainty\n";
  for (const correction::NumberPrior& p : model.priors)
    text += fmt::format("\"{}\" = {{ value = {}, std = {} }}\n", p.name,
                        text::toml_float(text::with_15_digits(p.prior.value)),
                        text::toml_float(record::with_digits(p.prior.std, 6)));
  return text;
}

}  // namespace raceway::files
