#include "effects/mounting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "model/model.h"
#include "spindle/spindle.h"
#include "spindle/spindle_subject.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

/// The rear set of the base spindle is rigid; here it may stand on springs of the same force.
model::Model mounted(bearing::Mounting mounting) {
  model::Model m = base_spindle();
  bearing::ArrangementDesign design = m.shaft->arrangement.design();
  design.preload = bearing::PreloadForce{m.shaft->arrangement.preload()};
  design.mounting = mounting;
  m.shaft->arrangement = bearing::Arrangement(std::move(design));
  return m;
}

double steady_displacement(const model::Model& model) {
  Report report;
  const Moment m =
      Simulator(model).steady({.speed = 8000.0 * rpm, .ambient_temperature = kelvin(20)}, report);
  EXPECT_TRUE(report.converged()) << report.message;
  return m.displacement;
}

TEST(Mounting, AsAnEffectASpindleOnSpringsMovesAsOneThatWasEnteredSo) {
  model::Model rigid = mounted(bearing::Mounting::rigid);
  const double as_entered = steady_displacement(rigid),
               sprung = steady_displacement(mounted(bearing::Mounting::spring));
  rigid.effects.push_back({effects::find(effects::OtherMounting::id, rigid.form()), {1.0}});
  EXPECT_NEAR(steady_displacement(rigid), sprung, 1e-3 * um);
  EXPECT_GT(std::abs(sprung - as_entered), 1.0 * um);
}

TEST(Mounting, IsACandidateOfASpindle) {
  const SpindleSubject subject(mounted(bearing::Mounting::rigid));
  const std::vector<fit::Candidate> all = subject.candidates();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const fit::Candidate& c) { return c.id == "mounting"; }));
  EXPECT_TRUE(subject.lacks("mounting", {}).empty()) << subject.lacks("mounting", {});
  // Growth and heat are those of the spindle itself.
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const fit::Candidate& c) {
    return c.id == "centrifugal-ring-growth";
  }));
}

}  // namespace
}  // namespace raceway::spindle
