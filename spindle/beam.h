#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <span>
#include <vector>

#include "model/spindle.h"

namespace raceway::spindle {

/// Returns the shear coefficient κ of a circular section with a bore [1]. m is the ratio of inner
/// to outer diameter, and ν is Poisson's ratio:
///
///   κ = 6 (1 + ν)(1 + m²)² / ((7 + 6 ν)(1 + m²)² + (20 + 12 ν) m²)
///
/// Source: Cowper (J Appl Mech 33, 1966, p. 335).
/// Domain: 0 <= m < 1.
[[nodiscard]] double shear_coefficient(double diameter_ratio, double poissons_ratio);

/// Section, material and length of one beam element.
struct BeamElement {
  double length = unset;                      ///< [m]
  double outer_diameter = unset, bore = 0.0;  ///< [m]
  double elastic_modulus = unset;             ///< [Pa]
  double poissons_ratio = unset;              ///< [1]
  double density = unset;                     ///< [kg/m³]

  [[nodiscard]] double area() const;           ///< [m²]
  [[nodiscard]] double second_moment() const;  ///< second moment of area about a diameter [m⁴]
  /// Returns Φ = 12 E I / (κ G A L²), the ratio of shear to bending flexibility of the element [1].
  /// E and G are the elastic and the shear modulus, I the second moment of area, κ the shear
  /// coefficient, A the area and L the length.
  [[nodiscard]] double shear_ratio() const;
};

/// Matrices of one beam element in one plane. The unknowns are (v, θ) at both ends: displacement v
/// [m] and rotation θ of the section [rad]. Without shear deformation, θ is the slope dv/ds, where
/// s is the position along the shaft. The mass matrix includes rotary inertia. `gyroscopic` is 2 N,
/// where N is the matrix of rotary inertia, because the polar moment of a section is twice the
/// moment about a diameter. The shape functions are exact for loads at the nodes.
struct ElementMatrices {
  Eigen::Matrix4d stiffness, mass, gyroscopic;
};
[[nodiscard]] ElementMatrices element_matrices(const BeamElement& element);

/// Stiffness of a spring in one plane, for the displacement v and the rotation θ at its node.
struct PlaneSpring {
  double radial = 0.0;    ///< [N/m]
  double tilt = 0.0;      ///< [N m/rad]
  double coupling = 0.0;  ///< force per rotation and moment per displacement [N/rad]
  [[nodiscard]] bool operator==(const PlaneSpring&) const = default;
};

/// Spring between shaft and housing with principal planes parallel to y and z.
struct Spring {
  double position = unset;  ///< distance behind the nose face [m]
  PlaneSpring y, z;
  [[nodiscard]] bool isotropic() const { return y == z; }
};

/// Returns a spring with equal stiffness in all radial directions.
[[nodiscard]] Spring isotropic_spring(double position, double radial, double tilt = 0.0,
                                      double coupling = 0.0);

/// Force and moment on the shaft at one position, in one plane.
struct BeamLoad {
  double position = unset;  ///< distance behind the nose face [m]
  double force = 0.0;       ///< [N]
  double moment = 0.0;      ///< positive in the direction of the rotation θ [N m]
};

struct BeamMesh {
  double element_length = 5 * mm;  ///< largest length of an element [m]
  /// Minimum number of elements of the beam. If this number is above 0, `element_length` has no
  /// effect.
  int elements = 0;
};

/// Shaft made of Timoshenko beam elements. The coordinate s increases from the nose to the rear.
/// The matrices are equal in both planes. The beam contains the supports in `body`, but no
/// bearings. The bearing springs are arguments of each calculation.
class Beam {
 public:
  /// Creates nodes at changes of section, disks, supports and the positions `places` [m]. Throws
  /// std::invalid_argument if an input is out of range. The message gives the name of the input,
  /// the value with unit, and the allowed range.
  Beam(const model::ShaftBody& body, std::span<const double> places, const BeamMesh& mesh = {});

  [[nodiscard]] std::span<const double> nodes() const { return nodes_; }  ///< [m]
  [[nodiscard]] std::size_t elements() const { return elements_.size(); }
  [[nodiscard]] double length() const { return nodes_.back(); }  ///< [m]
  [[nodiscard]] double weight() const { return mass_sum_; }      ///< mass including disks [kg]

  /// Matrices in one plane for the vector of displacement v and rotation θ of all nodes, (v_1, θ_1,
  /// v_2, θ_2, ...). The stiffness matrix includes the supports of the shaft.
  [[nodiscard]] const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  [[nodiscard]] const Eigen::SparseMatrix<double>& mass() const { return mass_; }
  [[nodiscard]] const Eigen::SparseMatrix<double>& gyroscopic() const { return gyroscopic_; }
  /// Returns the stiffness matrix of the beam with `springs` at the positions `places` [m], which
  /// must be nodes.
  [[nodiscard]] Eigen::SparseMatrix<double> held_by(std::span<const double> places,
                                                    std::span<const PlaneSpring> springs) const;

  /// Returns the index of the node within 1 nm of a position [m]. Throws std::invalid_argument if
  /// there is no such node.
  [[nodiscard]] std::size_t node_at(double position) const;
  /// Returns displacement v and rotation θ at any position [m]. `shape` contains (v, θ) of all
  /// nodes.
  [[nodiscard]] Eigen::Vector2d at(double position, const Eigen::VectorXd& shape) const;
  /// Adds the equivalent nodal forces of a load to `forces`.
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
  bool found = false;     ///< false if springs and supports do not hold the shaft
  Eigen::VectorXd shape;  ///< displacement v and rotation θ of all nodes [m, rad]
};

/// Solves K q = f for the shaft on springs at the positions `places` [m], which must be nodes. K is
/// the stiffness matrix with the springs, q contains (v, θ) of all nodes, and f the nodal loads.
/// The result is exact at the nodes.
[[nodiscard]] Deflection deflect(const Beam& beam, std::span<const double> places,
                                 std::span<const PlaneSpring> springs,
                                 std::span<const BeamLoad> loads);

/// Beam reduced to selected nodes in one plane. The stiffness matrix refers to displacement v and
/// rotation θ of these nodes. The reduction is exact for static loads at these nodes.
class CondensedBeam {
 public:
  CondensedBeam(const Beam& beam, std::vector<std::size_t> nodes);
  [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }
  /// Returns (v, θ) of all nodes of the original beam. `few` contains (v, θ) of the nodes of the
  /// reduced beam.
  [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& few) const;

 private:
  std::vector<std::size_t> nodes_;
  Eigen::MatrixXd stiffness_;
  Eigen::MatrixXd follow_;
};

}  // namespace raceway::spindle
