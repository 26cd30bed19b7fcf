#include "spindle/beam.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/validation.h"

namespace raceway::spindle {
namespace {

constexpr double same_node = 1e-9;  // [m]

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_entry(Triplets& to, std::size_t row, std::size_t column, double value) {
  to.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
}

void add_element(Triplets& to, std::size_t first_node, const Eigen::Matrix4d& matrix) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      add_entry(to, 2 * first_node + i, 2 * first_node + j,
                matrix(static_cast<int>(i), static_cast<int>(j)));
}

void check_body(const model::ShaftBody& body) {
  using bearing::require_between;
  if (body.segments.empty())
    throw std::invalid_argument("[shaft] segment: at least one segment is needed");
  double length = 0.0;
  for (const model::Segment& s : body.segments) {
    require_between("length", s.length, 1e-3 * mm, 1e5 * mm, mm, "mm");
    require_between("diameter", s.diameter, 0.1 * mm, 1e4 * mm, mm, "mm");
    require_between("bore", s.bore, 0.0, 0.999 * s.diameter, mm, "mm");
    require_between("elastic_modulus", s.material.elastic_modulus, 1e8, 1e13, 1e9, "GPa");
    require_between("poissons_ratio", s.material.poissons_ratio, 0.0, 0.499, 1.0, "");
    require_between("density", s.material.density, 10.0, 1e5, 1.0, "kg/m3");
    length += s.length;
  }
  const double end = length + same_node;
  for (const model::Disk& d : body.disks) {
    require_between("disk position", d.position, 0.0, end, mm, "mm");
    require_between("disk mass", d.mass, 0.0, 1e5, 1.0, "kg");
    require_between("disk diametral_inertia", d.diametral_inertia, 0.0, 1e5, 1.0, "kg m2");
    require_between("disk polar_inertia", d.polar_inertia, 0.0, 1e5, 1.0, "kg m2");
  }
  for (const model::Support& s : body.supports) {
    require_between("support position", s.position, 0.0, end, mm, "mm");
    require_between("support radial_stiffness", s.radial_stiffness, 0.0, 1e12, 1e6, "N/um");
    require_between("support tilt_stiffness", s.tilt_stiffness, 0.0, 1e12, 1.0, "N m/rad");
  }
}

/// Where nodes must be, rising, none twice.
std::vector<double> needed_nodes(const model::ShaftBody& body, std::span<const double> places) {
  std::vector<double> at{0.0};
  double end = 0.0;
  for (const model::Segment& s : body.segments) at.push_back(end += s.length);
  for (const model::Disk& d : body.disks) at.push_back(d.position);
  for (const model::Support& s : body.supports) at.push_back(s.position);
  for (const double p : places) {
    bearing::require_between("position on the shaft", p, 0.0, end + same_node, mm, "mm");
    at.push_back(p);
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < same_node; }),
           at.end());
  return at;
}

BeamElement element_of(const model::Segment& s, double length) {
  return {.length = length,
          .outer_diameter = s.diameter,
          .bore = s.bore,
          .elastic_modulus = s.material.elastic_modulus,
          .poissons_ratio = s.material.poissons_ratio,
          .density = s.material.density};
}

}  // namespace

double shear_coefficient(double m, double nu) {
  const double square = m * m, sum = (1.0 + square) * (1.0 + square);
  return 6.0 * (1.0 + nu) * sum / ((7.0 + 6.0 * nu) * sum + (20.0 + 12.0 * nu) * square);
}

double BeamElement::area() const {
  return 0.25 * pi * (outer_diameter * outer_diameter - bore * bore);
}

double BeamElement::second_moment() const {
  return pi / 64.0 * (std::pow(outer_diameter, 4) - std::pow(bore, 4));
}

double BeamElement::shear_ratio() const {
  const double shear_modulus = elastic_modulus / (2.0 * (1.0 + poissons_ratio));
  const double kappa = shear_coefficient(bore / outer_diameter, poissons_ratio);
  return 12.0 * elastic_modulus * second_moment() /
         (kappa * shear_modulus * area() * length * length);
}

