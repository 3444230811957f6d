#include "structures/superstructure/structure_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solvers/dense.hpp"
#include "structures/superstructure/condensed_rows.hpp"
#include "structures/superstructure/floor_matrix.hpp"
#include "structures/superstructure/matrix_checks.hpp"
#include "structures/superstructure/structure_floors.hpp"
#include "structures/superstructure/structure_modes.hpp"

namespace moat {
namespace {

// Builds the system of one superstructure.
class SystemBuilder {
 public:
  SystemBuilder(const Superstructure& structure, std::vector<SystemFloor> on)
      : structure_{structure}, check_{"Superstructure", structure.name} {
    system_.bases = std::move(on);
  }

  StructureSystem build() {
    const int given = (structure_.stiffness ? 1 : 0) + (structure_.modes ? 1 : 0) + (structure_.condensed ? 1 : 0);
    check_.that(given == 1, "stiffness, modes and condensed: " + std::to_string(given) + " of them are given.",
                "Give one of them.");
    const std::vector<Freedom> rows = given_rows();
    add_floors(structure_, check_, system_);
    check_base_level(structure_, check_, system_);
    const int floors = static_cast<int>(system_.floors.size());
    for (int floor = 1; floor <= floors; ++floor)
      for (int k = 0; k < system_.per_floor(); ++k)
        system_.names.push_back(Freedom{floor, static_cast<FloorDirection>(k)}.name());
    const std::vector<int> positions = positions_of(check_, rows, floors, system_.in_plan);
    set_rigid_motions();
    system_.carried = system_.rigid;
    check_.that(system_.bases.size() < 2 || structure_.stiffness,
                "it stands on several slabs, and stiffness is not given.",
                "Slabs that move apart strain it: give the whole matrix, with rows of all slabs.");
    add_mass();
    if (structure_.modes)
      add_modes(*structure_.modes, structure_.damping, check_, into_metres_, positions, system_);
    else
      add_stiffness();
    return std::move(system_);
  }

 private:
  // Finds which motion each row of stiffness or shapes is.
  std::vector<Freedom> given_rows() {
    if (const auto& condensed = structure_.condensed) {
      system_.in_plan = condensed->in_plan;
      system_.notes = condensed->notes;
      return per_floor(system_.in_plan ? Freedoms::x_y_rotation : Freedoms::x)
          .list(check_, "condensed", system_.per_floor() * static_cast<int>(levels_of_floors(*condensed).size()));
    }
    const std::optional<MatrixInUnits>& stiffness = structure_.stiffness;
    const std::optional<StructureModes>& modes = structure_.modes;
    std::vector<Freedom> rows =
        stiffness ? freedoms_of(structure_, check_, "stiffness", stiffness->names, stiffness->values.rows())
                  : freedoms_of(structure_, check_, "shapes", modes->names, modes->shapes.rows());
    const auto has = [&](FloorDirection direction) {
      return std::ranges::count(rows, direction, &Freedom::direction) > 0;
    };
    system_.in_plan = has(FloorDirection::rotation);
    check_.that(system_.in_plan || !has(FloorDirection::y), "freedoms have y without rotation.",
                "Give x alone for a building on a line, or x, y and rotation of every floor.");
    return rows;
  }

