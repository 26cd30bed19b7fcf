#include "files/doubts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "files/data_file.h"
#include "files/model_file.h"
#include "files/subject.h"

namespace raceway::files {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::shared_ptr<const model::ModelSubject> subject() {
  return make_subject(parse_model("[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\n"
                                  "viscosity_40C_mm2_s = 22\nviscosity_100C_mm2_s = 4.8\n",
                                  "my.toml")
                          .model);
}

struct Row {
  double speed, load, temperature, torque;  // in the units of the columns
};

/// What the model reads, a third more of it and bent with speed: as far as effects go.
std::vector<Row> rows_of_a_rig() {
  std::vector<Row> list;
  for (double speed = 1000; speed < 13000; speed += 1000)
    for (const double load : {100.0, 300.0, 900.0})
      for (const double temperature : {30.0, 45.0}) list.push_back({speed, load, temperature, 1});
  std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (const Row& r : list)
    text += fmt::format("{},{},{},{}\n", r.speed, r.load, r.temperature, r.torque);
  const auto of = subject();
  const std::vector<double> torque = fit::predict(*of, read_record({"d.csv", text}, *of));
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].torque = torque[i] / N_mm * (1.1 + 0.3 * list[i].speed / 12000.0);
  return list;
}

std::vector<std::string> texts_of(const std::string& rows) {
  const auto of = subject();
  std::vector<std::string> texts;
  for (const Doubt& doubt : doubts(*of, read_record({"d.csv", rows}, *of)))
    texts.push_back(doubt.text);
  return texts;
}

/// Doubts about these rows once `change` has been made to each.
template <typename Change>
std::vector<std::string> after(const Change& change) {
  std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (Row r : rows_of_a_rig()) {
    change(r);
    text += fmt::format("{},{},{},{}\n", r.speed, r.load, r.temperature, r.torque);
  }
  return texts_of(text);
}

TEST(Doubts, ThereAreNoneAboutWhatAModelMayMiss) {
  for (const double factor : {0.2, 0.5, 1.0, 2.0, 4.5})
    EXPECT_THAT(after([&](Row& r) { r.torque *= factor / 1.2; }), IsEmpty()) << factor;
}

TEST(Doubts, AFactorOfReadingsIsNamed) {
  EXPECT_THAT(after([](Row& r) { r.torque *= 1e-3; }),
              ElementsAre("readings of friction torque are about 1000 times too small for the "
                          "model: are the values in N m instead of N mm?"));
  EXPECT_THAT(after([](Row& r) { r.torque *= 1e3; }),
              ElementsAre(HasSubstr("1000 times too large")));
  EXPECT_THAT(after([](Row& r) { r.torque /= 10; }),
              ElementsAre(HasSubstr("10 times too small for the model: are the values in cN m")));
  // Inputs in a larger unit are read as too small, so the model predicts too little.
  EXPECT_THAT(after([](Row& r) { r.torque *= 9.81; }),
              ElementsAre(HasSubstr("are the values in kgf instead of N?")));
  EXPECT_THAT(
      after([](Row& r) { r.torque *= 60; }),
      ElementsAre(HasSubstr("are the values in min instead of s, or in 1/s instead of rpm")));
}

/// A long record of which every fifth row is right: rows in step with it would tell nothing.
TEST(Doubts, ALongRecordIsNotLookedAtInStepWithWhatRepeatsInIt) {
  std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  const std::vector<Row> list = rows_of_a_rig();
  for (std::size_t k = 0; k < 1500; ++k) {
    const Row& r = list[k % list.size()];
    text += fmt::format("{},{},{},{}\n", r.speed, r.load, r.temperature,
                        k % 5 == 0 ? r.torque : 1e-3 * r.torque);
  }
  EXPECT_THAT(texts_of(text), ElementsAre(HasSubstr("N m instead of N mm")));
}

TEST(Doubts, TheOtherSignIsNamed) {
  EXPECT_THAT(
      after([](Row& r) { r.torque = -r.torque; }),
      ElementsAre(HasSubstr("readings of friction torque have the opposite sign: a torque against "
                            "the motion is positive")));
}

TEST(Doubts, TemperaturesInOtherUnitsAreNamed) {
  EXPECT_THAT(after([](Row& r) { r.temperature += 273.15; }),
              ElementsAre(HasSubstr("C: are the values in kelvin, that is 30 to 45 C?")));
  EXPECT_THAT(after([](Row& r) { r.temperature = 1.8 * r.temperature + 32; }),
              ElementsAre(HasSubstr("C: are the values in fahrenheit, that is 30 to 45 C?")));
}

TEST(Doubts, LoadsAndSpeedsInOtherUnitsAreNamed) {
  EXPECT_THAT(after([](Row& r) { r.load /= 9.81; }), ElementsAre(HasSubstr("kgf instead of N?")));
  EXPECT_THAT(after([](Row& r) { r.load /= 1000; }), ElementsAre(HasSubstr("kN instead of N?")));
  EXPECT_THAT(after([](Row& r) { r.speed /= 1000; }),
              ElementsAre(HasSubstr("krpm instead of rpm?")));
  EXPECT_THAT(after([](Row& r) { r.speed /= 60; }), ElementsAre(HasSubstr("1/s instead of rpm?")));
  EXPECT_THAT(after([](Row& r) { r.speed *= 9.5493; }), ElementsAre(HasSubstr("rad/s or 1/s?")));
}

