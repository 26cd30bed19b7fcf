#include "tests/spindle_study/simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spindle_study {
namespace {

constexpr double ten_thousand = 10000.0 * rpm;
constexpr double water_heat = 998.0 * 4182.0;  // [J/(m³ K)]
constexpr double ring_conductivity = 46.0;
constexpr double shaft_emissivity = 0.3;

double series(double a, double b) { return a > 0.0 && b > 0.0 ? a * b / (a + b) : 0.0; }

double dot(const Weights& w, const Eigen::VectorXd& t) {
  double sum = 0.0;
  for (const auto& [k, weight] : w) sum += weight * t[static_cast<Eigen::Index>(k)];
  return sum;
}

double sum_of(const Weights& w) {
  double sum = 0.0;
  for (const auto& [k, weight] : w) sum += weight;
  return sum;
}

Eigen::Index at(std::size_t k) { return static_cast<Eigen::Index>(k); }

double helix_length(const Helix& h) {
  return (h.end - h.start) / h.pitch * std::hypot(pi * h.diameter, h.pitch);
}

}  // namespace

Simulator::Simulator(const Spindle& spindle, const Hidden& hidden, double cell)
    : spindle_(spindle),
      hidden_(hidden),
      mesh_(make_mesh(spindle, cell)),
      set_(spindle.bearing, static_cast<int>(spindle.front.size()),
           static_cast<int>(spindle.rear.size()), spindle.preload),
      size_(mesh_.cells.size() + 1),
      has_water_(spindle.cooled) {
  capacity_ = Vector::Ones(at(size_));
  for (std::size_t k = 0; k < mesh_.cells.size(); ++k) capacity_[at(k)] = mesh_.cells[k].capacity;
  if (has_water_)
    capacity_[at(size_ - 1)] =
        water_heat * spindle.helix.width * spindle.helix.depth * helix_length(spindle.helix);
  contact_.assign(spindle.bearings(), 0.0);
  power_.assign(spindle.bearings(), 0.0);
  start(293.15);
}

void Simulator::start(double temperature) {
  mounted_ = temperature;
  time_ = 0.0;
  step_ = 10.0;
  temperature_ = Vector::Constant(at(size_), temperature);
  rate_ = Vector::Zero(at(size_));
  last_ = {};
  friction(rings(temperature_), 0.0, Inputs{});
}

std::vector<RingState> Simulator::rings(const Vector& t) const {
  std::vector<RingState> r;
  for (std::size_t b = 0; b < spindle_.bearings(); ++b)
    r.push_back({dot(mesh_.inner_rings[b], t) - mounted_, dot(mesh_.outer_rings[b], t) - mounted_});
  return r;
}

std::vector<double> Simulator::friction(const std::vector<RingState>& rings, double elongation,
                                        const Inputs& in) {
  state_ = balance(set_, in.speed, rings, elongation, state_.position);
  if (!spindle_.preload_feedback && in.speed != cold_speed_) {
    cold_ = balance(set_, in.speed, std::vector<RingState>(rings.size()), 0.0);
    cold_speed_ = in.speed;
  }
  const SetState& pressed = spindle_.preload_feedback ? state_ : cold_;
  std::vector<double> power;
  for (std::size_t b = 0; b < rings.size(); ++b) {
    const double oil = spindle_.oil.viscosity(mounted_ + 0.5 * (rings[b].inner + rings[b].outer));
    const double share = in.speed / ten_thousand;
    const double moment = palmgren(spindle_.f0, spindle_.z, spindle_.y, oil, in.speed / rpm,
                                   pressed.bearings[b].force, spindle_.bearing) +
                          hidden_.churning * share * share;
    power.push_back(in.speed > 0.0 ? moment * in.speed : 0.0);
    contact_[b] = contact_conductance(set_.bearing, state_.bearings[b], ring_conductivity);
  }
  return power;
}

void Simulator::add(std::size_t a, std::size_t b, double conductance) {
  const int i = static_cast<int>(a), j = static_cast<int>(b);
  entries_.emplace_back(i, i, conductance);
  entries_.emplace_back(j, j, conductance);
  entries_.emplace_back(i, j, -conductance);
  entries_.emplace_back(j, i, -conductance);
}

double Simulator::machine(const Inputs& in) const {
  return in.ambient + hidden_.structure_rise * (1.0 - std::exp(-now_ / hidden_.structure_time));
}

