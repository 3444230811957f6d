// A building given by its matrices or modes, as a finite-element program has them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/model.hpp"
#include "structures/files/matrix_file.hpp"
#include "structures/files/mode_files.hpp"
#include "structures/files/storey_table.hpp"
#include "structures/frame/finite_elements.hpp"
#include "structures/isolation.hpp"
#include "structures/plan_parts.hpp"
#include "structures/rayleigh_damping.hpp"
#include "structures/superstructure/freedoms.hpp"

namespace moat {

/// A floor of a superstructure.
struct SuperstructureFloor {
  Required<Length> height;         ///< Above the base or the ground, rising from floor to floor.
  Required<Mass> mass;             ///< > 0 kg.
  RotaryInertia rotary_inertia{};  ///< > 0 kg m^2 in plan, about the centre of mass; left out: of the uniform outline.
  PlanPosition centre_of_mass{};   ///< In coordinates of the whole model; its motions are those of the matrices.
  PlanOutline outline{};           ///< In plan: the edge, whose corners report and touch.
  Length half_width = 5.0 * units::m;  ///< On a line, for drawings.
};

/// The base of a superstructure, on bearings. It is rigid and carries the floors' motion with it.
struct SuperstructureBase {
  Required<Mass> mass;                 ///< > 0 kg.
  RotaryInertia rotary_inertia{};      ///< As that of a floor.
  PlanPosition centre_of_mass{};       ///< As that of a floor.
  PlanOutline outline{};               ///< As that of a floor.
  Length half_width = 5.0 * units::m;  ///< On a line, for drawings.
  Mass carried{};  ///< >= 0 kg, of buildings that are added `on` it later: with it bearings know the weight on them.
};

/// Damping ratios of the modes of the superstructure held at its base.
///
///     C = M Q diag(2 zeta w) Q' M      with Q' M Q = I
struct ModalDamping {
  std::vector<double> ratios;  ///< >= 0 and < 1 each: one for all modes, or one for each; the last holds for the rest.

