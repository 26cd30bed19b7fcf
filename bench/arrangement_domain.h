#pragma once

#include <memory>
#include <utility>

#include "bearing/arrangement_equilibrium.h"
#include "bench/robustness_domain.h"

/// Random bearing sets on which the solver of arrangements must work.
namespace raceway::robustness {

struct ArrangementCase {
  bearing::Arrangement arrangement;
  bearing::ArrangementCondition condition;
  bearing::EquilibriumOptions options;
};

/// Returns arrangement number `index` of a seed; equal on every machine and for any number of
/// threads.
///   bearings         one to four in front, one to three at the rear, as in make_case(); equal in
///                    half of the cases; silicon nitride balls in a third of the cases
///   layout           tandem in a tenth of the cases, otherwise O or X
///   mounting         a quarter on springs of 0 to 100 N/um, half of these springs with 0 N/um
///   stiffness        half with a shaft and a housing of 50 to 5000 N/um
///   preload          0.0005 to 0.2 C0, uniform in its logarithm; offsets of faces up to 1 um
///   speed            n d_m up to 3e6 rpm mm for the larger bearing
///   external load    in half of the cases, up to 4 preloads in either direction
///   growth           in half of the cases, -5 to 15 um of the rings, -20 to 20 um of the shaft
inline ArrangementCase make_arrangement(const std::vector<Size>& sizes,
                                        bearing::RaceControl race_control, std::uint64_t seed,
                                        std::uint64_t index) {
  std::uint64_t state = seed * 0x9e3779b97f4a7c15ULL + index * 0xd1342543de82ef95ULL;
  const auto uniform = [&state](double lower, double upper) {
    return uniform_number(state, lower, upper);
  };
  const auto chance = [&](double share) { return uniform(0.0, 1.0) < share; };
  const auto count = [&](int most) {
    return static_cast<std::size_t>(std::min(uniform(0.0, most), most - 1e-9)) + 1;
  };
  using bearing::Layout, bearing::Mounting;

  const auto any_bearing = [&](std::uint64_t of) {
    const bearing::BearingGeometry g = make_case(sizes, race_control, of, index).geometry;
    const bearing::Material balls =
        chance(1.0 / 3.0) ? bearing::silicon_nitride() : bearing::steel();
    return std::make_shared<const bearing::Bearing>(g, balls, bearing::steel());
  };
  const Case base = make_case(sizes, race_control, seed, index);
  const double rating = base.rating;
  const auto first = any_bearing(seed);
  const auto second = chance(0.5) ? first : any_bearing(seed + 1);

  const double pitch =
      std::max(first->geometry().pitch_diameter, second->geometry().pitch_diameter);

  bearing::ArrangementDesign d;
  d.layout = chance(0.1)   ? Layout::tandem
             : chance(0.5) ? Layout::back_to_back
                           : Layout::face_to_face;
  const bool tandem = d.layout == Layout::tandem;
  const auto offset = [&] { return chance(0.5) ? uniform(-1.0, 1.0) * um : 0.0; };
  d.front.assign(count(4), {first});
  if (!tandem) d.rear.assign(count(3), {second});
  for (auto* set : {&d.front, &d.rear})
    for (bearing::MountedBearing& m : *set) m.offset = offset();
  if (tandem || chance(0.25)) {
    d.mounting = Mounting::spring;
    d.spring_rate = chance(0.5) ? 0.0 : uniform(0.0, 100.0) * N_per_um;
  }
  if (chance(0.5)) {
    d.shaft_stiffness = uniform(50.0, 5000.0) * N_per_um;
    d.housing_stiffness = uniform(50.0, 5000.0) * N_per_um;
  }
  const double preload = rating * std::exp(uniform(std::log(0.0005), std::log(0.2)));
  d.preload = bearing::PreloadForce{preload};

  bearing::ArrangementCondition c;
  c.speed = uniform(0.0, 3e6) / (pitch / mm) * rpm;
  if (chance(0.5)) c.external_load = uniform(-4.0, 4.0) * preload;
  if (chance(0.5)) {
    c.elongation = uniform(-20.0, 20.0) * um;
    const double growth = uniform(-5.0, 15.0) * um;
    c.shifts.assign(d.front.size() + d.rear.size(), {.radial = growth});
  }
  return {bearing::Arrangement(std::move(d)), c, {.race_control = race_control}};
}

}  // namespace raceway::robustness
