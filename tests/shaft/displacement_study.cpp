// displacement_study: how often the diagnosis of a shaft's displacement is right. See
// docs/shaft.md.

#include <fmt/core.h>
#include <glog/logging.h>
#include <tbb/parallel_for.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "model/parameters.h"
#include "tests/shaft/shaft_records.h"
#include "tests/support/loop.h"

namespace {

using namespace raceway;
using namespace raceway::fit;
using namespace raceway::verdict;

struct Hidden {
  std::string id;  ///< empty: none
  std::string size;
  Model truth;
};

/// The truth where the model has another number.
Model entered_wrong(const std::string& parameter, double truth) {
  Model model = two_against_one();
  for (const Parameter& p : model::parameters(model))
    if (p.name == parameter) model::set(model, p, truth);
  return model;
}

std::vector<Hidden> cases() {
  const auto effect = [](const char* id, double value, const char* size) {
    std::vector<double> values = effects::initial_values(*effects::find(id, effects::Form::shaft));
    values.front() = value;
    return Hidden{id, size, with_effect(two_against_one(), id, std::move(values))};
  };
  return {{"", "", two_against_one()},
          effect("centrifugal-ring-growth", 3.0, "3 um at 10 000 rpm"),
          effect("thermal-preload", 0.006, "0.006 um/W"),
          effect("thermal-ring-growth", 0.4, "0.4 um/K"),
          effect("interference-fit", 8.0, "8 um"),
          effect("shaft-contraction", 1.0, "1 um at 10 000 rpm"),
          {"mounting", "springs of constant force", two_against_one_on_springs()},
          {"ball-material", "silicon nitride for steel",
           two_against_one_with(bearing::silicon_nitride())},
          effect("displacement-offset", 0.3, "0.3 um"),
          {"displacement-temperature-drift", "0.5 um / 10 K from 22 C",
           with_effect(two_against_one(), "displacement-temperature-drift", {0.5, 22.0})},
          {"contact-angle", "22.5 for 25 deg", entered_wrong("contact_angle_deg", 22.5)},
          {"conformity", "0.53 for 0.52", entered_wrong("conformity", 0.53)}};
}

struct Counts {
  int right = 0;    ///< the effect alone, or nothing where there is none
  int in_set = 0;   ///< one of several that the data cannot tell apart
  int wrong = 0;    ///< another effect, or any where there is none
  int unnamed = 0;  ///< effect-like, not in the catalogue, or missed
};

Counts count(const Hidden& hidden, ShaftPlan plan, int seeds) {
  std::vector<Diagnosis> found(static_cast<std::size_t>(seeds));
  tbb::parallel_for(0, seeds, [&](int k) {
    found[static_cast<std::size_t>(k)] = diagnose(
        two_against_one(), undeclared_records(hidden.truth, plan, 1000 + static_cast<unsigned>(k)));
  });
  Counts counts;
  for (const Diagnosis& d : found) {
    bool named = false;
    for (const RankedEffect& e : d.effects) named = named || (e.in_verdict && e.id == hidden.id);
    const bool tells = d.verdict == Verdict::effect || d.verdict == Verdict::ambiguous ||
                       d.verdict == Verdict::several_effects;
    if (d.verdict == Verdict::nothing_missing)
      ++(hidden.id.empty() ? counts.right : counts.unnamed);
    else if (tells && named)
      ++(d.verdict == Verdict::effect ? counts.right : counts.in_set);
    else
      ++(tells || hidden.id.empty() ? counts.wrong : counts.unnamed);
  }
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_minloglevel = google::FATAL;
  const int seeds = argc == 3 && std::string(argv[1]) == "--seeds" ? std::atoi(argv[2])
                    : argc == 1                                    ? 60
                                                                   : 0;
  if (seeds < 1) {
    fmt::print(stderr, "displacement_study [--seeds N]: N data sets of each case, default 60\n");
    return 1;
  }
  fmt::print("{} data sets of each case: right / in the set / another name / none named, in %\n\n",
             seeds);
  fmt::print("| hidden | size | one sweep | two preloads | up and down |\n");
  fmt::print("| --- | --- | --- | --- | --- |\n");
  for (const Hidden& hidden : cases()) {
    fmt::print("| {} | {} |", hidden.id.empty() ? "nothing" : "`" + hidden.id + "`", hidden.size);
    for (const ShaftPlan plan :
         {ShaftPlan::sweep, ShaftPlan::two_preloads, ShaftPlan::up_and_down}) {
      const bool fed =
          plan == ShaftPlan::up_and_down ||
          (hidden.id != "thermal-ring-growth" && hidden.id.find("drift") == hidden.id.npos);
      if (!fed) {  // no ring temperatures, one temperature
        fmt::print(" - |");
        continue;
      }
      const Counts c = count(hidden, plan, seeds);
      const auto share = [&](int n) { return 100.0 * n / seeds; };
      fmt::print(" {:.0f} / {:.0f} / {:.0f} / {:.0f} |", share(c.right), share(c.in_set),
                 share(c.wrong), share(c.unnamed));
    }
    fmt::print("\n");
  }
  return 0;
}
