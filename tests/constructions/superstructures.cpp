// Superstructures from matrices, modes and tables of storeys.
#include <Eigen/Dense>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

const Eigen::MatrixXd chain = 1e9 * (Eigen::MatrixXd{2, 2} << 2, -1, -1, 1).finished();

template <class Change>
std::function<void()> superstructure(Change change) {
  return [change] {
    Model model;
    Superstructure tower{.name = "tower",
                         .stiffness = in_units(chain, {.force = N, .length = m}),
                         .freedoms = per_floor(Freedoms::x),
                         .floors = {SuperstructureFloor{.height = 3 * m, .mass = 500 * tonne},
                                    SuperstructureFloor{.height = 6 * m, .mass = 500 * tonne}},
                         .base = SuperstructureBase{.mass = 550 * tonne},
                         .isolation = Linear{.stiffness = 20 * MN / m}};
    change(tower);
    add(model, tower);
  };
}
// This building by its modes, changed.
template <class Change>
std::function<void()> by_modes(Change change) {
  return superstructure([change](Superstructure& tower) {
    tower.stiffness.reset();
    const Eigen::MatrixXd shapes = Eigen::MatrixXd::Identity(2, 2) / std::sqrt(500e3);
    tower.modes = StructureModes{.periods = {0.3 * s, 0.1 * s}, .shapes = shapes};
    change(*tower.modes);
  });
}
std::function<void()> matrix(const Eigen::MatrixXd& values, const MatrixUnits& units) {
  return [=] { static_cast<void>(in_units(values, units)); };
}
std::function<void()> stiffness(const Eigen::MatrixXd& values) {
  return superstructure([values](auto& tower) { tower.stiffness = in_units(values, {.force = N, .length = m}); });
}
template <class Change>
std::function<void()> storeys(Change change) {
  return [change] {
    StoreyTable table{.floors = {StoreyRow{.name = "floor 1",
                                           .height = 3 * m,
                                           .mass = 1 * tonne,
                                           .rotary_inertia = 1 * tonne * m_2,
                                           .stiffness_x = 1 * MN / m,
                                           .stiffness_y = 1 * MN / m,
                                           .rotational_stiffness = 1 * MN * m}}};
    change(table);
    static_cast<void>(storey_matrices(table));
  };
}
Eigen::MatrixXd with(Eigen::MatrixXd values, double entry, int row = 0, int column = 1) {
  values(row, column) = entry;
  return values;
}

