#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <span>
#include <vector>

#include "model/spindle.h"

namespace raceway::spindle {

/// Shear coefficient κ of a round section with bore, m = inner/outer diameter [1]:
///
///   κ = 6 (1 + ν)(1 + m²)² / ((7 + 6 ν)(1 + m²)² + (20 + 12 ν) m²)
///
/// Source: [Cowper1966]. Domain: 0 <= m < 1.
[[nodiscard]] double shear_coefficient(double diameter_ratio, double poissons_ratio);

/// Section, material and length of one element.
struct BeamElement {
  double length = unset;                      ///< [m]
  double outer_diameter = unset, bore = 0.0;  ///< [m]
  double elastic_modulus = unset;             ///< [Pa]
  double poissons_ratio = unset;              ///< [1]
  double density = unset;                     ///< [kg/m³]

  [[nodiscard]] double area() const;           ///< [m²]
  [[nodiscard]] double second_moment() const;  ///< about a diameter [m⁴]
  /// Φ = 12 E I / (κ G A L²), how much shear softens the element [1].
  [[nodiscard]] double shear_ratio() const;
};

/// Matrices of one element in one plane, for (v1, θ1, v2, θ2): displacement [m] and rotation of the
/// section [rad], θ = dv/ds without shear. Mass with rotary inertia; `gyroscopic` is 2 N with N
/// the rotary inertia, the polar moment of a section being twice that about its diameter. Closed
/// forms of the integrals over the shape functions that are exact for loads at the nodes.
struct ElementMatrices {
  Eigen::Matrix4d stiffness, mass, gyroscopic;
};
[[nodiscard]] ElementMatrices element_matrices(const BeamElement& element);

/// Stiffness of a spring in one plane on (v, θ) of its place.
struct PlaneSpring {
  double radial = 0.0;    ///< [N/m]
  double tilt = 0.0;      ///< [N m/rad]
  double coupling = 0.0;  ///< force per rotation, and moment per displacement [N/rad]
  [[nodiscard]] bool operator==(const PlaneSpring&) const = default;
};

/// A spring from shaft to housing, its principal planes parallel to y and z.
struct Spring {
  double position = unset;  ///< behind the nose face [m]
  PlaneSpring y, z;
  [[nodiscard]] bool isotropic() const { return y == z; }
};

/// Spring with the same stiffness in all radial directions.
[[nodiscard]] Spring isotropic_spring(double position, double radial, double tilt = 0.0,
                                      double coupling = 0.0);

/// A load in one plane.
struct BeamLoad {
  double position = unset;  ///< behind the nose face [m]
  double force = 0.0;       ///< [N]
  double moment = 0.0;      ///< positive as θ [N m]
};

struct BeamMesh {
  double element_length = 5 * mm;  ///< at most [m]
  int elements = 0;                ///< at least, over the whole shaft; overrides the length
};

/// A shaft as Timoshenko elements, s from the nose to the rear. What is isotropic of it has
/// one matrix for both planes, and in the complex v + i w half the size. Supports of the body are
/// springs of it; bearings are not: springs() of bearings come with each question.
class Beam {
 public:
  /// Nodes at changes of section, disks, supports and `places` [m]. Throws std::invalid_argument:
  /// name, value with unit, allowed range.
  Beam(const model::ShaftBody& body, std::span<const double> places, const BeamMesh& mesh = {});

  [[nodiscard]] std::span<const double> nodes() const { return nodes_; }  ///< [m]
  [[nodiscard]] std::size_t elements() const { return elements_.size(); }
  [[nodiscard]] double length() const { return nodes_.back(); }  ///< [m]
  [[nodiscard]] double weight() const { return mass_sum_; }      ///< with disks [kg]

  /// Matrices in one plane, (v, θ) node behind node. Stiffness with the body's supports.
  [[nodiscard]] const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  [[nodiscard]] const Eigen::SparseMatrix<double>& mass() const { return mass_; }
  [[nodiscard]] const Eigen::SparseMatrix<double>& gyroscopic() const { return gyroscopic_; }
  /// Stiffness with springs at nodes.
  [[nodiscard]] Eigen::SparseMatrix<double> held_by(std::span<const double> places,
                                                    std::span<const PlaneSpring> springs) const;

  /// The node at a place, within 1 nm. Throws std::invalid_argument where there is none.
  [[nodiscard]] std::size_t node_at(double position) const;
  /// v and θ at a place between the nodes, from the values of all nodes.
  [[nodiscard]] Eigen::Vector2d at(double position, const Eigen::VectorXd& shape) const;
  /// Adds equivalent nodal forces of a load.
  void add_load(const BeamLoad& load, Eigen::VectorXd& forces) const;

 private:
  struct Place {
    std::size_t element;
    Eigen::Vector4d displacement, rotation;  ///< shape functions
  };
  [[nodiscard]] Place place(double position) const;

  std::vector<double> nodes_;
  std::vector<BeamElement> elements_;
  Eigen::SparseMatrix<double> stiffness_, mass_, gyroscopic_;
  double mass_sum_ = 0.0;
};

/// Bending of the shaft in one plane under static loads.
struct Deflection {
  bool found = false;     ///< false where nothing holds the shaft
  Eigen::VectorXd shape;  ///< (v, θ) of all nodes [m, rad]
};

/// Solves K q = f with springs at `places`, each of them a node. Exact at the nodes.
[[nodiscard]] Deflection deflect(const Beam& beam, std::span<const double> places,
                                 std::span<const PlaneSpring> springs,
                                 std::span<const BeamLoad> loads);

/// The beam seen from a few of its nodes alone, in one plane: stiffness on their (v, θ), all
/// other nodes eliminated (exact in statics).
class CondensedBeam {
 public:
  CondensedBeam(const Beam& beam, std::vector<std::size_t> nodes);
  [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }
  /// All nodes from the few.
  [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& few) const;

 private:
  std::vector<std::size_t> nodes_;
  Eigen::MatrixXd stiffness_;
  Eigen::MatrixXd follow_;  ///< displacement of all nodes per displacement of the few
};

}  // namespace raceway::spindle
