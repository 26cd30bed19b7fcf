#include "friction/contact/many_contacts.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "friction/contact/detail/contact_kernel.h"
#include "friction/contact/detail/contact_sums.h"
#include "friction/contact/ellipse_points.h"

namespace raceway::friction::contact {
namespace {

constexpr std::size_t points_of_chunk = 256;

/// The points of film_traction().
void take_points(KernelRace& k, bool spins) {
  const auto take = [&]<std::size_t Radial, std::size_t Angles>(
                        const EllipsePoints<Radial, Angles>& points, std::size_t first) {
    k.rings = Radial;
    k.angles = Angles - first;
    for (std::size_t i = 0; i < Radial; ++i) {
      k.s[i] = points.s[i];
      k.radius[i] = points.radius[i];
      k.weight[i] = points.weight[i];
    }
    for (std::size_t j = first; j < Angles; ++j) {
      k.cosine[j - first] = points.cosine[j];
      k.sine[j - first] = points.sine[j];
    }
  };
  if (spins)
    take(ellipse_points<12, 16>, 0);
  else
    take(ellipse_points<16, 24>, 12);
  k.copies = spins ? 2.0 : 4.0;
}

KernelRace kernel_race(const RaceFriction& race, bool spins) {
  const ContactShape& c = race.shape;
  const ContactLaw& law = race.law;
  const double R = c.radius_along, E = c.modulus, area = E * R * R, k = c.ellipse_ratio;
  const double ratio = R / c.radius_across, kappa = 1.0 / k;
  const double beta = 4.0 / pi * c.second_integral / (1.0 + ratio);
  const double U = 2.0 / (E * R);  // over η u
  const double width = 2.0 * c.unit_major_axis / R;
  KernelRace r{};
  r.flooded = law.supply == Inlet::flooded;
  r.starves = !std::isnan(law.inlet_over_b);
  r.unit_major_axis = c.unit_major_axis;
  r.ellipse_ratio = k;
  r.pressed_radius = c.pressed_radius;
  // The film of unit viscosity, pressure coefficient, speed and load.
  const Film unit = isothermal_film({.viscosity = 1.0,
                                     .pressure_viscosity = 1.0,
                                     .speed = 1.0,
                                     .modulus = E,
                                     .radius_along = R,
                                     .load = 1.0},
                                    k);
  r.central_factor = unit.central;
  r.minimum_factor = unit.minimum;
  r.roughness = law.composite_roughness;
  r.asperities_B = law.asperities.B;
  r.asperities_C = law.asperities.C;
  r.inlet_excess = law.inlet_over_b - 1.0;
  r.starved_central = 3.06 * std::pow(R, 0.58);
  r.starved_minimum = 3.34 * std::pow(R, 0.56);
  if (r.flooded) {
    r.rigid_factor =
        area * 0.77 / std::cbrt(beta) * std::pow(kappa, 0.12) * width * std::cbrt(U * U);
    r.elastic_factor = area * 1.8 * std::pow(beta, -0.25) * width * std::pow(U, 0.75);
  } else {
    r.rigid_factor =
        area * 0.835 * std::pow(ratio, -0.358) * std::pow(U, 0.636) * std::pow(area, -0.364);
    r.elastic_factor = area * 1.544 * std::cbrt(beta) * std::pow(kappa, -0.577) *
                       std::pow(U, 0.656) * std::pow(area, -0.466) * std::pow(E, 0.022);
  }
  r.moes_factor = std::pow(beta, 0.25) * kappa / area * std::pow(U, -0.75);
  r.rolling_factor = law.rolling_factor;
  r.hysteresis_factor = law.hysteresis_factor *
                        hysteresis_moment(race.ball_diameter, 1.0, c.radius_across / R, 0.5 * E);
  r.eyring_stress = law.eyring_stress;
  r.limiting_traction = law.limiting_traction;
  r.boundary_friction = law.boundary_friction;
  r.glass = FilmShear::glass;
  r.reference_pressure = Roelands::reference_pressure;
  take_points(r, spins);
  return r;
}

/// A contact in its place.
struct KernelPlace {
  std::size_t state, ball;
};

/// Contacts of one race that spin, or that do not, in the order of their states.
struct KernelLane {
  KernelRace race;
  std::vector<ContactBlock> blocks;
  std::vector<KernelPlace> places;