  // Motions of the floors in m and rad, then those that are kept.
  void set_rigid_motions() {
    system_.motions = system_.rigid_motions(system_.floors);
    for (Eigen::Index row = 0; row < system_.motions.rows(); ++row)
      system_.floor_of_row.push_back(static_cast<int>(row) / system_.per_floor());
    const Eigen::VectorXd of_floors = system_.into_metres(system_.floors);
    if (structure_.condensed) add_kept_motions(*structure_.condensed, system_);
    into_metres_.setOnes(system_.motions.rows());
    into_metres_.head(of_floors.size()) = of_floors;
    rigid_ = system_.of_base(system_.motions);
    system_.motions = into_metres_.asDiagonal() * system_.motions;
    system_.rigid = per_base(into_metres_.asDiagonal() * rigid_);
  }
  // For motions of the base in m.
  [[nodiscard]] Eigen::MatrixXd per_base(Eigen::MatrixXd motion) const {
    if (system_.in_plan && system_.is_isolated()) motion.col(2) /= system_.bases.front().gyration();
    return motion;
  }
  // The rows of floors and of motions that are kept, for displacements in m.
  Eigen::MatrixXd in_metres(const NamedRows& rows, const Eigen::MatrixXd& given, Diagonal diagonal) {
    const Eigen::VectorXd scale = into_metres_.cwiseInverse();
    const Eigen::MatrixXd of_floors = given.topLeftCorner(scale.size(), scale.size());
    const Eigen::MatrixXd mean = symmetric(rows, of_floors, diagonal, system_.notes);
    const Eigen::MatrixXd result = scale.asDiagonal() * mean * scale.asDiagonal();
    return 0.5 * (result + result.transpose());
  }
  [[nodiscard]] NamedRows named(std::string_view field) const { return {check_, field, system_.names}; }
  Eigen::MatrixXd read(std::string_view field, const MatrixInUnits& matrix) {
    return floor_matrix(structure_, check_, field, matrix, system_);
  }

  void add_mass() {
    Eigen::VectorXd own{system_.per_floor() * std::ssize(system_.floors)};
    for (Eigen::Index i = 0; i < own.size(); ++i) {
      const SystemFloor& floor = system_.floors[static_cast<std::size_t>(i / system_.per_floor())];
      own[i] = i % system_.per_floor() == 2 ? floor.rotary_inertia : floor.mass;
    }
    Eigen::MatrixXd mass = own.asDiagonal();
    if (structure_.condensed)
      mass = structure_.condensed->mass.bottomRightCorner(rigid_.rows(), rigid_.rows());
    else if (structure_.mass)
      mass = read("mass", *structure_.mass);
    constexpr double tolerated = 0.01;
    for (Eigen::Index i = 0; i < own.size(); ++i)
      check_.that(std::abs(mass(i, i) - own[i]) <= tolerated * own[i],
                  "mass of " + system_.names[static_cast<std::size_t>(i)] + " is " + to_text(mass(i, i)) +
                      " in the matrix, and " + to_text(own[i]) + " in floors, kg or kg m^2.",
                  "Give the same; the matrix counts.");
    system_.mass = in_metres(named("mass"), mass, Diagonal::positive);
    check_.that(is_definite(system_.mass), "mass is not positive definite.",
                "Every floor needs mass and rotary inertia.");
  }

  void add_stiffness() {
    const auto& condensed = structure_.condensed;
    const Eigen::MatrixXd whole =
        condensed ? condensed_stiffness(*condensed, check_, rigid_, system_) : read("stiffness", *structure_.stiffness);
    if (system_.bases.size() > 1) stand_on_slabs(whole);
    system_.stiffness = in_metres(named("stiffness"), whole, Diagonal::positive);
    check_definite(named("stiffness"), system_.stiffness, system_.notes);
    const EigenPairs modes = eigen_pairs(system_.stiffness, system_.mass);
    system_.modes = participating_masses(modes.values, projected(modes.vectors, system_.mass, system_.rigid),
                                         projected(system_.rigid, system_.mass, system_.rigid));
    add_damping(modes.values.cwiseSqrt(), modes.vectors);
    if (kept() > 0) move_in_all_modes(modes.vectors, kept(), system_);
  }
  [[nodiscard]] Eigen::Index kept() const { return structure_.condensed ? std::ssize(structure_.condensed->kept) : 0; }

  // R = -K_ss^-1 K_sb, and the stiffness that is left between the slabs: it acts on the motion of the others relative
  // to that of the first.
  void stand_on_slabs(const Eigen::MatrixXd& whole) {
    const Eigen::Index n = system_.rigid.rows(), m = whole.rows() - n, first = system_.per_floor();
    const Eigen::VectorXd per_slab = system_.into_metres(system_.bases).cwiseInverse();
    const Eigen::MatrixXd carried = -solve_definite(whole.topLeftCorner(n, n), whole.topRightCorner(n, m));
    Eigen::MatrixXd between = whole.bottomRightCorner(m, m) + product(whole.bottomLeftCorner(m, n), carried);
    system_.carried = into_metres_.asDiagonal() * carried * per_slab.asDiagonal();
    const double uncoupled = 1e-9 * whole.bottomRightCorner(m, m).diagonal().maxCoeff();
    if (between.cwiseAbs().maxCoeff() <= uncoupled) return;
    between = (per_slab.asDiagonal() * between * per_slab.asDiagonal()).bottomRightCorner(m - first, m - first).eval();
    system_.between_bases = 0.5 * (between + between.transpose());
    system_.bases_rigid =
        per_base(system_.into_metres(system_.bases).asDiagonal() * system_.rigid_motion(system_.bases))
            .bottomRows(m - first);
  }