/// A lone column of the outer ring leaves the viscosity to the model.
TEST(Doubts, ATemperatureThatTheViscosityDoesNotFollowIsNamed) {
  const auto rows = [](const std::string& column, double warmer) {
    std::string text = fmt::format("speed_rpm,axial_load_N,{},friction_torque_Nmm\n", column);
    for (const Row& r : rows_of_a_rig())
      text += fmt::format("{},{},{},{}\n", r.speed, r.load, r.temperature + warmer, r.torque);
    return texts_of(text);
  };
  EXPECT_THAT(rows("outer_ring_temperature_C", 20),
              ElementsAre(HasSubstr("all rows use the viscosity at 40 C, from [rig], but "
                                    "outer_ring_temperature_C goes from 50 to 65 C")));
  EXPECT_THAT(rows("temperature_C", 0), IsEmpty());
}

TEST(Doubts, SwappedColumnsAreNamed) {
  EXPECT_THAT(after([](Row& r) { std::swap(r.speed, r.torque); }),
              ElementsAre("columns speed_rpm and friction_torque_Nmm are probably swapped; correct "
                          "the header of the file or [columns]"));
  EXPECT_THAT(after([](Row& r) { std::swap(r.load, r.speed); }),
              ElementsAre("columns speed_rpm and axial_load_N are probably swapped; correct the "
                          "header of the file or [columns]"));
}

/// Displacements of a shaft as the model has them and 5 % more; preloads times `factor` in the
/// file.
std::vector<std::string> of_a_shaft(double factor) {
  const auto shaft = make_subject(
      parse_model("[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
                  "viscosity_100C_mm2_s = 4.8\n[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\n"
                  "mounting = \"rigid\"\npreload_N = 600\n",
                  "s.toml")
          .model);
  const auto rows = [](double preload_factor, const std::vector<double>& read) {
    std::string text = "speed_rpm,preload_N,axial_displacement_um\n";
    std::size_t row = 0;
    for (double speed = 1000; speed < 11000; speed += 1000)
      for (const double preload : {300.0, 600.0, 900.0}) {
        text += fmt::format("{},{:.6g},{:.6f}\n", speed, preload_factor * preload,
                            read.empty() ? 1.0 : 1.05 * read[row] / um);
        ++row;
      }
    return text;
  };
  const std::vector<double> read =
      fit::predict(*shaft, read_record({"d.csv", rows(1.0, {})}, *shaft));
  std::vector<std::string> texts;
  for (const Doubt& doubt : doubts(*shaft, read_record({"d.csv", rows(factor, read)}, *shaft)))
    texts.push_back(doubt.text);
  return texts;
}

TEST(Doubts, PreloadsOfAShaftInOtherUnitsAreNamed) {
  EXPECT_THAT(of_a_shaft(1.0), IsEmpty());
  EXPECT_THAT(of_a_shaft(0.75), IsEmpty());  // a recorded preload may be wrong
  EXPECT_THAT(of_a_shaft(1.0 / 9.80665),
              ElementsAre("preloads of 30.59 to 91.77 N do not agree with the readings, but 300 to "
                          "900 N do: are the values in kgf instead of N?"));
  EXPECT_THAT(of_a_shaft(1e-3), ElementsAre(HasSubstr("kN instead of N?")));
}

/// A coast-down of a shaft that takes `torque_factor` times what the model says, its times in a
/// unit of `unit` seconds.
std::vector<std::string> of_a_coast_down(double unit, double torque_factor) {
  const auto rig = make_subject(
      parse_model("[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
                  "viscosity_100C_mm2_s = 4.8\n[rig]\naxial_load_N = 300\ninertia_kgm2 = 0.5\n",
                  "c.toml")
          .model);
  const double inertia = 0.5;
  std::string speeds = "speed_rpm,friction_torque_Nmm\n";
  for (double n = 6000; n > 300; n -= 10) speeds += fmt::format("{},1\n", n);
  const std::vector<double> torque = fit::predict(*rig, read_record({"n.csv", speeds}, *rig));
  std::string text = "run_id,time_s,speed_rpm\n";
  double time = 0.0;
  for (std::size_t k = 0; k < torque.size(); ++k) {
    text += fmt::format("1,{:.9g},{}\n", time / unit, 6000 - 10 * static_cast<int>(k));
    time += inertia * 10 * rpm / (torque_factor * torque[k]);
  }
  std::vector<std::string> texts;
  for (const Doubt& doubt : doubts(*rig, read_record({"d.csv", text}, *rig)))
    texts.push_back(doubt.text);
  return texts;
}

TEST(Doubts, TimesOfACoastDownInOtherUnitsAreNamed) {
  EXPECT_THAT(of_a_coast_down(1.0, 1.3), IsEmpty());
  EXPECT_THAT(of_a_coast_down(1.0, 3.5), IsEmpty());
  EXPECT_THAT(of_a_coast_down(60.0, 1.0), ElementsAre(HasSubstr("times in min instead of s?")));
  EXPECT_THAT(of_a_coast_down(1e-3, 1.0), ElementsAre(HasSubstr("times in ms instead of s?")));
  // Where the law is off as well.
  EXPECT_THAT(of_a_coast_down(60.0, 2.5), ElementsAre(HasSubstr("times in min instead of s?")));
  EXPECT_THAT(of_a_coast_down(3600.0, 1.0), ElementsAre(HasSubstr("times in h instead of s?")));
}

}  // namespace
}  // namespace raceway::files