  void clear() { places.clear(); }
  /// The block and number of the next contact.
  std::pair<ContactBlock&, std::size_t> next(std::size_t state, std::size_t ball) {
    const std::size_t n = places.size();
    if (n / contacts_of_block >= blocks.size()) blocks.resize(n / contacts_of_block + 1);
    places.push_back({state, ball});
    return {blocks[n / contacts_of_block], n % contacts_of_block};
  }
};

/// Memory of a thread: inner and outer race, rolling straight and spinning.
struct KernelMemory {
  std::array<KernelLane, 4> lanes;
  std::vector<ContactSums> sums;
  std::vector<OilState> oils;
};

ContactKernel kernel_of(bearing::InstructionSet set) {
  switch (set) {
    case bearing::InstructionSet::avx512:
      return contact_kernel_avx512;
    case bearing::InstructionSet::avx2:
      return contact_kernel_avx2;
    case bearing::InstructionSet::sse2:
      break;
  }
  return contact_kernel_sse2;
}

class ManyContacts {
 public:
  ManyContacts(std::span<const BearingState<double>> states, std::span<const double> values,
               std::span<ContactResult> results, ContactKernel kernel, KernelMemory& memory)
      : states_(states),
        values_(values),
        results_(results),
        kernel_(kernel),
        m_(memory),
        law_(contact_law(*states[0].contact, values)) {
    for (const bool outer : {false, true})
      races_[outer] =
          race_friction(*states[0].bearing, outer ? bearing::Race::outer : bearing::Race::inner,
                        OilState{}, law_, 0.0);
  }

  void run() {
    for (std::size_t l = 0; l < m_.lanes.size(); ++l) {
      m_.lanes[l].clear();
      m_.lanes[l].race = kernel_race(races_[l / 2], l % 2 == 1);
    }
    m_.sums.assign(states_.size(), {});
    m_.oils.resize(states_.size());
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (alike(states_[i]))
        place(i);
      else
        results_[i] = contact_result(states_[i], values_);
    }
    for (std::size_t l = 0; l < m_.lanes.size(); ++l) take(l);
    for (std::size_t i = 0; i < states_.size(); ++i)
      if (alike(states_[i])) {
        m_.sums[i].give(results_[i]);
        results_[i].drag = ball_drag(states_[i], m_.oils[i].density, values_[5]);
      }
  }

 private:
  [[nodiscard]] bool alike(const BearingState<double>& s) const {
    return s.bearing == states_[0].bearing && s.contact == states_[0].contact && s.speed > 0.0 &&
           s.equilibrium != nullptr && s.equilibrium->report.converged() &&
           s.equilibrium->rotations.empty();
  }

  [[nodiscard]] RaceFriction race_of(std::size_t state, bool outer) const {
    const BearingState<double>& s = states_[state];
    return race_friction(*s.bearing, outer ? bearing::Race::outer : bearing::Race::inner,
                         m_.oils[state], law_, s.speed);
  }

  void place(std::size_t i) {
    const BearingState<double>& s = states_[i];
    const bearing::BearingGeometry& g = s.bearing->geometry();
    const OilState& oil = m_.oils[i] = oil_of(s);
    results_[i] = {};
    results_[i].friction.converged = true;
    const double loading =
        thermal_loading(oil.viscosity, oil.viscosity_slope, 1.0, oil.conductivity);
    const double supply =
        law_.replenishment > 0.0
            ? replenishment_factor(law_.replenishment, s.speed, oil.kinematic_viscosity,
                                   RingSize{g.bore, g.outer_diameter}, skf_angular_contact.K_Z)
            : 1.0;
    const bearing::Balls& balls = s.equilibrium->balls;
    for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
      const bearing::BallEquilibrium& ball = balls.distinct()[k];
      if (!(ball.outer_load > 0.0)) continue;
      const BallMotion motion = ball_motion(g, ball, s.race_control, s.speed);
      for (const bool outer : {false, true}) {
        const double load = outer ? ball.outer_load : ball.inner_load;
        if (!(load > 0.0)) continue;
        const ContactMotion& m = outer ? motion.outer : motion.inner;
        const double a = races_[outer].shape.unit_major_axis * std::cbrt(load);
        const bool spins =
            spins_beside(m.spin, m.rolling / (2.0 * races_[outer].shape.pressed_radius), a);
        auto [block, n] = m_.lanes[2 * outer + spins].next(i, k);
        block.load[n] = load;
        block.speed[n] = std::abs(m.surface_speed);
        block.rolling[n] = std::abs(m.rolling);
        block.spin[n] = std::abs(m.spin);
        block.viscosity[n] = oil.viscosity;
        block.pressure_viscosity[n] = oil.pressure_viscosity;
        block.loading[n] = loading;
        block.supply[n] = supply;
      }
    }
  }

