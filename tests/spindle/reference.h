#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/places.h"

namespace raceway::spindle {

/// Cases of data/reference/spindle_reference.json whose ids begin alike, and the test that holds
/// all of them, whatever their number.
struct Kind {
  std::string_view beginning, test;
};

/// Which test holds which case: that of the longest beginning.
inline constexpr Kind kinds[]{
    {"annular_gap_", "Film.OfAGapIsThatOfTheReference"},
    {"annulus", "Cells.AnAnnulusResistsAsItsLogarithm"},
    {"bar_heat", "Cells.ABarHeatedWithinExpandsAsItsClosedForm"},
    {"beam_element_", "Beam.ElementIsThatOfAnotherProgram"},
    {"bearing_conduction_", "BearingConduction.IsThatOfTheReference"},
    {"cantilever", "Beam.CantileverBendsAsTheClosedFormSays"},
    {"channel_", "Film.OfAChannelIsThatOfTheReference"},
    {"constriction_", "Contact.ConstrictionIsThatOfTheReference"},
    {"contact_", "Contact.OfRoughSurfacesIsThatOfTheReference"},
    {"convergence", "CoupledSpindle.ConvergesToTheFinestCellsOfTheIndependentModel"},
    {"fe_import_", "StepFit.GivesThePublishedStepResponsesBack"},
    {"finite_cylinder_", "Cells.AFiniteCylinderIsTheBesselSeries"},
    {"free_cylinder_", "Film.OfALyingCylinderIsThatOfTheReference"},
    {"friswell_", "Modes.RotorOnTwoSpringsIsThatOfTheBook"},
    {"hollow_cylinder_", "Cells.AHollowCylinderHeatedWithinIsAsHotAsItsClosedForm"},
    {"integrator", "TrBdf2.AmplifiesAsItsReferenceSaysAndDampsWhatIsStiff"},
    {"lumped_", "Network.OfOneBodyIsTheClosedForm"},
    {"network_", "Network.IsThatOfTheMatrixExponential"},
    {"overhung_nose_", "Beam.OverhungNoseIsExactAtNodesForAnyMesh"},
    {"pin_fin", "Cells.APinIsTheFinOfItsClosedForm"},
    {"pinned_beam", "Modes.PinnedBeamHasThoseOfTheClosedForm"},
    {"preload_feedback_", "CoupledSpindle.PreloadFeedbackIsThatOfTheIndependentModel"},
    {"press_", "PressFit.OfARingOnAShaftIsThatOfTheReference"},
    {"press_outer_ring_", "PressFit.OfTwoMaterialsIsThatOfTheReference"},
    {"radiation", "Film.OfRadiationIsThatOfTheReference"},
    {"rotating_shaft_", "Film.OfATurningShaftIsThatOfTheReference"},
    {"semi_infinite_", "Network.OfCellsWarmsAsAHalfSpace"},
    {"set_warm_", "WarmSets.OfOneTemperatureAreThoseOfTheReference"},
    {"set_warm_each_", "WarmSets.OfBearingsOfTheirOwnAreThoseOfTheReference"},
    {"spindle_deflection_", "Beam.SpindleBendsAsTheReferenceDoes"},
    {"spindle_modes_", "Modes.SpindleHasThoseOfTheReference"},
    {"spindle_steady_", "CoupledSpindle.SettlesAsTheIndependentModel"},
    {"step_responses_", "StepResponses.OfACooledSpindleAreThoseOfAnotherProgram"},
    {"substitute_force", "Expansion.SubstituteForcesGiveTheFreeElongation"},
    {"tangent_stiffness_modes_",
     "LoadedShaft.TangentStiffnessOfBearingsGivesTheModesOfTheReference"},
};

/// Null where no test holds the case.
inline const Kind* kind_of(std::string_view id) {
  const Kind* found = nullptr;
  for (const Kind& kind : kinds)
    if (id.starts_with(kind.beginning) &&
        (!found || kind.beginning.size() > found->beginning.size()))
      found = &kind;
  return found;
}

/// All cases of data/reference/spindle_reference.json.
inline const nlohmann::json& references() {
  static const nlohmann::json all = nlohmann::json::parse(
      std::ifstream(tests::source_dir() + "/data/reference/spindle_reference.json"));
  return all;
}

/// Those of one kind, for the test that `kinds` names and no other; none is a failure.
inline std::vector<nlohmann::json> references(std::string_view beginning) {
  std::vector<nlohmann::json> found;
  for (const nlohmann::json& one : references()) {
    const Kind* const kind = kind_of(one.at("id").get<std::string>());
    if (!kind || kind->beginning != beginning) continue;
    found.push_back(one);
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    EXPECT_EQ(kind->test, std::string(test.test_suite_name()) + "." + test.name()) << beginning;
  }
  EXPECT_FALSE(found.empty()) << "no case " << beginning;
  return found;
}

/// One of them, with its inputs and outputs. Throws where there is none.
inline nlohmann::json reference(const std::string& id) {
  for (const nlohmann::json& one : references())
    if (one.at("id") == id) return one;
  throw std::runtime_error("spindle_reference.json has no case " + id);
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

}  // namespace raceway::spindle
