// No rig of the study, with whatever is hidden in it, looks entered wrong; one that is, does.
#include "files/doubts.h"

#include <gtest/gtest.h>

#include <string>

#include "files/data_file.h"
#include "files/model_file.h"
#include "files/subject.h"
#include "tests/hidden_effect/bars.h"

namespace hidden_effect {
namespace {

using namespace raceway;

TEST(Doubts, AreNotRaisedByHiddenEffects) {
  constexpr int seeds = RACEWAY_DOUBT_SEEDS;
  int rigs = 0;
  for (const Block& block : blocks())
    for (const Trial& trial : trials(block.id, seeds)) {
      const Rig rig = make_rig(trial.setup);
      const auto subject =
          files::make_subject(files::parse_model(model_text(rig), "model.toml").model);
      const record::Record data =
          files::read_record({"train.csv", measurement_text(rig, rig.train)}, *subject);
      const std::vector<files::Doubt> doubts = files::doubts(*subject, data);
      const Mistake& mistake = trial.setup.mistake;
      const bool in_other_unit = mistake.in_fahrenheit || mistake.in_kilograms;
      if (in_other_unit) {
        EXPECT_FALSE(doubts.empty()) << trial.kind << ", seed " << trial.setup.seed;
        continue;
      }
      for (const files::Doubt& doubt : doubts)
        ADD_FAILURE() << trial.kind << ", seed " << trial.setup.seed << ": " << doubt.text;
      ++rigs;
    }
  EXPECT_GT(rigs, 200);
  RecordProperty("rigs", rigs);
}

}  // namespace
}  // namespace hidden_effect
