// The smart base-isolated benchmark building of MOAT_EXPERIMENTS, for tests and ./moat bench performance.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <moat.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace moat::testing {

/// The folder of an experiment in MOAT_EXPERIMENTS, with a slash; empty without it.
inline std::string folder_of_experiment(const std::string& experiment) {
  const char* folder = std::getenv("MOAT_EXPERIMENTS");
  return folder == nullptr ? "" : std::string{folder} + "/" + experiment + "/";
}

/// Fault normal along x; in plan fault parallel along y.
inline GroundMotion newhall(bool in_plan) {
  std::ifstream file{folder_of_experiment("smart_base_isolated") + "newhall_fn_fp.txt"};
  std::vector<double> x, y;
  for (std::string line; std::getline(file, line);) {
    double along_x = 0.0, along_y = 0.0;
    if (line.empty() || line[0] == '%' || std::sscanf(line.c_str(), "%lf %lf", &along_x, &along_y) != 2) continue;
    x.push_back(0.01 * along_x);
    y.push_back(0.01 * along_y);
  }
  const GroundMotion motion{"Newhall", 0.005, x};
  return in_plan ? motion.with_component_y(y, motion, {"FP", 0.005, y}) : motion;
}

/// Eight storeys, L-shaped in plan, on 92 bearings.
class BenchmarkBuilding {
 public:
  /// Reads the files; the folder must be there.
  BenchmarkBuilding() : folder_{folder_of_experiment("smart_base_isolated")} {
    std::ifstream{folder_ + "building.json"} >> data_;
  }

  /// On linear bearings, without their dashpots.
  [[nodiscard]] Superstructure from_matrices() const {
    using namespace units;
    Superstructure building{.stiffness = read_matrix(folder_ + "stiffness_kN_m.csv", {.force = kN, .length = m})};
    for (std::size_t i = 0; i < 8; ++i)
      building.floors.push_back({.height = data_["heights_m"][i + 1].get<double>() * m,
                                 .mass = data_["floor_mass_t"][i].get<double>() * tonne,
                                 .rotary_inertia = data_["floor_inertia_t_m2"][i].get<double>() * tonne * m * m,
                                 .outline = outline_});
    building.damping = read_matrix(folder_ + "damping_kNs_m.csv", {.force = kN, .length = m});
    building.base = SuperstructureBase{.mass = data_["base_mass_t"].get<double>() * tonne,
                                       .rotary_inertia = data_["base_inertia_t_m2"].get<double>() * tonne * m * m,
                                       .outline = outline_};
    building.bearings = bearings(BiaxialLinear{.stiffness = 919.422 * kN / m});
    return building;
  }
  [[nodiscard]] Superstructure from_modes() const {
    Superstructure building = from_matrices();
    building.stiffness.reset();
    StructureModes modes{.eigenvalues = data_["eigenvalues"].get<std::vector<double>>(),
                         .shapes = Eigen::MatrixXd{24, 24},
                         .mass = units::tonne};
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) modes.shapes(i, j) = data_["modes"][i][j].get<double>();
    building.modes = modes;
    building.damping = ModalDamping{0.05};
    return building;
  }

  /// A law at all places of bearings.
  template <class Law>
  [[nodiscard]] std::vector<PlanBearings::Placed> bearings(const Law& law) const {
    std::vector<PlanBearings::Placed> list;
    for (const PlanPosition& at : positions()) list.emplace_back(at, law);
    return list;
  }
  [[nodiscard]] std::vector<PlanPosition> positions() const {
    std::ifstream file{folder_ + "bearings.csv"};
    std::vector<PlanPosition> list;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      double x = 0.0, y = 0.0;
      if (std::sscanf(line.c_str(), "%lf,%lf", &x, &y) == 2) list.push_back({x * units::m, y * units::m});
    }
    return list;
  }

  /// The dashpots beside the linear bearings.
  void add_dashpots(Model& model, DiaphragmId base) const {
    using namespace units;
    int number = 0;
    for (const PlanPosition& at : positions())
      for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
        add(model, PlanSpring<Viscous>{.name = "damper " + std::to_string(++number),
                                       .lower = PlanPoint{ground, at},
                                       .upper = PlanPoint{base, at},
                                       .direction = direction,
                                       .law = Viscous{.damping = 27.717 * kN * s / m},
                                       .deformation_quantity = "",
                                       .force_quantity = ""});
  }
  /// Straight walls, 0.30 m outside the rectangle around the base.
  static void add_walls(Model& model, DiaphragmId base) {
    using namespace units;
    add(model, PlanMoat{.around = base,
                        .walls = {.corners = {{-17.55 * m, -48.09 * m},
                                              {33.13 * m, -48.09 * m},
                                              {33.13 * m, 30.99 * m},
                                              {-17.55 * m, 30.99 * m}}},
                        .law = LinearElastic{.stiffness = 5e8 * N / m}});
  }

 private:
  std::string folder_;
  nlohmann::json data_;
  PlanOutline outline_{.corners = {{-17.25 * units::m, -47.79 * units::m},
                                   {12.53 * units::m, -47.79 * units::m},
                                   {12.53 * units::m, -11.16 * units::m},
                                   {32.83 * units::m, -11.16 * units::m},
                                   {32.83 * units::m, 30.69 * units::m},
                                   {-17.25 * units::m, 30.69 * units::m}}};
};

}  // namespace moat::testing