  /// Runs the kernel on one lane and gives what it makes to the states.
  void take(std::size_t l) {
    KernelLane& lane = m_.lanes[l];
    const bool outer = l / 2 == 1;
    if (lane.places.empty()) return;
    const std::size_t count = lane.places.size(),
                      blocks = (count + contacts_of_block - 1) / contacts_of_block;
    fill_up(lane, count, blocks);
    kernel_(lane.race, l % 2 == 1, lane.blocks.data(), blocks);
    for (std::size_t n = 0; n < count; ++n)
      add(lane.places[n], lane.blocks[n / contacts_of_block], n % contacts_of_block, outer);
  }

  /// Some contact stands in the rest of the last block.
  static void fill_up(KernelLane& lane, std::size_t count, std::size_t blocks) {
    ContactBlock& last = lane.blocks[blocks - 1];
    for (std::size_t n = count % contacts_of_block; n != 0 && n < contacts_of_block; ++n)
      for (auto* of : {&last.load, &last.speed, &last.rolling, &last.spin, &last.viscosity,
                       &last.pressure_viscosity, &last.loading, &last.supply})
        (*of)[n] = (*of)[0];
  }

  void add(const KernelPlace& place, const ContactBlock& block, std::size_t n, bool outer) {
    const BearingState<double>& s = states_[place.state];
    const bearing::Balls& balls = s.equilibrium->balls;
    const bearing::BallEquilibrium& ball = balls.distinct()[place.ball];
    ContactFriction c;
    if (block.found[n] > 0.0) {
      c.sliding = block.sliding[n];
      c.rolling = block.rolled[n];
      c.hysteresis = block.hysteresis[n];
      c.film.minimum = block.film[n];
      c.film_ratio = block.film[n] / law_.composite_roughness;
      c.mean_friction = block.friction[n];
      c.mean_slip = block.slip[n];
    } else {  // what single precision cannot hold
      const BallMotion m = ball_motion(s.bearing->geometry(), ball, s.race_control, s.speed);
      c = race_of(place.state, outer).contact(block.load[n], outer ? m.outer : m.inner);
    }
    const double weight = balls.weight(place.ball);
    BearingFriction& f = results_[place.state].friction;
    f.add(c, weight, s.speed, outer ? f.outer : f.inner);
    m_.sums[place.state].add(c.mean_slip, c.mean_friction, block.load[n],
                             outer ? ball.outer_friction : ball.inner_friction, weight);
  }

  std::span<const BearingState<double>> states_;
  std::span<const double> values_;
  std::span<ContactResult> results_;
  ContactKernel kernel_;
  KernelMemory& m_;
  ContactLaw law_;
  std::array<RaceFriction, 2> races_;
};

/// Equivalent load of a race, Σ over all balls [N].
double equivalent_load(const bearing::Balls& balls, double exponent, bool outer) {
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    const double load = outer ? ball.outer_load : ball.inner_load;
    if (load > 0.0) sum += balls.weight(k) * std::pow(load, exponent);
    count += balls.weight(k);
  }
  return std::pow(sum / count, 1.0 / exponent);
}

struct NamedColumn {
  std::span<double> numbers;
  double (*of)(const BearingState<double>&, const ContactResult&);
};