void Simulator::seats(const Vector& t, const Inputs& in) {
  const Spindle& s = spindle_;
  const Hoop shaft{0.5 * s.shaft_bore, 0.5 * s.bearing_bore, 210e9, 0.3, 7850.0, 11.5e-6};
  const Hoop inner{0.5 * s.bearing_bore, 0.5 * s.inner_shoulder, 208e9, 0.3, 7800.0, 11.5e-6};
  const Hoop outer{0.5 * s.outer_shoulder, 0.5 * s.bearing_outer, 208e9, 0.3, 7800.0, 11.5e-6};
  const Hoop bore{0.5 * s.bearing_outer, 0.5 * s.housing_diameter, 120e9, 0.26, 7250.0, 10.5e-6};
  std::vector<double> inside, outside;
  for (std::size_t b = 0; b < s.bearings(); ++b) {
    const auto rise = [&](const std::vector<Weights>& w) { return dot(w[b], t) - mounted_; };
    const Fit fit_i = press(shaft, inner, s.interference, in.speed, in.speed,
                            rise(mesh_.shaft_seats), rise(mesh_.inner_rings));
    const Fit fit_o = press(outer, bore, -s.clearance, 0.0, 0.0, rise(mesh_.outer_rings),
                            rise(mesh_.housing_seats));
    inside.push_back(rough_contact(fit_i, s.roughness, s.slope, s.hardness, 42.0, 46.0));
    outside.push_back(hidden_.outer_seat *
                      rough_contact(fit_o, s.roughness, s.slope, s.hardness, 46.0, 48.0));
  }
  for (const Link& l : mesh_.links) {
    double film = -1.0;
    if (l.kind == LinkKind::inner_seat) {
      film = inside[static_cast<std::size_t>(l.bearing)] * l.area;
    } else if (l.kind == LinkKind::outer_seat) {
      film = outside[static_cast<std::size_t>(l.bearing)] * l.area;
    } else if (l.kind == LinkKind::gap) {
      const double ta = t[at(l.a)], tb = t[at(l.b)];
      const double view = 1.0 / (1.0 / shaft_emissivity +
                                 l.inner_radius / l.outer_radius * (1.0 / shaft_emissivity - 1.0));
      film =
          l.area * (annular_gap(l.inner_radius, l.outer_radius, in.speed, air_at(0.5 * (ta + tb))) +
                    radiation(view, ta, tb));
    }
    const double half = series(l.half_a, l.half_b);
    add(l.a, l.b, film < 0.0 ? half : series(film, half));
  }
}

void Simulator::add_raceways() {
  const std::size_t n = spindle_.bearings();
  heating_.assign(n, Vector::Zero(at(size_)));
  for (const Raceway& r : mesh_.raceways) {
    const std::size_t b = static_cast<std::size_t>(r.bearing);
    const double balls =
        r.share * hidden_.bearing_conductance * (contact_[b] + spindle_.lubricant_conductance);
    add(r.inner, r.outer, series(balls, series(r.half_inner, r.half_outer)));
    // Half the heat at either raceway; some of it passes through the balls at once.
    const double through_i = series(balls, r.half_outer), through_o = series(balls, r.half_inner);
    const double stay_i = r.half_inner / (r.half_inner + through_i);
    const double stay_o = r.half_outer / (r.half_outer + through_o);
    heating_[b][at(r.inner)] += 0.5 * r.share * (stay_i + 1.0 - stay_o);
    heating_[b][at(r.outer)] += 0.5 * r.share * (stay_o + 1.0 - stay_i);
  }
}

