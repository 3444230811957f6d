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
      for (const std::string& note : structure_.stiffness->notes) system_.notes.push_back(note);
      given_ = rows_of(*structure_.stiffness, "stiffness");
    } else {
      const StructureModes& modes = *structure_.modes;
      given_ = modes.names.empty() ? structure_.freedoms.list(check_, "shapes", static_cast<int>(modes.shapes.rows()))
                                   : freedoms_named(check_, modes.names);
    }
    system_.in_plan = std::ranges::any_of(
        given_, [](const Freedom& freedom) { return freedom.direction == FloorDirection::rotation; });
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
  [[nodiscard]] Eigen::MatrixXd of_floors(const MatrixInUnits& matrix, std::string_view field, double unit) const {
    const std::vector<Freedom> rows = rows_of(matrix, field);
    return in_si(matrix.values, unit, matrix.length,
                 positions_of(check_, rows, static_cast<int>(system_.floors.size()), system_.in_plan), rows);
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
      for (Eigen::Index i = 0; i < size; i += system_.per_floor()) {
        constexpr double tolerated = 0.01;
        check_.that(std::abs(whole(i, i) - mass(i, i)) <= tolerated * mass(i, i),
                    "mass of " + system_.names[static_cast<std::size_t>(i)] + " is " + to_text(whole(i, i)) +
                        " kg in the matrix, and " + to_text(mass(i, i)) + " kg in floors.",
                    "Give the same; the matrix counts.");
      }
      mass = symmetric(named("mass"), whole, system_.notes);
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
      stiffness = of_floors(given, "stiffness", given.force / given.length);
      if (system_.bases.size() > 1)
        stand_on_slabs(given);
      else if (static_cast<Eigen::Index>(given_.size()) > stiffness.rows())
        check_with_base(given);
    }
    const Eigen::MatrixXd in_metres = scaled(symmetric(named("stiffness"), stiffness, system_.notes));
    check_definite(named("stiffness"), in_metres, system_.notes);
    system_.stiffness = in_metres;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes{system_.stiffness, system_.mass};
    system_.modes =
        participating_masses(modes.eigenvalues(), modes.eigenvectors().transpose() * system_.mass * system_.rigid,
                             system_.rigid.transpose() * system_.mass * system_.rigid);
    add_damping(modes.eigenvalues().cwiseSqrt(), modes.eigenvectors());
  }

  // The rows of the base are there too: rigid motion of all must strain nothing. Returns the stiffness of all, in SI.
  Eigen::MatrixXd check_with_base(const MatrixInUnits& given) {
    const auto slabs = static_cast<int>(std::max(system_.bases.size(), std::size_t{1}));
    std::vector<int> all = positions_;
    std::vector<std::string> names = system_.names;
    for (const int position : positions_of_base(check_, given_, slabs, system_.in_plan)) {
      all.push_back(position);
      names.push_back(given_[static_cast<std::size_t>(position)].name());
    }
    Eigen::MatrixXd rigid{static_cast<Eigen::Index>(all.size()), rigid_.cols()};
    if (system_.is_isolated())
      rigid << rigid_, rigid_motion(system_.bases, system_.origin(), system_.in_plan);
    else
      rigid << rigid_, Eigen::MatrixXd::Identity(rigid_.cols(), rigid_.cols());
    const Eigen::MatrixXd whole = in_si(given.values, given.force / given.length, given.length, all, given_);
    check_rigid({check_, "stiffness", names}, whole, rigid, system_.notes);
    return whole;
  }

  // R = -K_ss^-1 K_sb, and the stiffness that is left between the slabs.
  void stand_on_slabs(const MatrixInUnits& given) {
    const Eigen::MatrixXd whole = check_with_base(given);
    const Eigen::Index n = rigid_.rows(), m = whole.rows() - n;
    Eigen::VectorXd of_slabs = Eigen::VectorXd::Ones(m);
    for (std::size_t i = 0; system_.in_plan && i < system_.bases.size(); ++i)
      of_slabs[3 * static_cast<Eigen::Index>(i) + 2] = 1.0 / system_.bases[i].gyration();
    const Eigen::MatrixXd carried = -whole.topLeftCorner(n, n).llt().solve(whole.topRightCorner(n, m)),
                          between = whole.bottomRightCorner(m, m) + whole.bottomLeftCorner(m, n) * carried;
    system_.carried = into_metres_.asDiagonal() * carried * of_slabs.asDiagonal();
    system_.between_bases = of_slabs.asDiagonal() * between * of_slabs.asDiagonal();
    system_.between_bases = 0.5 * (system_.between_bases + system_.between_bases.transpose()).eval();
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
      system_.damping = scaled(symmetric(named("damping"), whole, system_.notes));
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