std::array<NamedColumn, 12> named_columns(const FrictionColumns& c) {
  using State = BearingState<double>;
  using Result = ContactResult;
  return {
      {{c.torque, [](const State&, const Result& r) { return r.moment(); }},
       {c.rolling, [](const State&, const Result& r) { return r.rolling(); }},
       {c.sliding, [](const State&, const Result& r) { return r.sliding(); }},
       {c.hysteresis, [](const State&, const Result& r) { return r.hysteresis(); }},
       {c.drag, [](const State&, const Result& r) { return r.drag; }},
       {c.inner_heat, [](const State& s, const Result& r) { return ring_heat(r, s.speed).inner; }},
       {c.outer_heat, [](const State& s, const Result& r) { return ring_heat(r, s.speed).outer; }},
       {c.smallest_film, [](const State&, const Result& r) { return r.friction.smallest_film; }},
       {c.smallest_film_ratio,
        [](const State&, const Result& r) { return r.friction.smallest_film_ratio; }},
       {c.kinematic_viscosity, [](const State& s, const Result&) { return s.kinematic_viscosity; }},
       {c.inner_equivalent_load,
        [](const State& s, const Result&) {
          return equivalent_load(s.equilibrium->balls, 3.0, false);
        }},
       {c.outer_equivalent_load, [](const State& s, const Result&) {
          return equivalent_load(s.equilibrium->balls, 10.0 / 3.0, true);
        }}}};
}

}  // namespace

void contact_results(std::span<const BearingState<double>> states, std::span<const double> values,
                     std::span<ContactResult> results, bearing::InstructionSet set) {
  if (states.size() != results.size())
    throw std::invalid_argument(
        "contact_results: the number of results must equal the number of states");
  if (!bearing::available(set))
    throw std::invalid_argument("this computer does not support the instruction set " +
                                std::string(bearing::name(set)));
  if (states.empty()) return;
  thread_local KernelMemory memory;
  for (std::size_t first = 0; first < states.size(); first += points_of_chunk) {
    const std::size_t count = std::min(points_of_chunk, states.size() - first);
    ManyContacts(states.subspan(first, count), values, results.subspan(first, count),
                 kernel_of(set), memory)
        .run();
  }
}

void friction_of_many(const FrictionOfMany& asked, std::span<const bearing::OperatingPoint> points,
                      const FrictionColumns& columns, const bearing::EquilibriumOptions& options,
                      bearing::InstructionSet set) {
  const std::array<NamedColumn, 12> named = named_columns(columns);
  for (const NamedColumn& c : named)
    if (!c.numbers.empty() && c.numbers.size() != points.size())
      throw std::invalid_argument("friction_of_many: each column needs one number for each point");
  const std::size_t chunks = (points.size() + points_of_chunk - 1) / points_of_chunk;
  tbb::parallel_for(
      std::size_t{0}, chunks,
      [&](std::size_t chunk) {
        const std::size_t first = chunk * points_of_chunk,
                          count = std::min(points_of_chunk, points.size() - first);
        std::vector<bearing::BearingEquilibrium> balances(count);
        bearing::solve_many(*asked.bearing, points.subspan(first, count), balances, options, set);
        std::vector<BearingState<double>> states(count);
        std::vector<ContactResult> results(count);
        for (std::size_t i = 0; i < count; ++i) {
          const bearing::OperatingPoint& p = points[first + i];
          states[i] = {.bearing = asked.bearing,
                       .equilibrium = &balances[i],
                       .race_control = options.race_control,
                       .lubricant = asked.lubricant,
                       .contact = asked.data,
                       .speed = p.speed,
                       .axial_load = p.axial_load,
                       .radial_load = std::hypot(p.radial_load, p.radial_load_z),
                       .temperature = p.temperature,
                       .kinematic_viscosity = asked.lubricant->kinematic_viscosity(p.temperature)};
        }
        contact_results(states, asked.values, results, set);
        for (const NamedColumn& c : named)
          for (std::size_t i = 0; i < count && !c.numbers.empty(); ++i)
            c.numbers[first + i] =
                balances[i].report.converged() ? c.of(states[i], results[i]) : unset;
      },
      tbb::simple_partitioner());
}

}  // namespace raceway::friction::contact