/// Heat that is none of the bearings' own, spread by surface.
void Simulator::sources(const Inputs& in) {
  const double share = std::fabs(in.speed) / ten_thousand;
  const auto spread = [&](double heat, const auto& weight) {
    if (heat == 0.0) return;
    double sum = 0.0;
    for (const Cell& c : mesh_.cells) sum += weight(c);
    for (std::size_t k = 0; k < mesh_.cells.size(); ++k)
      load_[at(k)] += heat * weight(mesh_.cells[k]) / sum;
  };
  const double front_end = spindle_.front.back() + 0.5 * spindle_.bearing_width;
  const double rear_start = spindle_.rear.front() - 0.5 * spindle_.bearing_width;
  const double rear_end = spindle_.rear.back() + 0.5 * spindle_.bearing_width;
  const auto volume = [](const Cell& c) { return c.disc() * (c.x1 - c.x0); };
  const auto in_shaft = [&](double from, double to) {
    return [=](const Cell& c) {
      return c.part == Part::shaft && c.x() > from && c.x() < to ? volume(c) : 0.0;
    };
  };
  spread(0.5 * hidden_.motor * share, in_shaft(front_end, rear_start));
  spread(0.5 * hidden_.motor * share, [&](const Cell& c) {
    return c.part == Part::housing && c.x() > front_end && c.x() < rear_start &&
                   c.r0 < 0.5 * spindle_.bearing_outer + 1e-6
               ? c.x1 - c.x0
               : 0.0;
  });
  spread(hidden_.drive * share, in_shaft(rear_end, 1e9));
  spread(hidden_.seal * share,
         in_shaft(spindle_.housing_start, spindle_.front.front() - 0.5 * spindle_.bearing_width));
  if (now_ > hidden_.stray_from && now_ <= hidden_.stray_to)
    spread(hidden_.stray, [&](const Cell& c) {
      return c.part == Part::housing && c.x() > rear_start - 0.05 ? volume(c) : 0.0;
    });
}

void Simulator::freeze(const Vector& t, const Inputs& in) {
  entries_.clear();
  load_ = Vector::Zero(at(size_));
  const std::size_t water = size_ - 1;
  for (std::size_t k = 0; k < size_; ++k)
    entries_.emplace_back(static_cast<int>(k), static_cast<int>(k), 0.0);
  seats(t, in);
  add_raceways();
  face_conductance_.clear();
  double flange_area = 0.0;
  for (const Face& f : mesh_.faces)
    if (f.kind == FaceKind::flange) flange_area += f.area;
  const Helix& h = spindle_.helix;
  const double channel_film = !has_water_     ? 0.0
                              : in.coolant_on ? channel(h.flow, h.width, h.depth, helix_length(h))
                                              : h.standing;
  for (const Face& f : mesh_.faces) {
    const double ts = t[at(f.cell)], rise = ts - in.ambient, mean = 0.5 * (ts + in.ambient);
    const Air air = air_at(mean);
    double film = 0.0, beyond = in.ambient;
    switch (f.kind) {
      case FaceKind::housing_cylinder:
        film = hidden_.convection * free_cylinder(f.length, rise, air, mean) +
               radiation(spindle_.emissivity, ts, in.ambient);
        break;
      case FaceKind::housing_end:
        film = hidden_.convection * free_plate(f.length, rise, air, mean) +
               radiation(spindle_.emissivity, ts, in.ambient);
        break;
      case FaceKind::nose:
      case FaceKind::rear:
        film = std::max(free_cylinder(f.length, rise, air, mean),
                        turning_cylinder(f.length, in.speed, air)) +
               radiation(shaft_emissivity, ts, in.ambient);
        break;
      case FaceKind::flange:
        film = hidden_.flange * spindle_.flange_conductance / flange_area;
        beyond = machine(in);
        break;
      case FaceKind::channel:
        film = channel_film;
        break;
    }
    const double g = series(film * f.area, f.half);
    face_conductance_.push_back(g);
    if (f.kind == FaceKind::channel) {
      add(f.cell, water, g);
      continue;
    }
    entries_.emplace_back(static_cast<int>(f.cell), static_cast<int>(f.cell), g);
    load_[at(f.cell)] += g * beyond;
  }
  if (has_water_ && in.coolant_on) {
    const double flow = 2.0 * h.flow * water_heat;
    entries_.emplace_back(static_cast<int>(water), static_cast<int>(water), flow);
    load_[at(water)] += flow * h.inlet;
  }
  if (hidden_.sleeve > 0.0) {
    Weights w;
    const double from = spindle_.front.back() + 0.5 * spindle_.bearing_width;
    const double to = spindle_.rear.front() - 0.5 * spindle_.bearing_width;
    double sum = 0.0;
    for (std::size_t k = 0; k < mesh_.cells.size(); ++k) {
      const Cell& c = mesh_.cells[k];
      if (c.part != Part::housing || c.x() < from || c.x() > to || hidden_.sleeve_radius < c.r0 ||
          hidden_.sleeve_radius >= c.r1)
        continue;
      w.emplace_back(k, c.x1 - c.x0);
      sum += c.x1 - c.x0;
    }
    const double inlet = has_water_ ? h.inlet : in.ambient;
    for (const auto& [k, length] : w) {
      const double g = hidden_.sleeve * length / sum;
      entries_.emplace_back(static_cast<int>(k), static_cast<int>(k), g);
      load_[at(k)] += g * inlet;
    }
  }
  sources(in);
  conduction_.resize(at(size_), at(size_));
  conduction_.setFromTriplets(entries_.begin(), entries_.end());
}

