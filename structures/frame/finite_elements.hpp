// A finite-element model of a superstructure, and its condensation to the motions of rigid floors.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/plan_vector.hpp"
#include "base/quantity.hpp"
#include "base/sparse_matrix.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// The name of a node; a number is a name too.
class NodeName {
 public:
  NodeName() = default;                                            ///< Has no name.
  NodeName(int number) : text_{std::to_string(number)} {}          ///< "17" of 17.
  NodeName(const char* text) : text_{text} {}                      ///< Takes the text as it stands.
  NodeName(std::string text) : text_{std::move(text)} {}           ///< Takes the text as it stands.
  [[nodiscard]] const std::string& text() const { return text_; }  ///< As it stands in messages.

 private:
  std::string text_;
};

/// A node with the motions x, y, z, and the rotations about x, y, z.
struct FrameNode {
  NodeName name{};       ///< its number in the list, from 1, if left out
  Length x{}, y{}, z{};  ///< z upwards, from any origin
};

/// Nodes at one height that move together in plan: a rigid floor.
///
///     ux = Ux - (y - Y) R,   uy = Uy + (x - X) R,   rz = R      (X, Y): centre of mass
///
/// Their vertical motions and their rotations about x and y stay free.
///
/// Towers beside each other have levels of their own, which rise from the last level without tower, that of a podium:
///
///     {{.height = 4 * m}, {.tower = "west", .nodes = {21, 22, 23}}, {.tower = "east", .nodes = {24, 25, 26}}, ...}
struct FrameLevel {
  /// "floor 1", "west floor 1" for the lowest if left out; "base" for a level at the height of the lowest nodes.
  std::string name{};
  /// The tower to which it belongs; none for a podium, or where there is one tower alone.
  std::string tower{};
  /// Takes all nodes within 1 mm of this height; or give the nodes.
  std::optional<Length> height{};
  /// Nodes, whose heights differ by at most 1 mm.
  std::vector<NodeName> nodes{};
  /// >= 0 kg, besides the masses of the model.
  Mass mass{};
  /// >= 0 kg m^2, about the vertical axis through the centre of this mass.
  RotaryInertia rotary_inertia{};
  /// Where this mass acts; the mean of the nodes if left out.
  std::optional<PlanPosition> centre_of_mass{};
};

/// The motions that a level keeps.
enum class LevelMotion {
  in_plan,  ///< x, y and rotation
  along_x,  ///< x alone: y and the rotation about z of the levels are held
  along_y   ///< y alone
};

/// How the feet stand on the base. The base is rigid in plan and does not move vertically.
enum class Feet {
  clamped,  ///< no motion relative to the base
  pinned,   ///< free rotations about x and y
  given     ///< as the model holds them itself
};

/// Treatment of masses on motions that are condensed, such as the vertical ones.
enum class Vanishing {
  refuse,  ///< Throws InputError.
  drop,    ///< left out, with a note
  guyan,   ///< moved to the levels by the static deflection; periods become too short
  keep     ///< none: these motions stay beside those of the levels
};

/// Nodes with six motions each, and sparse matrices in SI units.
///
/// Motions of the nodes follow from the unknowns of the matrices: motions = equations * unknowns, where row 6 i + d is
/// motion d (x, y, z, rotations about x, y, z) of node i, both from 0. An empty row is a motion that is held.
///
/// A model with along_x whose nodes have all the same y moves in its plane: y and the rotations about x and z of all
/// nodes are held; likewise along_y.
struct FiniteElements {
  std::string name{};                    ///< Messages call it so.
  std::vector<FrameNode> nodes{};        ///< At least one.
  SparseMatrix stiffness{};              ///< Symmetric; N/m, N, N m.
  SparseMatrix mass{};                   ///< Symmetric; kg, kg m, kg m^2; none if left out.
  SparseMatrix equations{};              ///< The unit matrix if left out: the unknowns are the motions, node by node.
  std::vector<FrameLevel> diaphragms{};  ///< From the lowest up, tower by tower.
  Feet feet = Feet::clamped;             ///< Feet that belong to a level move with it in plan.
  std::vector<NodeName> foot_nodes{};    ///< All nodes within 1 mm of the lowest height if left out.
  LevelMotion motion = LevelMotion::in_plan;  ///< How all levels move.
  Vanishing masses = Vanishing::refuse;       ///< Where motions that are condensed have none.
};

/// A level of a condensed structure.
struct Level {
  std::string name{};           ///< "floor 1"
  std::string tower{};          ///< as given
  double height = 0.0;          ///< m, above the lowest nodes
  double mass = 0.0;            ///< kg, with that of Guyan's condensation; 0 where none is given
  double rotary_inertia = 0.0;  ///< kg m^2, about the centre of mass; 0 on a line
  PlanVector centre_of_mass{};  ///< m; the mean of the nodes for a level without mass
  PlanOutline outline{};        ///< of a table of storeys; else empty
};

/// A motion with mass, m or rad, that stays beside those of the levels.
struct KeptMotion {
  std::string name{};     ///< "node 17, z"
  std::size_t level = 0;  ///< to which its node belongs, or the lowest one above it
  /// This motion in rigid motions of base and building: by 1 m along x, y and z, and by 1 rad about these axes through
  /// (0, 0) at the lowest nodes. On a line x is along it, from the centre of the first level.
  Eigen::Matrix<double, 6, 1> rigid = Eigen::Matrix<double, 6, 1>::Zero();
};

/// A superstructure whose motions are those of its levels, from the lowest up: one along a line; in plan x, y and the
/// rotation [rad] about the centre of mass of each. Those that are kept follow. SI units.
struct CondensedStructure {
  Eigen::MatrixXd stiffness{};       ///< Symmetric.
  Eigen::MatrixXd mass{};            ///< Symmetric; rows of zeros for a level without mass.
  std::vector<Level> levels{};       ///< From the lowest up.
  bool in_plan = true;               ///< Three motions per level, not one.
  std::vector<std::string> notes{};  ///< Sentences for reports: assumptions, masses that were dropped.
  /// Relative errors of the squared frequencies, to first order, with Vanishing::guyan: of the lowest modes, at
  /// most 12.
  std::vector<double> eigenvalue_errors{};
  std::vector<KeptMotion> kept{};  ///< With Vanishing::keep.

  /// The level at the feet, which is the base of a Superstructure; null: it has none.
  [[nodiscard]] const Level* base() const { return !levels.empty() && levels[0].height <= 1e-3 ? &levels[0] : nullptr; }
};

/// Constrains the levels, holds the feet, and condenses all other motions s exactly:
///
///     K_c = K_mm - K_ms K_ss^-1 K_sm
///
/// With Vanishing::guyan M_c = G^T M G, G = [1; -K_ss^-1 K_sm]; a note gives the first-order error of each period.
///
/// Throws InputError for matrices that are not symmetric (relative to the diagonal: above 1e-12 a note, above 1e-6 an
/// error). It throws too for a level without nodes, with nodes at several heights or with a node of another level, a
/// motion that nothing holds (with its node), and masses as Vanishing says. `kind` begins its messages.
CondensedStructure condensed(const FiniteElements& model, std::string_view kind = "FiniteElements");

}  // namespace moat