  ModalDamping(double ratio) : ratios{ratio} {}                        ///< One ratio for all modes.
  ModalDamping(std::vector<double> list) : ratios{std::move(list)} {}  ///< From the slowest mode on.
  ModalDamping(std::initializer_list<double> list) : ratios{list} {}   ///< From the slowest mode on.
};

/// The norm of mode shapes.
enum class ShapeNorm {
  mass,  ///< Phi' M Phi = 1 in the given units, but for rounding: K_q = diag(w^2)
  any,   ///< any: K_q = diag(w^2 m_i) with m_i = (Phi' M Phi)_ii
};

/// The modes of a superstructure held at its base. The given masses count:
///
///     M_q = Phi' M Phi in full      K_q = diag(w^2)      C_q = diag(2 zeta w)      for ShapeNorm::mass
struct StructureModes {
  std::vector<Time> periods{};        ///< s, of the modes; or give eigenvalues.
  std::vector<double> eigenvalues{};  ///< w^2, 1/s^2.
  Eigen::MatrixXd shapes{};           ///< A row for each freedom, a column for each mode; rotations in rad.
  Length length = units::m;           ///< Unit of the translations of the shapes.
  Mass mass = units::kg;              ///< Unit of mass in which the shapes have norm 1.
  std::vector<std::string> names{};   ///< Names of the rows, "floor 1 x"; where given, they go before freedoms.
  std::vector<std::string> notes{};   ///< Remarks about their files, which results repeat.
  std::vector<double> ratios{};       ///< Damping ratios, as ModalDamping; for a building without `damping`.
  ShapeNorm norm = ShapeNorm::mass;   ///< moat never guesses it.
  int keep = 0;                       ///< How many of the first modes are used; 0: all.
  /// Replaces the shapes by Phi (Phi' M Phi)^(-1/2). The periods are then exactly those given. It changes the building.
  bool orthonormalise = false;
};

/// Modes as read_modes() read them.
StructureModes structure_modes(const ModesFromFile& file, const StructureModes& units = {});

/// A building that is given by its matrices, its modes, or a condensed finite-element model, on bearings or fixed:
///
///     M u'' + C (u' - R b') + K (u - R b) = - M iota a_g        R: rigid motion of the floors with the base
///
/// Floors move relative to the ground as those of other buildings do; gaps, moats and results work on them. Its forces
/// are elastic: storey shears are sums of K (u - R b), without damping. With modes, and these on a base,
///
///     M_q q'' + L (b'' + iota a_g) + C_q q' + K_q q = 0,   L' q'' + M_t (b'' + iota a_g) + isolators = 0
///
/// with L = Phi' M R and M_t = M_b + R' M R: the mass that the kept modes leave out rides on the base.
///
///     add(model, Superstructure{.name = "tower", .stiffness = read_matrix("K.csv", {.force = kN, .length = m}),
///                               .freedoms = per_floor(Freedoms::x), .floors = {...}, .damping = ModalDamping{0.05},
///                               .base = SuperstructureBase{.mass = 80 * tonne}, .isolation = LeadRubberBearing{...}});
struct Superstructure {
  /// Put before the names of all parts where a model has several buildings.
  std::string name{};
  /// Stiffness of the floors, held at the base; or give `modes`, `condensed` or `storeys`.
  std::optional<MatrixInUnits> stiffness{};
  std::optional<StructureModes> modes{};  ///< Instead of stiffness.
  /// Instead of stiffness and freedoms: that of a Frame or FiniteElements. Floors that are left out come from it, and a
  /// level at its feet is the base. Each of its towers is a building of its own, "<name> west".
  std::optional<CondensedStructure> condensed{};
  /// Instead of stiffness, freedoms and floors: springs between floors in plan. Its row `base`, if it has one, is the
  /// base.
  std::optional<StoreyTable> storeys{};
  /// Mass of the floors; left out: diagonal, from `floors`.
  std::optional<MatrixInUnits> mass{};
  FreedomOrder freedoms = per_floor(Freedoms::x_y_rotation);  ///< Order of the rows of all matrices and shapes.
  std::vector<SuperstructureFloor> floors{};                  ///< From the lowest up.
  /// Damping of the superstructure held at its base; left out: the ratios of `modes`, or none.
  std::variant<std::monostate, ModalDamping, RayleighDamping, MatrixInUnits> damping{};
  std::optional<SuperstructureBase> base{};  ///< Left out: it stands on the ground, or `on`.
  /// Bases that were added before: that of another building, for several superstructures on one base, or several slabs
  /// that move apart. Several slabs need their rows in `stiffness`, which then acts between them too:
  ///
  ///     R = -K_ss^-1 K_sb      K_bb + K_bs R between the slabs
  ///
  /// Pendulums under a base that is there already need a weight of their own.
  std::vector<DiaphragmId> on{};
  PlanBearings bearings{};               ///< Under the base, in plan.
  std::optional<Isolation> isolation{};  ///< Under the base, on a line.
  /// Overturning and vertical motion act on the bearings; left out: the weight on each is constant.
  std::optional<AxialForces> axial_forces{};
};

/// The parts of a superstructure that was added.
struct SuperstructureParts {
  std::string name;  ///< As given.
  /// Not specified() for a fixed building. On a line it stands for a node: its y and r are not given.
  DiaphragmId base;
  Places<DiaphragmId, floors_remedy> floors;  ///< From the lowest up, without the base; on a line nodes, as the base.
  std::vector<ParticipatingMass> modes;       ///< Modes of the superstructure held at its base.
  std::vector<std::string> notes;             ///< Sentences about the input, which results repeat.

  /// By its number in names: floor(1) is the lowest. Throws InputError outside 1 to the number of floors.
  [[nodiscard]] DiaphragmId floor(int number) const {
    return floors.numbered(number, Check{"Superstructure", name}, "floor");
  }
  /// s, of the superstructure held at its base, longest first.
  [[nodiscard]] std::vector<double> periods() const;
};

/// Adds nodes or diaphragms `base`, `floor 1`, ..., an element `superstructure`, the bearings, and the Building. Throws
/// InputError for a bad parameter, matrices that are not symmetric or not positive definite, shapes that are not
/// orthogonal with these masses, and a name that is taken.
SuperstructureParts add(Model& model, const Superstructure& structure);

}  // namespace moat