ElementMatrices element_matrices(const BeamElement& e) {
  const double l = e.length, phi = e.shear_ratio(), phi2 = phi * phi, whole = 1.0 + phi;
  ElementMatrices m;
  m.stiffness << 12.0, 6.0 * l, -12.0, 6.0 * l,                     //
      6.0 * l, (4.0 + phi) * l * l, -6.0 * l, (2.0 - phi) * l * l,  //
      -12.0, -6.0 * l, 12.0, -6.0 * l,                              //
      6.0 * l, (2.0 - phi) * l * l, -6.0 * l, (4.0 + phi) * l * l;
  m.stiffness *= e.elastic_modulus * e.second_moment() / (whole * l * l * l);
  const double t1 = 312.0 + 588.0 * phi + 280.0 * phi2, t2 = (44.0 + 77.0 * phi + 35.0 * phi2) * l,
               t3 = 108.0 + 252.0 * phi + 140.0 * phi2, t4 = -(26.0 + 63.0 * phi + 35.0 * phi2) * l,
               t5 = (8.0 + 14.0 * phi + 7.0 * phi2) * l * l,
               t6 = -(6.0 + 14.0 * phi + 7.0 * phi2) * l * l;
  m.mass << t1, t2, t3, t4,  //
      t2, t5, -t4, t6,       //
      t3, -t4, t1, -t2,      //
      t4, t6, -t2, t5;
  m.mass *= e.density * e.area() * l / (840.0 * whole * whole);
  const double r2 = (3.0 - 15.0 * phi) * l, r3 = (4.0 + 5.0 * phi + 10.0 * phi2) * l * l,
               r4 = (-1.0 - 5.0 * phi + 5.0 * phi2) * l * l;
  Eigen::Matrix4d rotary;
  rotary << 36.0, r2, -36.0, r2,  //
      r2, r3, -r2, r4,            //
      -36.0, -r2, 36.0, -r2,      //
      r2, r4, -r2, r3;
  rotary *= e.density * e.second_moment() / (30.0 * whole * whole * l);
  m.mass += rotary;
  m.gyroscopic = 2.0 * rotary;
  return m;
}

Spring isotropic_spring(double position, double radial, double tilt, double coupling) {
  const PlaneSpring plane{.radial = radial, .tilt = tilt, .coupling = coupling};
  return {.position = position, .y = plane, .z = plane};
}

Beam::Beam(const model::ShaftBody& body, std::span<const double> places, const BeamMesh& mesh) {
  check_body(body);
  const std::vector<double> needed = needed_nodes(body, places);
  const double longest = mesh.elements > 0 ? needed.back() / mesh.elements : mesh.element_length;
  bearing::require_between("element_length", longest, 1e-3 * mm, 1e5 * mm, mm, "mm");
  nodes_.push_back(0.0);
  std::size_t segment = 0;
  double segment_end = body.segments[0].length;
  for (std::size_t i = 1; i < needed.size(); ++i) {
    const double from = needed[i - 1], to = needed[i];
    while (segment + 1 < body.segments.size() && segment_end < to - 0.5 * same_node)
      segment_end += body.segments[++segment].length;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-6)));
    for (int k = 1; k <= pieces; ++k) {
      nodes_.push_back(k == pieces ? to : from + (to - from) * k / pieces);
      elements_.push_back(element_of(body.segments[segment], (to - from) / pieces));
    }
  }
  Triplets stiffness, mass, gyroscopic;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const ElementMatrices m = element_matrices(elements_[i]);
    add_element(stiffness, i, m.stiffness);
    add_element(mass, i, m.mass);
    add_element(gyroscopic, i, m.gyroscopic);
    mass_sum_ += elements_[i].density * elements_[i].area() * elements_[i].length;
  }
  for (const model::Disk& d : body.disks) {
    const std::size_t v = 2 * node_at(d.position);
    add_entry(mass, v, v, d.mass);
    add_entry(mass, v + 1, v + 1, d.diametral_inertia);
    add_entry(gyroscopic, v + 1, v + 1, d.polar_inertia);
    mass_sum_ += d.mass;
  }
  for (const model::Support& s : body.supports) {
    const std::size_t v = 2 * node_at(s.position);
    add_entry(stiffness, v, v, s.radial_stiffness);
    add_entry(stiffness, v + 1, v + 1, s.tilt_stiffness);
  }
  const auto size = static_cast<Eigen::Index>(2 * nodes_.size());
  for (auto [matrix, entries] : {std::pair{&stiffness_, &stiffness}, std::pair{&mass_, &mass},
                                 std::pair{&gyroscopic_, &gyroscopic}}) {
    matrix->resize(size, size);
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
}

Eigen::SparseMatrix<double> Beam::held_by(std::span<const double> places,
                                          std::span<const PlaneSpring> springs) const {
  if (places.size() != springs.size())
    throw std::invalid_argument(
        "springs: the number of springs must equal the number of positions");
  Eigen::SparseMatrix<double> held = stiffness_;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto v = static_cast<Eigen::Index>(2 * node_at(places[i]));
    held.coeffRef(v, v) += springs[i].radial;
    held.coeffRef(v + 1, v + 1) += springs[i].tilt;
    held.coeffRef(v, v + 1) += springs[i].coupling;
    held.coeffRef(v + 1, v) += springs[i].coupling;
  }
  return held;
}

std::size_t Beam::node_at(double position) const {
  const auto above = std::lower_bound(nodes_.begin(), nodes_.end(), position - 1.001 * same_node);
  if (above == nodes_.end() || *above > position + 1.001 * same_node)
    throw std::invalid_argument("the beam has no node at this position");
  return static_cast<std::size_t>(above - nodes_.begin());
}

