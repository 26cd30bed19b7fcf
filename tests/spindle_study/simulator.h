#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/spindle_study/mesh.h"

namespace spindle_study {

inline constexpr double fine_cells = 0.003;  ///< [m]: about 2000 cells

struct Reading {
  double time = 0.0;
  double displacement = 0.0;  ///< nose against flange, towards the tool [m]
  double elongation = 0.0;    ///< between the sets [m]
  SetState set;
  std::vector<double> inner_rings, outer_rings;  ///< [K]
  std::vector<double> power;                     ///< of each bearing [W]
  std::vector<double> thermometers;              ///< [K]
};

/// A spindle whose friction and temperatures do not settle within a time step.
struct Runaway : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Heat by way of its leaving [W].
struct Balance {
  std::map<std::string, double> out;
  double in = 0.0;
};

/// Temperatures of a spindle by finite volumes, TR-BDF2 in time, with the set in balance at every
/// stage.
class Simulator {
 public:
  explicit Simulator(const Spindle& spindle, const Hidden& hidden = {}, double cell = fine_cells);
  /// As mounted, at one temperature [K].
  void start(double temperature);
  /// To the time of the inputs, which hold from the present on; steps of at most `longest` [s],
  /// shorter ones after a change.
  void advance(const Inputs& inputs, double longest = 60.0);
  /// At rest with constant inputs.
  void settle(const Inputs& inputs);
  [[nodiscard]] Reading reading() const;
  [[nodiscard]] Balance heat(const Inputs& inputs);
  [[nodiscard]] std::size_t cells() const { return mesh_.cells.size(); }
  /// Largest difference of heat in, out and stored of a step against what went in.
  [[nodiscard]] double balance_error() const { return balance_error_; }

 private:
  using Vector = Eigen::VectorXd;
  /// Everything that is held over one sweep of a step.
  struct Frozen {
    std::vector<double> links, faces;  ///< conductances [W/K]
    std::vector<double> raceways;      ///< of one per raceway [W/K]
    double film = 0.0;
  };
  [[nodiscard]] double ring(const Weights& w, const Vector& t) const;
  void freeze(const Vector& t, const Inputs& in);
  void seats(const Vector& t, const Inputs& in);
  void add_raceways();
  void sources(const Inputs& in);
  void add(std::size_t a, std::size_t b, double conductance);
  void fill();
  [[nodiscard]] double machine(const Inputs& in) const;
  /// Friction heat of all bearings at temperatures given by functionals.
  std::vector<double> friction(const std::vector<RingState>& rings, double elongation,
                               const Inputs& in);
  [[nodiscard]] std::vector<RingState> rings(const Vector& t) const;
  /// T = base + Σ q_b response_b with q the friction heat at T.
  Vector with_friction(const Vector& base, const std::vector<Vector>& response, const Inputs& in);
  void step(double h, const Inputs& in);

  Spindle spindle_;
  Hidden hidden_;
  Mesh mesh_;
  BearingSet set_;
  double mounted_ = 293.15, time_ = 0.0, step_ = 10.0, balance_error_ = 0.0, now_ = 0.0;
  std::size_t size_ = 0;  ///< cells, and the water
  bool has_water_ = false;
  Vector capacity_, temperature_, rate_, load_, diagonal_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> conduction_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool analysed_ = false;
  std::vector<Vector> heating_;  ///< where a watt of each bearing goes
  std::vector<double> face_conductance_;
  std::vector<double> power_;
  SetState state_, cold_;  ///< now, and cold at `cold_speed_`
  double cold_speed_ = nan;
  Inputs last_;
  std::vector<double> contact_;  ///< conductance of the balls of each bearing [W/K]
};

}  // namespace spindle_study
