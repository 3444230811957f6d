// The smart base-isolated benchmark building of MOAT_EXPERIMENTS, for tests and ./moat bench performance.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
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

/// Why tests of an experiment are skipped; empty where its folder is there.
inline std::string why_experiment_is_missing(const std::string& experiment) {
  const std::string folder = folder_of_experiment(experiment);
  if (folder.empty()) return "set MOAT_EXPERIMENTS to a folder with " + experiment + " to run this test";
  return std::filesystem::is_directory(folder) ? "" : folder + " is not there; MOAT_EXPERIMENTS names its folder";
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
  /// On 92 lead-rubber bearings.
  [[nodiscard]] Superstructure on_lead_rubber() const {
    using namespace units;
    Superstructure building = from_matrices();
    building.bearings = bearings(
        LeadRubberBearing{.yield_force = 30 * kN, .yield_displacement = 6 * mm, .post_yield_stiffness = 0.6 * MN / m});
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
  /// Straight walls outside the rectangle around the base.
  static void add_walls(Model& model, DiaphragmId base, Length clearance = 30 * units::cm,
                        Stiffness stiffness = 500 * units::MN / units::m) {
    using namespace units;
    const Length left = -17.25 * m - clearance, right = 32.83 * m + clearance, low = -47.79 * m - clearance,
                 high = 30.69 * m + clearance;
    add(model, PlanMoat{.around = base,
                        .walls = {.corners = {{left, low}, {right, low}, {right, high}, {left, high}}},
                        .law = LinearElastic{.stiffness = stiffness}});
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

struct BenchmarkRun {
  CaseResult result;
  SuperstructureParts parts;
};
/// The building under both components of the record.
inline BenchmarkRun run_benchmark(const Superstructure& building, bool has_walls, bool has_dashpots) {
  Model model;
  const SuperstructureParts parts = add(model, building);
  if (has_dashpots) BenchmarkBuilding{}.add_dashpots(model, parts.base);
  if (has_walls) BenchmarkBuilding::add_walls(model, parts.base);
  CaseRun run{model, newhall(true), {.history_interval = 1 * units::ms}};
  run.run();
  return {run.result(), parts};
}

/// A peak of an independent program (Runge-Kutta of fourth order, converged), in SI units.
struct ExpectedPeak {
  const char *quantity, *where;
  double value;
};

/// On linear bearings with their dashpots.
inline const std::vector<ExpectedPeak> without_walls{{"displacement", "base", 0.486784},
                                                     {"displacement_x", "base", 0.484273},
                                                     {"displacement_y", "base", 0.192924},
                                                     {"rotation", "base", 0.00859755},
                                                     {"absolute_acceleration_x", "floor 8", 2.823545},
                                                     {"absolute_acceleration_y", "floor 8", 0.988657},
                                                     {"absolute_acceleration_x", "base", 2.208395},
                                                     {"absolute_acceleration_y", "base", 0.757872},
                                                     {"storey_shear_x", "storey 1", 30759.49e3},
                                                     {"storey_shear_y", "storey 1", 13924.62e3},
                                                     {"storey_torque", "storey 1", 491471.9e3},
                                                     {"overturning_moment_x", "storey 1", 622768.0e3},
                                                     {"overturning_moment_y", "storey 1", 257957.8e3},
                                                     {"total_base_shear_x", "base", 38561.32e3},
                                                     {"total_base_shear_y", "base", 16615.32e3},
                                                     {"total_base_torque", "base", 591551.1e3},
                                                     {"isolator_deformation", "bearings", 0.8171428}};
/// Likewise, between the walls.
inline const std::vector<ExpectedPeak> with_walls{{"displacement", "base", 0.375334},
                                                  {"displacement_x", "base", 0.344938},
                                                  {"displacement_y", "base", 0.286304},
                                                  {"rotation", "base", 0.00609136},
                                                  {"absolute_acceleration_x", "floor 8", 10.294864},
                                                  {"absolute_acceleration_y", "floor 8", 2.580955},
                                                  {"absolute_acceleration_x", "base", 5.277758},
                                                  {"absolute_acceleration_y", "base", 1.883291},
                                                  {"impact_force", "moat", 28305.80e3},
                                                  {"storey_shear_x", "storey 1", 58029.14e3},
                                                  {"storey_torque", "storey 1", 560614.7e3},
                                                  {"storey_shear_y", "storey 1", 26327.12e3},
                                                  {"overturning_moment_x", "storey 1", 1325317e3},
                                                  {"overturning_moment_y", "storey 1", 480418.6e3},
                                                  {"isolator_deformation", "bearings", 0.3977890}};
/// Likewise: corners meet the walls so often.
inline constexpr std::size_t impacts_with_walls = 9;
/// On lead-rubber bearings without dashpots.
inline const std::vector<ExpectedPeak> on_lead_rubber{{"displacement", "base", 0.6381119},
                                                      {"displacement_x", "base", 0.6372032},
                                                      {"displacement_y", "base", 0.2391328},
                                                      {"rotation", "base", 0.008404145},
                                                      {"absolute_acceleration_x", "floor 8", 1.957909},
                                                      {"absolute_acceleration_y", "floor 8", 1.188950},
                                                      {"absolute_acceleration_x", "base", 1.589654},
                                                      {"storey_shear_x", "storey 1", 29492.64e3},
                                                      {"isolator_deformation", "bearings", 0.8849756},
                                                      {"isolator_force", "bearings", 536.4002e3}};

}  // namespace moat::testing
