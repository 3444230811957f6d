// The matrices of a superstructure, in SI units.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "structures/superstructure/superstructure.hpp"

namespace moat {

/// Rows of motions, m or rad, for rigid motions by 1 m along x, y, z and by 1 rad about these axes.
using RigidMotions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// A floor, or the base.
struct SystemFloor {
  double height = 0.0, mass = 0.0, rotary_inertia = 0.0;  ///< m, kg, kg m^2; no inertia on a line
  PlanVector centre_of_mass{};                            ///< m
  PlanOutline outline{};                                  ///< empty on a line
  double half_width = 0.0;                                ///< m, of drawings on a line
  std::string name{}, tower{};                            ///< "floor 3"; none, or "west"

  /// sqrt(J/m), m.
  [[nodiscard]] double gyration() const;
};

/// A superstructure held at its base. Its rows are floor by floor from the lowest up: x alone, or x, y and w = r theta
/// with the radius of gyration r of the floor, so that all masses are in kg and all stiffnesses in N/m. Motions of a
/// condensed model that are kept follow, rotations in m at 1 m from their axis.
struct StructureSystem {
  bool in_plan = false;             ///< three rows per floor
  std::vector<SystemFloor> floors;  ///< from the lowest up
  std::vector<SystemFloor> bases;   ///< one, or the slabs that move apart; none: the ground
  std::vector<std::string> names;   ///< of rows: "floor 3 rotation"
  std::vector<int> floor_of_row;    ///< from 0; -1: a motion of the base that is kept
  RigidMotions motions;             ///< of all rows, about axes through the origin at height 0
  Eigen::MatrixXd mass;             ///< M, kg, with that of couplings
  Eigen::MatrixXd stiffness;        ///< K, N/m; empty where modes are given
  Eigen::MatrixXd damping;          ///< C, N s/m; of the modes where there are shapes
  Eigen::MatrixXd rigid;            ///< rigid motion of the floors with the first base, or about the lowest floor
  Eigen::MatrixXd carried;          ///< R: motion of the floors with all bases where nothing deforms
  Eigen::MatrixXd between_bases;    ///< N/m, of all slabs but the first, which is held; empty where they do not couple
  Eigen::MatrixXd bases_rigid;      ///< rigid motion of these with the first slab
  std::vector<std::string> notes;   ///< about the input
  /// Shapes, a column for each mode, scaled so that their largest entry is 1; empty where matrices of the floors are
  /// given. Motions that are kept are those of all modes.
  Eigen::MatrixXd shapes;
  Eigen::VectorXd modal_stiffness;       ///< K_q, N/m
  std::vector<ParticipatingMass> modes;  ///< of the superstructure held at its base

  /// Rows of one floor.
  [[nodiscard]] int per_floor() const { return in_plan ? 3 : 1; }
  /// Whether it stands on a base.
  [[nodiscard]] bool is_isolated() const { return !bases.empty(); }
  /// The point about which torques and rotations count, m.
  [[nodiscard]] PlanVector origin() const { return (is_isolated() ? bases : floors).front().centre_of_mass; }
  /// Rows of floors or bases in m and rad, about axes through origin() at height 0.
  [[nodiscard]] RigidMotions rigid_motions(const std::vector<SystemFloor>& of) const;
  /// Returns the columns that a base makes: along x, along y, and about z; on a line x alone.
  [[nodiscard]] Eigen::MatrixXd of_base(const RigidMotions& of_rows) const;
  /// Returns the columns for these rows in one step.
  [[nodiscard]] Eigen::MatrixXd rigid_motion(const std::vector<SystemFloor>& of) const {
    return of_base(rigid_motions(of));
  }
  /// Displacements in m from those in m and rad: 1, and the radius of gyration of rotations.
  [[nodiscard]] Eigen::VectorXd into_metres(const std::vector<SystemFloor>& of) const;
};

/// `on`: the bases that are there already. Throws InputError as add(model, Superstructure) does.
StructureSystem system_of(const Superstructure& structure, std::vector<SystemFloor> on);

}  // namespace moat