Simulator::Vector Simulator::with_friction(const Vector& base, const std::vector<Vector>& response,
                                           const Inputs& in) {
  const std::size_t n = response.size();
  const Eigen::Index m = at(n);
  // Everything that friction asks of the temperatures is linear in the heat.
  Eigen::MatrixXd gain(2 * m + 1, m);
  Eigen::VectorXd offset(2 * m + 1);
  const auto functionals = [&](const Vector& t, double shift, auto&& row) {
    for (std::size_t b = 0; b < n; ++b) {
      row(at(2 * b)) = dot(mesh_.inner_rings[b], t) - shift;
      row(at(2 * b + 1)) = dot(mesh_.outer_rings[b], t) - shift;
    }
    row(2 * m) = dot(mesh_.elongation, t) - shift * sum_of(mesh_.elongation);
  };
  functionals(base, mounted_, offset);
  for (std::size_t b = 0; b < n; ++b) {
    Eigen::VectorXd column(2 * m + 1);
    functionals(response[b], 0.0, column);
    gain.col(at(b)) = column;
  }
  const auto miss = [&](const Eigen::VectorXd& q) {
    const Eigen::VectorXd v = offset + gain * q;
    std::vector<RingState> r;
    for (std::size_t b = 0; b < n; ++b) r.push_back({v[at(2 * b)], v[at(2 * b + 1)]});
    const std::vector<double> p = friction(r, v[2 * m], in);
    Eigen::VectorXd out(m);
    for (std::size_t b = 0; b < n; ++b) out[at(b)] = q[at(b)] - p[b];
    return out;
  };
  Eigen::VectorXd q(m);
  for (std::size_t b = 0; b < n; ++b) q[at(b)] = power_[b];
  Eigen::VectorXd r = miss(q);
  // Newton by differences, then Broyden.
  Eigen::MatrixXd slope(m, m);
  for (Eigen::Index b = 0; b < m; ++b) {
    Eigen::VectorXd moved = q;
    const double by = 0.01 * std::fabs(q[b]) + 0.1;
    moved[b] += by;
    slope.col(b) = (miss(moved) - r) / by;
  }
  for (int i = 0; i < 40; ++i) {
    const Eigen::VectorXd move = -slope.partialPivLu().solve(r);
    q += move;
    const Eigen::VectorXd next = miss(q);
    slope += (next - r - slope * move) * move.transpose() / std::max(move.squaredNorm(), 1e-30);
    r = next;
    if (r.norm() < 1e-6 + 1e-8 * q.norm()) break;
    if (i == 39) throw Runaway("friction and temperatures do not settle");
  }
  Vector t = base;
  for (std::size_t b = 0; b < n; ++b) {
    power_[b] = q[at(b)];
    t += q[at(b)] * response[b];
  }
  return t;
}

void Simulator::step(double h, const Inputs& in) {
  constexpr double gamma = 2.0 - 1.4142135623730951;
  const double w = 0.5 * gamma * h;
  const Vector start = temperature_;
  Vector middle = start + 0.5 * h * rate_, end;
  now_ = time_ + 0.5 * h;
  std::vector<double> power0 = friction(
      rings(start), dot(mesh_.elongation, start) - mounted_ * sum_of(mesh_.elongation), in);
  for (int sweep = 0; sweep < 4; ++sweep) {
    freeze(middle, in);
    Eigen::SparseMatrix<double> system = w * conduction_;
    system.diagonal() += capacity_;
    if (!analysed_) solver_.analyzePattern(system);
    analysed_ = true;
    solver_.factorize(system);
    Vector rate = load_ - conduction_ * start;
    std::vector<Vector> response;
    for (std::size_t b = 0; b < heating_.size(); ++b) {
      rate += power0[b] * heating_[b];
      response.push_back(solver_.solve(Vector(w * heating_[b])));
    }
    const Vector first = with_friction(
        solver_.solve(Vector(capacity_.cwiseProduct(start) + w * (rate + load_))), response, in);
    const std::vector<double> power1 = power_;
    const double a = 1.0 / (gamma * (2.0 - gamma)), b = (1.0 - gamma) * (1.0 - gamma) * a;
    end = with_friction(
        solver_.solve(Vector(capacity_.cwiseProduct(a * first - b * start) + w * load_)), response,
        in);
    const Vector now = 0.5 * (start + end);
    const double change = (now - middle).cwiseAbs().maxCoeff();
    middle = now;
    // C (T1 - T0) = h (v f0 + v f1 + w f2) with v = √2/4, exactly.
    const double v = 0.25 * 1.4142135623730951 * h;
    Vector flow =
        v * (2.0 * load_ - conduction_ * (start + first)) + w * (load_ - conduction_ * end);
    double heat = 0.0;
    for (std::size_t k = 0; k < heating_.size(); ++k) {
      flow += (v * (power0[k] + power1[k]) + w * power_[k]) * heating_[k];
      heat += v * (power0[k] + power1[k]) + w * power_[k];
    }
    const double error = (capacity_.cwiseProduct(end - start) - flow).sum();
    if (change < 0.05 || sweep == 3) {
      balance_error_ = std::max(balance_error_, std::fabs(error) / (1.0 + std::fabs(heat)));
      break;
    }
  }
  rate_ = (end - start) / h;
  temperature_ = end;
  time_ += h;
}