Constructions by_matrices() {
  return {
      {"a matrix in units of nothing",
       matrix(chain, {.force = N, .length = 0 * m}),
       {"in_units", "length", "0 m", "> 0 m and finite", "Give the units of its entries: {.force = kN, .length = m}"}},
      {"a stiffness without unit of force",
       superstructure([](auto& tower) { tower.stiffness = in_units(chain, {.length = m, .mass = kg}); }),
       {"Superstructure \"tower\"", "force unit of stiffness", "0 N", "> 0 N and finite",
        "Give .force, for example kN"}},
      {"a matrix with a row too few",
       matrix(Eigen::MatrixXd::Ones(1, 2), {.force = N, .length = m}),
       {"in_units", "matrix", "1 x 2", "Give", "a square one"}},
      {"a matrix with a hole",
       matrix(with(chain, not_a_number), {.force = N, .length = m}),
       {"in_units", "matrix", "entries", "not finite", "Give numbers"}},
      {"a stiffness that is lopsided",
       stiffness(with(chain, -2e9)),
       {"Superstructure \"tower\"", "stiffness", "is not symmetric", "-2e+09", "Export the whole matrix"}},
      {"a stiffness that pushes away",
       stiffness(with(chain, 0.1e9, 1, 1)),
       {"Superstructure \"tower\"", "stiffness", "is indefinite", "eigenvalue -", "Look for a wrong sign"}},
      {"a stiffness of three floors for two",
       stiffness(Eigen::MatrixXd::Identity(3, 3)),
       {"Superstructure \"tower\"", "floors", "2 entries", "floor 3 x", "Give one of .floors for each floor"}},
      {"a superstructure of two kinds",
       superstructure([](auto& tower) { tower.modes = StructureModes{}; }),
       {"Superstructure \"tower\"", "stiffness, modes and condensed", "2 of them", "Give", "one of them"}},
      {"a superstructure without floors",
       superstructure([](auto& tower) { tower.floors.clear(); }),
       {"Superstructure \"tower\"", "floors", "is empty", "Give", "one for each floor"}},
      {"floors that fall",
       superstructure([](auto& tower) { tower.floors[1].height = 2 * m; }),
       {"Superstructure \"tower\"", "floor 2", "at 2 m", "not above 3 m", "Give heights above the base"}},
      {"a floor of the superstructure without mass",
       superstructure([](auto& tower) { tower.floors[1].mass = 0 * kg; }),
       {"Superstructure \"tower\"", "floor 2 mass", "0 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"a base of the superstructure without mass",
       superstructure([](auto& tower) { tower.base->mass = 0 * kg; }),
       {"Superstructure \"tower\"", "base mass", "0 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"a base that carries less than nothing",
       superstructure([](auto& tower) { tower.base->carried = -1 * kg; }),
       {"Superstructure \"tower\"", "carried of the base", "-1 kg", ">= 0 kg and finite",
        "Check its sign and its unit"}},
      {"damping of a mode at critical",
       superstructure([](auto& tower) {
         tower.damping = ModalDamping{0.05, 1};
       }),
       {"Superstructure \"tower\"", "ratio of mode 2", "1", ">= 0 and < 1", "5 % is 0.05"}},
      {"damping of no mode",
       superstructure([](auto& tower) { tower.damping = ModalDamping{}; }),
       {"Superstructure \"tower\"", "damping", "0 ratios", "for 2 modes", "Give one for all modes"}},
      {"a freedom that is given twice",
       superstructure([](auto& tower) {
         tower.freedoms = {Freedom{1, FloorDirection::x}, Freedom{1, FloorDirection::x}};
       }),
       {"Superstructure \"tower\"", "freedom", "floor 1 x", "given twice", "Every row of the matrix has its own"}},
      {"a freedom of a floor that is not there",
       superstructure([](auto& tower) {
         tower.freedoms = {Freedom{1, FloorDirection::x}, Freedom{3, FloorDirection::x}};
       }),
       {"Superstructure \"tower\"", "floors has", "2 entries, the matrix has floor 3 x", "Give one of",
        "for each floor, from the lowest up"}},
  };
}

Constructions by_shapes_and_tables() {
  return {
      {"modes with periods and eigenvalues",
       by_modes([](auto& modes) {
         modes.eigenvalues = {1.0, 2.0};
       }),
       {"Superstructure \"tower\"", "periods and eigenvalues", "one of them", "is needed", "Give the periods"}},
      {"modes of norm 2",
       by_modes([](auto& modes) { modes.shapes *= 2; }),
       {"Superstructure \"tower\"", "masses of modes", "differ from 1", "300 %", "Give .norm = ShapeNorm::any"}},
      {"modes that are not orthogonal",
       by_modes([](auto& modes) { modes.shapes(0, 1) = modes.shapes(0, 0); }),
       {"Superstructure \"tower\"", "shapes 1 and 2", "are not orthogonal", "70.7107 %",
        "Masses and shapes may belong to different models"}},
      {"modes of no period",
       by_modes([](auto& modes) { modes.periods[1] = 0 * s; }),
       {"Superstructure \"tower\"", "squared frequency of mode 2", "inf 1/s^2", "> 0 1/s^2 and finite",
        "division by zero"}},
      {"modes with a period too many",
       by_modes([](auto& modes) { modes.periods.push_back(0.05 * s); }),
       {"Superstructure \"tower\"", "2 rows and 2 columns", "periods", "3",
        "Give a column of the shapes for each mode"}},
      {"modes with more kept than given",
       by_modes([](auto& modes) { modes.keep = 3; }),
       {"Superstructure \"tower\"", "keep", "3", "from 1 to 2", "0 keeps all modes"}},
      {"modes in units of no length",
       by_modes([](auto& modes) { modes.length = 0 * m; }),
       {"Superstructure \"tower\"", "length of modes", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"storeys without floor",
       storeys([](auto& table) { table.floors.clear(); }),
       {"storey_matrices", "there is no", "floor", "Give", "at least one"}},
      {"a storey that twists freely in a table",
       storeys([](auto& table) { table.floors[0].rotational_stiffness = 0 * J; }),
       {"storey_matrices", "floor 1 k_rotation", "0 N m/rad", "> 0 N m/rad and finite", "Check its sign and its unit"}},
      {"a storey in a table without mass",
       storeys([](auto& table) { table.floors[0].mass = 0 * kg; }),
       {"storey_matrices", "floor 1 mass", "0 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"a table of storeys with an eccentricity of no extent",
       [] { static_cast<void>(with_eccentricity(StoreyTable{.floors = {StoreyRow{.name = "roof"}}}, 0.05, 0.0)); },
       {"with_eccentricity", "roof", "has no outline", "Give one", "a share of it"}},
      {"a type of bearings twice",
       [] {
         const BearingType type{"LRB", BiaxialLinear{.stiffness = 1 * MN / m}};
         static_cast<void>(read_bearings("bearings.csv", BearingTypes{{type, type}}));
       },
       {"read_bearings", "type", "\"LRB\"", "given twice", "Give every type once"}},
      {"storeys in no file",
       [] { static_cast<void>(read_storeys("no such storeys.csv")); },
       {"no such storeys.csv", "there is", "no such file", "Check", "the path"}},
      {"modes in no file",
       [] { static_cast<void>(read_modes("no such modes.csv", "no such shapes.csv")); },
       {"no such modes.csv", "there is", "no such file", "Check", "the path"}},
  };
}

}  // namespace

Constructions superstructures() {
  Constructions all = by_matrices();
  const Constructions more = by_shapes_and_tables();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace moat::constructions