  // w: angular frequencies, 1/s; Q: shapes with Q' M Q = I.
  void add_damping(const Eigen::VectorXd& frequencies, const Eigen::MatrixXd& shapes) {
    const auto size = system_.stiffness.rows();
    system_.damping = Eigen::MatrixXd::Zero(size, size);
    if (const auto* modal = std::get_if<ModalDamping>(&structure_.damping)) {
      const Eigen::VectorXd ratios = ratios_of(check_, *modal, size, system_.notes);
      const Eigen::MatrixXd heavy = product(system_.mass, shapes);
      system_.damping = product(heavy * (2.0 * ratios.cwiseProduct(frequencies)).asDiagonal(), heavy.transpose());
    } else if (const auto* rayleigh = std::get_if<RayleighDamping>(&structure_.damping)) {
      const RayleighFactors factors = rayleigh_factors_of(*rayleigh, system_.modes);
      system_.damping = factors.mass_factor * system_.mass + factors.stiffness_factor * system_.stiffness;
    } else if (const auto* matrix = std::get_if<MatrixInUnits>(&structure_.damping)) {
      check_.that(kept() == 0, "damping is a matrix of the floors, and other motions are kept.",
                  "Give ModalDamping or RayleighDamping.");
      system_.damping = in_metres(named("damping"), read("damping", *matrix), Diagonal::not_negative);
      const Eigen::VectorXd values = eigen_pairs(system_.damping).values;
      constexpr double round_off = 1e-9;
      check_.that(values[0] >= -round_off * values[size - 1],
                  "damping has the negative eigenvalue " + to_text(values[0]) + " N s/m.",
                  "A damping takes energy from every motion.");
    }
    system_.damping = 0.5 * (system_.damping + system_.damping.transpose()).eval();
  }

  const Superstructure& structure_;
  Check check_;
  StructureSystem system_;
  Eigen::MatrixXd rigid_;        // all rows in m and rad, for motions of the base by 1 m and 1 rad
  Eigen::VectorXd into_metres_;  // 1, or the radius of gyration of a rotation
};

}  // namespace

double SystemFloor::gyration() const { return std::sqrt(rotary_inertia / mass); }

RigidMotions StructureSystem::rigid_motions(const std::vector<SystemFloor>& of) const {
  RigidMotions result{per_floor() * std::ssize(of), 6};
  for (Eigen::Index row = 0; const SystemFloor& floor : of) {
    const double z = floor.height;
    const PlanVector arm = floor.centre_of_mass - origin();
    Eigen::Matrix<double, 3, 6> motion;
    motion << 1.0, 0.0, 0.0, 0.0, z, -arm.y, 0.0, 1.0, 0.0, -z, 0.0, arm.x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
    result.middleRows(row, per_floor()) = motion.topRows(per_floor());
    row += per_floor();
  }
  return result;
}

Eigen::MatrixXd StructureSystem::of_base(const RigidMotions& of_rows) const {
  if (!in_plan) return of_rows.leftCols<1>();
  return of_rows(Eigen::all, std::array{0, 1, 5});
}

Eigen::VectorXd StructureSystem::into_metres(const std::vector<SystemFloor>& of) const {
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(per_floor() * std::ssize(of));
  for (std::size_t i = 0; in_plan && i < of.size(); ++i)
    factors[3 * static_cast<Eigen::Index>(i) + 2] = of[i].gyration();
  return factors;
}

StructureSystem system_of(const Superstructure& structure, std::vector<SystemFloor> on) {
  return SystemBuilder{structure, std::move(on)}.build();
}

}  // namespace moat
