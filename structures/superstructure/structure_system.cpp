#include "structures/superstructure/structure_system.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "structures/superstructure/matrix_checks.hpp"
#include "structures/superstructure/structure_modes.hpp"

namespace moat {
namespace {

// The columns of a motion of the base by 1 along x, along y, and by 1 rad about `centre`; on a line x alone.
Eigen::MatrixXd rigid_motion(const std::vector<SystemFloor>& floors, PlanVector centre, bool in_plan) {
  if (!in_plan) return Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(floors.size()), 1);
  Eigen::MatrixXd motion{3 * static_cast<Eigen::Index>(floors.size()), 3};
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const PlanVector arm = floors[i].centre_of_mass - centre;
    motion.middleRows<3>(3 * static_cast<Eigen::Index>(i)) << 1.0, 0.0, -arm.y, 0.0, 1.0, arm.x, 0.0, 0.0, 1.0;
  }
  return motion;
}

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
    find_rows();
    add_floors();
    for (int floor = 1; floor <= static_cast<int>(system_.floors.size()); ++floor)
      for (int k = 0; k < system_.per_floor(); ++k)
        system_.names.push_back(Freedom{floor, static_cast<FloorDirection>(k)}.name());
    positions_ = positions_of(check_, given_, static_cast<int>(system_.floors.size()), system_.in_plan);
    rigid_ = rigid_motion(system_.floors, system_.origin(), system_.in_plan);
    set_scale();
    system_.rigid = into_metres_.asDiagonal() * rigid_;
    if (system_.in_plan && system_.is_isolated()) system_.rigid.col(2) /= system_.bases.front().gyration();
    system_.carried = system_.rigid;
    check_.that(system_.bases.size() < 2 || structure_.stiffness,
                "it stands on several slabs, and stiffness is not given.",
                "Slabs that move apart strain it: give the whole matrix, with rows of all slabs.");
    add_mass();
    if (structure_.modes)
      add_modes(*structure_.modes, structure_.damping, check_, into_metres_, positions_, system_);
    else
      add_stiffness();
    return std::move(system_);
  }

 private:
  void find_rows() {
    if (const auto& condensed = structure_.condensed) {
      system_.in_plan = condensed->in_plan;
      system_.notes = condensed->notes;
      given_ = per_floor(system_.in_plan ? Freedoms::x_y_rotation : Freedoms::x)
                   .list(check_, "condensed", static_cast<int>(condensed->stiffness.rows()));
      return;
    }
    if (structure_.stiffness) {
      given_ = rows_of(*structure_.stiffness, "stiffness");
    } else {
      const StructureModes& modes = *structure_.modes;
      given_ = modes.names.empty() ? structure_.freedoms.list(check_, "shapes", static_cast<int>(modes.shapes.rows()))
                                   : freedoms_named(check_, modes.names);
    }
    const auto has = [&](FloorDirection direction) {
      return std::ranges::any_of(given_, [&](const Freedom& freedom) { return freedom.direction == direction; });
    };
    system_.in_plan = has(FloorDirection::rotation);
    check_.that(system_.in_plan || !has(FloorDirection::y), "freedoms have y without rotation.",
                "Give x alone for a building on a line, or x, y and rotation of every floor.");
  }

  // Names in the file go before .freedoms.
  [[nodiscard]] std::vector<Freedom> rows_of(const MatrixInUnits& matrix, std::string_view field) const {
    return matrix.names.empty() ? structure_.freedoms.list(check_, field, static_cast<int>(matrix.values.rows()))
                                : freedoms_named(check_, matrix.names);
  }

  void add_floors() {
    if (structure_.condensed && structure_.floors.empty()) {
      for (const Level& level : structure_.condensed->levels)
        add_floor(level.name, {.height = Length{level.height},
                               .mass = Mass{level.mass},
                               .rotary_inertia = RotaryInertia{level.rotary_inertia},
                               .centre_of_mass = {Length{level.centre_of_mass.x}, Length{level.centre_of_mass.y}},
                               .outline = level.outline});
    } else {
      check_.that(!structure_.floors.empty(), "floors is empty.", "Give one for each floor, from the lowest up.");
      for (const SuperstructureFloor& floor : structure_.floors)
        add_floor("floor " + std::to_string(system_.floors.size() + 1), floor);
      if (structure_.condensed) compare_with_levels(*structure_.condensed);
    }
    if (!structure_.base) return;
    const SuperstructureBase& base = *structure_.base;
    system_.bases = {checked("base", {.height = Length{},
                                      .mass = base.mass,
                                      .rotary_inertia = base.rotary_inertia,
                                      .centre_of_mass = base.centre_of_mass,
                                      .outline = base.outline,
                                      .half_width = base.half_width})};
  }

  // Matrices are about the centres of mass with which they were condensed.
  void compare_with_levels(const CondensedStructure& condensed) const {
    constexpr double round_off = 1e-3;  // m
    for (std::size_t i = 0; i < std::min(condensed.levels.size(), system_.floors.size()); ++i) {
      const Level& level = condensed.levels[i];
      const SystemFloor& floor = system_.floors[i];
      const double apart = system_.in_plan ? length(floor.centre_of_mass - level.centre_of_mass) : 0.0;
      check_.that(std::abs(floor.height - level.height) <= round_off && apart <= round_off,
                  "floor " + std::to_string(i + 1) +
                      " has another height or centre of mass than the condensed level at " + to_text(level.height) +
                      " m, (" + to_text(level.centre_of_mass.x) + ", " + to_text(level.centre_of_mass.y) + ") m.",
                  "Give those, or leave floors out.");
    }
  }

  void add_floor(const std::string& name, const SuperstructureFloor& floor) {
    const double below = system_.floors.empty() ? 0.0 : system_.floors.back().height;
    check_.that(floor.height.si() > below,
                "heights must rise: " + name + " at " + to_text(floor.height.si()) + " m is not above " +
                    to_text(below) + " m.",
                "Give heights above the base or the ground, from the lowest floor up.");
    system_.floors.push_back(checked(name, floor));
  }

  [[nodiscard]] SystemFloor checked(const std::string& name, const SuperstructureFloor& floor) const {
    check_.positive(name + " mass", floor.mass);
    SystemFloor result{.height = floor.height.si(),
                       .mass = floor.mass.si(),
                       .centre_of_mass = floor.centre_of_mass.si(),
                       .outline = floor.outline,
                       .half_width = floor.half_width.si()};
    if (!system_.in_plan) return result;
    result.rotary_inertia = checked_rotary_inertia({.name = name,
                                                    .mass = floor.mass,
                                                    .rotary_inertia = floor.rotary_inertia,
                                                    .centre_of_mass = floor.centre_of_mass,
                                                    .outline = floor.outline});
    double farthest = 0.0;
    for (std::size_t i = 0; i < floor.outline.size(); ++i)
      farthest = std::max(farthest, length(floor.outline.corner(i) - result.centre_of_mass));
    constexpr double least = 0.05, most = 1.2;  // shares of the farthest corner's distance
    check_.that(
        farthest == 0.0 || (result.gyration() > least * farthest && result.gyration() < most * farthest),
        "rotary inertia of " + name + " gives a radius of " + to_text(result.gyration()) + " m; is its unit t m^2?",
        "The farthest corner of its outline is " + to_text(farthest) + " m away.");
    return result;
  }

  // w = r theta: displacements in m from those in m and rad.
  void set_scale() {
    into_metres_.setOnes(rigid_.rows());
    for (std::size_t i = 0; system_.in_plan && i < system_.floors.size(); ++i)
      into_metres_[3 * static_cast<Eigen::Index>(i) + 2] = system_.floors[i].gyration();
  }

  // The rows of the floors, in the standard order, with entries in SI: N/m, N and N m, or kg, kg m and kg m^2.
  [[nodiscard]] Eigen::MatrixXd in_si(const Eigen::MatrixXd& values, double unit, double length,
                                      const std::vector<int>& positions, const std::vector<Freedom>& rows) const {
    const auto size = static_cast<Eigen::Index>(positions.size());
    Eigen::MatrixXd matrix{size, size};
    const auto factor = [&](int position) {
      return rows[static_cast<std::size_t>(position)].direction == FloorDirection::rotation ? length : 1.0;
    };
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j) {
        const int row = positions[static_cast<std::size_t>(i)], column = positions[static_cast<std::size_t>(j)];
        matrix(i, j) = values(row, column) * unit * factor(row) * factor(column);
      }
    return matrix;
  }
  // Rows of the base may be there too: rigid motion of all must strain nothing then. `with_base` gets all rows.
  Eigen::MatrixXd of_floors(const MatrixInUnits& matrix, std::string_view field, double unit,
                            Eigen::MatrixXd* with_base = nullptr) {
    system_.notes.insert(system_.notes.end(), matrix.notes.begin(), matrix.notes.end());
    const std::vector<Freedom> rows = rows_of(matrix, field);
    std::vector<int> positions = positions_of(check_, rows, static_cast<int>(system_.floors.size()), system_.in_plan);
    const Eigen::MatrixXd own = in_si(matrix.values, unit, matrix.length, positions, rows);
    if (rows.size() == positions.size() && system_.bases.size() < 2) return own;
    std::vector<std::string> names = system_.names;
    const auto slabs = static_cast<int>(std::max(system_.bases.size(), std::size_t{1}));
    for (const int position : positions_of_base(check_, rows, slabs, system_.in_plan)) {
      positions.push_back(position);
      names.push_back(rows[static_cast<std::size_t>(position)].name());
    }
    const Eigen::MatrixXd whole = in_si(matrix.values, unit, matrix.length, positions, rows);
    Eigen::MatrixXd rigid{whole.rows(), rigid_.cols()};
    if (system_.is_isolated())
      rigid << rigid_, rigid_motion(system_.bases, system_.origin(), system_.in_plan);
    else
      rigid << rigid_, Eigen::MatrixXd::Identity(rigid_.cols(), rigid_.cols());
    // A building on the ground does not say about which point its foot turns.
    const Eigen::Index motions = system_.is_isolated() ? rigid.cols() : std::min<Eigen::Index>(rigid.cols(), 2);
    check_rigid({check_, field, names}, whole, rigid.leftCols(motions),
                field == "damping" ? "The factor alphaM of OpenSees damps motion against the ground; that of moat acts "
                                     "against the base. Give the damping of the building held at its base."
                                   : "The base may stand elsewhere in the order, or a support was left in.",
                system_.notes);
    if (with_base != nullptr) *with_base = whole;
    return own;
  }
  [[nodiscard]] Eigen::MatrixXd scaled(const Eigen::MatrixXd& matrix) const {
    const Eigen::VectorXd scale = into_metres_.cwiseInverse();
    const Eigen::MatrixXd result = scale.asDiagonal() * matrix * scale.asDiagonal();
    return 0.5 * (result + result.transpose());
  }
  [[nodiscard]] NamedRows named(std::string_view field) const { return {check_, field, system_.names}; }

  void add_mass() {
    const auto size = rigid_.rows();
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const SystemFloor& floor = system_.floors[static_cast<std::size_t>(i / system_.per_floor())];
      mass(i, i) = i % system_.per_floor() == 2 ? floor.rotary_inertia : floor.mass;
    }
    if (structure_.mass || structure_.condensed) {
      Eigen::MatrixXd whole = structure_.condensed ? structure_.condensed->mass
                                                   : of_floors(*structure_.mass, "mass", structure_.mass->mass);
      for (Eigen::Index i = 0; i < size; ++i) {
        constexpr double tolerated = 0.01;
        check_.that(std::abs(whole(i, i) - mass(i, i)) <= tolerated * mass(i, i),
                    "mass of " + system_.names[static_cast<std::size_t>(i)] + " is " + to_text(whole(i, i)) +
                        " in the matrix, and " + to_text(mass(i, i)) + " in floors, kg or kg m^2.",
                    "Give the same; the matrix counts.");
      }
      mass = symmetric(named("mass"), whole, Diagonal::positive, system_.notes);
    }
    system_.mass = scaled(mass);
    const Eigen::LLT<Eigen::MatrixXd> factors{system_.mass};
    check_.that(factors.info() == Eigen::Success, "mass is not positive definite.",
                "Every floor needs mass and rotary inertia.");
  }

  void add_stiffness() {
    Eigen::MatrixXd stiffness;
    if (structure_.condensed) {
      stiffness = structure_.condensed->stiffness;
    } else {
      const MatrixInUnits& given = *structure_.stiffness;
      check_.positive("force unit of stiffness", given.force, "N", "Give .force, for example kN.");
      Eigen::MatrixXd whole;
      stiffness = of_floors(given, "stiffness", given.force / given.length, &whole);
      if (system_.bases.size() > 1) stand_on_slabs(whole);
    }
    const Eigen::MatrixXd in_metres =
        scaled(symmetric(named("stiffness"), stiffness, Diagonal::positive, system_.notes));
    check_definite(named("stiffness"), in_metres, system_.notes);
    system_.stiffness = in_metres;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes{system_.stiffness, system_.mass};
    system_.modes =
        participating_masses(modes.eigenvalues(), modes.eigenvectors().transpose() * system_.mass * system_.rigid,
                             system_.rigid.transpose() * system_.mass * system_.rigid);
    add_damping(modes.eigenvalues().cwiseSqrt(), modes.eigenvectors());
  }

  // R = -K_ss^-1 K_sb, and the stiffness that is left between the slabs: it acts on the motion of the others relative
  // to that of the first.
  void stand_on_slabs(const Eigen::MatrixXd& whole) {
    const Eigen::Index n = rigid_.rows(), m = whole.rows() - n, first = system_.per_floor();
    Eigen::VectorXd of_slabs = Eigen::VectorXd::Ones(m);
    for (std::size_t i = 0; system_.in_plan && i < system_.bases.size(); ++i)
      of_slabs[3 * static_cast<Eigen::Index>(i) + 2] = system_.bases[i].gyration();
    const Eigen::VectorXd per_slab = of_slabs.cwiseInverse();
    const Eigen::MatrixXd carried = -whole.topLeftCorner(n, n).llt().solve(whole.topRightCorner(n, m));
    Eigen::MatrixXd between = whole.bottomRightCorner(m, m) + whole.bottomLeftCorner(m, n) * carried;
    system_.carried = into_metres_.asDiagonal() * carried * per_slab.asDiagonal();
    system_.notes.push_back("It stands on " + std::to_string(system_.bases.size()) +
                            " slabs: base shear, isolators and periods in results are those of the first slab.");
    const double uncoupled = 1e-9 * whole.bottomRightCorner(m, m).diagonal().maxCoeff();
    if (between.cwiseAbs().maxCoeff() <= uncoupled) return;
    between = (per_slab.asDiagonal() * between * per_slab.asDiagonal()).bottomRightCorner(m - first, m - first).eval();
    system_.between_bases = 0.5 * (between + between.transpose());
    system_.bases_rigid =
        (of_slabs.asDiagonal() * rigid_motion(system_.bases, system_.origin(), system_.in_plan)).bottomRows(m - first);
    if (system_.in_plan) system_.bases_rigid.col(2) /= system_.bases.front().gyration();
  }

  // w: angular frequencies, 1/s; Q: shapes with Q' M Q = I.
  void add_damping(const Eigen::VectorXd& frequencies, const Eigen::MatrixXd& shapes) {
    const auto size = system_.stiffness.rows();
    system_.damping = Eigen::MatrixXd::Zero(size, size);
    if (const auto* modal = std::get_if<ModalDamping>(&structure_.damping)) {
      const Eigen::VectorXd ratios = ratios_of(check_, *modal, size, system_.notes);
      const Eigen::MatrixXd heavy = system_.mass * shapes;
      system_.damping = heavy * (2.0 * ratios.cwiseProduct(frequencies)).asDiagonal() * heavy.transpose();
    } else if (const auto* rayleigh = std::get_if<RayleighDamping>(&structure_.damping)) {
      const RayleighFactors factors = rayleigh_factors_of(*rayleigh, system_.modes);
      system_.damping = factors.mass_factor * system_.mass + factors.stiffness_factor * system_.stiffness;
    } else if (const auto* matrix = std::get_if<MatrixInUnits>(&structure_.damping)) {
      check_.positive("force unit of damping", matrix->force, "N", "Give .force, for example kN.");
      const Eigen::MatrixXd whole = of_floors(*matrix, "damping", matrix->force / matrix->length);
      system_.damping = scaled(symmetric(named("damping"), whole, Diagonal::not_negative, system_.notes));
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{system_.damping, Eigen::EigenvaluesOnly};
      constexpr double round_off = 1e-9;
      check_.that(solver.eigenvalues()[0] >= -round_off * solver.eigenvalues()[size - 1],
                  "damping has the negative eigenvalue " + to_text(solver.eigenvalues()[0]) + " N s/m.",
                  "A damping takes energy from every motion.");
    }
    system_.damping = 0.5 * (system_.damping + system_.damping.transpose()).eval();
  }

  const Superstructure& structure_;
  Check check_;
  StructureSystem system_;
  std::vector<Freedom> given_;   // of the rows of stiffness or shapes
  std::vector<int> positions_;   // of the system's rows among them
  Eigen::MatrixXd rigid_;        // floors in m and rad, for motions of the base by 1 m and 1 rad
  Eigen::VectorXd into_metres_;  // 1, or the radius of gyration of a rotation
};

}  // namespace

double SystemFloor::gyration() const { return std::sqrt(rotary_inertia / mass); }

StructureSystem system_of(const Superstructure& structure, std::vector<SystemFloor> on) {
  return SystemBuilder{structure, std::move(on)}.build();
}

}  // namespace moat
