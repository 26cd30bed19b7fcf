// The torque of a preloaded pair by formulas of its own: its preload is found, and what is hidden.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/data_file.h"
#include "files/model_file.h"
#include "files/subject.h"
#include "loop/loop.h"
#include "tests/hidden_effect/generator.h"

namespace hidden_effect {
namespace {

using namespace raceway;

constexpr double true_preload = 600.0;

struct Asked {
  std::shared_ptr<const model::ModelSubject> subject;
  record::Record record;
};

/// A rigid pair in O whose user enters the arrangement with two thirds of its preload.
Asked pair_on_shaft(const Machine& machine, const std::vector<Wish>& hidden, std::uint64_t seed) {
  const Rig rig = make_rig({.machine = &machine,
                            .plan = Plan::factorial,
                            .detail = {.level = 0.01},
                            .mistake = {.pair_preload = true_preload, .preload_grows = true},
                            .hidden = hidden,
                            .seed = seed});
  std::string text = model_text(rig);
  const auto replace = [&](const std::string& old, const std::string& by) {
    text.replace(text.find(old), old.size(), by);
  };
  replace("[rig]\nbearings = 2\n",
          "[arrangement]\nlayout = \"O\"\nfront = 1\nrear = 1\nmounting = \"rigid\"\n"
          "preload_N = 400\n");
  replace("free = [\"f0\", \"z\"]", "free = [\"f0\", \"z\", \"preload_N\"]");
  const model::Model model = files::parse_model(text, "model.toml").model;
  Asked asked{files::make_subject(model), {}};
  asked.record =
      files::read_record({"train.csv", measurement_text(rig, rig.train)}, *asked.subject);
  asked.subject = files::make_subject(model, asked.record);
  return asked;
}

TEST(SetTorque, ThePreloadOfAPairIsFoundFromItsTorque) {
  for (const Machine& machine : machines()) {
    const Asked asked = pair_on_shaft(machine, {}, 7);
    const verdict::Diagnosis d = loop::diagnose(*asked.subject, asked.record);
    EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << machine.name << ": " << d.sentence;
    const verdict::Calibration found = loop::calibrate(*asked.subject, asked.record);
    ASSERT_EQ(found.parameters.size(), 3U);
    const record::Parameter& preload = found.parameters[2];
    EXPECT_NEAR(preload.value, true_preload, 3.5 * preload.std) << machine.name;
    EXPECT_LT(preload.std, 0.1 * true_preload) << machine.name;
  }
}

TEST(SetTorque, AHiddenEffectOfAPairIsNamed) {
  for (const Machine& machine : machines().first(2)) {
    const Asked asked = pair_on_shaft(machine, {{"spin-friction", 0.1}}, 7);
    const verdict::Diagnosis d = loop::diagnose(*asked.subject, asked.record);
    EXPECT_THAT(d.sets, testing::Contains(testing::Contains("spin-friction")))
        << machine.name << ": " << d.sentence;
  }
}

}  // namespace
}  // namespace hidden_effect