void Simulator::advance(const Inputs& in, double longest) {
  const bool changed = in.speed != last_.speed || in.coolant_on != last_.coolant_on;
  if (changed) {
    step_ = 10.0;
    rate_.setZero();
  }
  last_ = in;
  while (in.time - time_ > 1e-6) {
    const double left = in.time - time_;
    double h = std::min({step_, longest, left});
    if (left - h < 0.5 * h) h = left <= longest ? left * (left > 1.01 * h ? 0.5 : 1.0) : h;
    step(h, in);
    step_ = std::min(2.0 * step_, longest);
  }
  now_ = time_;
}

void Simulator::settle(const Inputs& in) {
  last_ = in;
  now_ = 1e9;
  friction(rings(temperature_), 0.0, in);
  for (int sweep = 0; sweep < 400; ++sweep) {
    freeze(temperature_, in);
    Eigen::SparseMatrix<double> system = conduction_;
    system.diagonal().array() += 1e-9;
    if (!analysed_) solver_.analyzePattern(system);
    analysed_ = true;
    solver_.factorize(system);
    std::vector<Vector> response;
    for (const Vector& q : heating_) response.push_back(solver_.solve(q));
    const Vector next = with_friction(solver_.solve(load_), response, in);
    const double change = (next - temperature_).cwiseAbs().maxCoeff();
    temperature_ += (sweep < 3 ? 1.0 : 0.5) * (next - temperature_);
    if (change < 1e-6) return;
  }
  throw std::runtime_error("no steady state within 400 sweeps");
}

Balance Simulator::heat(const Inputs& in) {
  freeze(temperature_, in);
  Balance b;
  for (double p : power_) b.in += p;
  for (std::size_t k = 0; k < mesh_.faces.size(); ++k) {
    const Face& f = mesh_.faces[k];
    const double t = temperature_[at(f.cell)];
    switch (f.kind) {
      case FaceKind::housing_cylinder:
        b.out["housing"] += face_conductance_[k] * (t - in.ambient);
        break;
      case FaceKind::housing_end:
        b.out["face"] += face_conductance_[k] * (t - in.ambient);
        break;
      case FaceKind::nose:
        b.out["nose"] += face_conductance_[k] * (t - in.ambient);
        break;
      case FaceKind::rear:
        b.out["rear"] += face_conductance_[k] * (t - in.ambient);
        break;
      case FaceKind::flange:
        b.out["flange"] += face_conductance_[k] * (t - machine(in));
        break;
      case FaceKind::channel:
        b.out["coolant"] += face_conductance_[k] * (t - temperature_[at(size_ - 1)]);
        break;
    }
  }
  return b;
}

Reading Simulator::reading() const {
  Reading r;
  r.time = time_;
  r.elongation = dot(mesh_.elongation, temperature_) - mounted_ * sum_of(mesh_.elongation);
  r.set = state_;
  r.displacement = state_.position + dot(mesh_.nose, temperature_) - mounted_ * sum_of(mesh_.nose);
  for (const Weights& w : mesh_.inner_rings) r.inner_rings.push_back(dot(w, temperature_));
  for (const Weights& w : mesh_.outer_rings) r.outer_rings.push_back(dot(w, temperature_));
  for (const Weights& w : mesh_.thermometers) r.thermometers.push_back(dot(w, temperature_));
  r.power = power_;
  return r;
}

}  // namespace spindle_study