Beam::Place Beam::place(double position) const {
  bearing::require_between("position on the shaft", position, -same_node, length() + same_node, mm,
                           "mm");
  const auto above = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, position);
  const auto element = static_cast<std::size_t>(above - nodes_.begin()) - 1;
  const BeamElement& e = elements_[element];
  const double l = e.length, phi = e.shear_ratio(), share = 1.0 / (1.0 + phi);
  const double x = std::clamp((position - nodes_[element]) / l, 0.0, 1.0);
  const double x2 = x * x, x3 = x2 * x, bent = 6.0 * (x2 - x) / l;
  Place p{.element = element, .displacement = {}, .rotation = {}};
  p.displacement << 1.0 - 3.0 * x2 + 2.0 * x3 + phi * (1.0 - x),
      l * (x - 2.0 * x2 + x3 + 0.5 * phi * (x - x2)), 3.0 * x2 - 2.0 * x3 + phi * x,
      l * (x3 - x2 - 0.5 * phi * (x - x2));
  p.rotation << bent, 1.0 - 4.0 * x + 3.0 * x2 + phi * (1.0 - x), -bent,
      3.0 * x2 - 2.0 * x + phi * x;
  p.displacement *= share;
  p.rotation *= share;
  return p;
}

Eigen::Vector2d Beam::at(double position, const Eigen::VectorXd& shape) const {
  const Place p = place(position);
  const auto own = shape.segment<4>(static_cast<Eigen::Index>(2 * p.element));
  return {p.displacement.dot(own), p.rotation.dot(own)};
}

void Beam::add_load(const BeamLoad& load, Eigen::VectorXd& forces) const {
  const Place p = place(load.position);
  forces.segment<4>(static_cast<Eigen::Index>(2 * p.element)) +=
      load.force * p.displacement + load.moment * p.rotation;
}

Deflection deflect(const Beam& beam, std::span<const double> places,
                   std::span<const PlaneSpring> springs, std::span<const BeamLoad> loads) {
  const Eigen::SparseMatrix<double> stiffness = beam.held_by(places, springs);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(stiffness.rows());
  for (const BeamLoad& load : loads) beam.add_load(load, forces);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
  Deflection d;
  // A free shaft has two pivots of rounding alone.
  if (solver.info() != Eigen::Success) return d;
  const Eigen::VectorXd pivots = solver.vectorD();
  if (!(pivots.minCoeff() > 1e-13 * pivots.maxCoeff())) return d;
  d.shape = solver.solve(forces);
  // One step of refinement gives back the digits that a stiff mesh costs.
  d.shape += solver.solve(forces - stiffness * d.shape);
  d.found = d.shape.allFinite();
  return d;
}

CondensedBeam::CondensedBeam(const Beam& beam, std::vector<std::size_t> nodes)
    : nodes_(std::move(nodes)) {
  const Eigen::SparseMatrix<double>& k = beam.stiffness();
  std::vector<int> rank(static_cast<std::size_t>(k.rows()), -1);  // among the few, else -1
  int few = 0;
  for (const std::size_t node : nodes_)
    for (const std::size_t dof : {2 * node, 2 * node + 1}) rank[dof] = few++;
  std::vector<int> inner(rank.size(), -1);
  int others = 0;
  for (std::size_t i = 0; i < rank.size(); ++i)
    if (rank[i] < 0) inner[i] = others++;
  Triplets within;
  Eigen::MatrixXd across = Eigen::MatrixXd::Zero(others, few);
  stiffness_ = Eigen::MatrixXd::Zero(few, few);
  for (int column = 0; column < k.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(k, column); it; ++it) {
      const auto r = static_cast<std::size_t>(it.row()), c = static_cast<std::size_t>(it.col());
      if (rank[r] >= 0 && rank[c] >= 0) stiffness_(rank[r], rank[c]) += it.value();
      if (rank[r] < 0 && rank[c] >= 0) across(inner[r], rank[c]) = it.value();
      if (rank[r] < 0 && rank[c] < 0) within.emplace_back(inner[r], inner[c], it.value());
    }
  }
  follow_ = Eigen::MatrixXd::Zero(k.rows(), few);
  Eigen::MatrixXd moved(others, few);
  if (others > 0) {
    Eigen::SparseMatrix<double> held(others, others);
    held.setFromTriplets(within.begin(), within.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(held);
    moved = -solver.solve(across);
    moved += solver.solve(-across - held * moved);
    stiffness_ += across.transpose() * moved;
  }
  for (std::size_t i = 0; i < rank.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (rank[i] >= 0)
      follow_(row, rank[i]) = 1.0;
    else
      follow_.row(row) = moved.row(inner[i]);
  }
}

Eigen::VectorXd CondensedBeam::expand(const Eigen::VectorXd& few) const { return follow_ * few; }

}  // namespace raceway::spindle
