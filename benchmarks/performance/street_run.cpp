#include "performance/street_run.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include "analyses/step_equations.hpp"
#include "base/error.hpp"
#include "measuring/command_output.hpp"
#include "measuring/measure.hpp"
#include "measuring/street.hpp"
#include "output/energy_ledger.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr double step_length = 0.0025;

double peak_resident_bytes() {
  std::ifstream status{"/proc/self/status"};
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024.0 * std::stod(line.substr(6));
  throw Error{"/proc/self/status has no line VmHWM."};
}

TransientOptions options() {
  TransientOptions options{.step = step_length * s};
  // A street has many contacts, none of which chatters.
  options.max_events_per_second = 1'000'000'000;
  return options;
}

/// Time of streaming one byte, s: half of a copy, read and written.
double seconds_per_byte_copied() {
  constexpr std::size_t bytes = std::size_t{256} << 20;
  static std::vector<char> from(bytes, 1), to(bytes, 2);
  const double start = seconds(Clock::wall);
  std::memcpy(to.data(), from.data(), bytes);
  const double taken = seconds(Clock::wall) - start;
  // Next time in the other direction, so that no copy can be left out as one that was made before.
  from.swap(to);
  return taken / static_cast<double>(2 * bytes);
}

// The bytes that one Newton iteration must touch, per building: a bearing, a gap, 6 degrees of freedom; 5 storeys and
// 10 dampers are matrices, and 9 pairs of nodes with an entry of each. Every array counts once for each part that reads
// or writes it: indices of 4 bytes, numbers of 8, nothing padded. Between parts nothing stays in the caches.
//
//   evaluation     element: two nodes 8, parameters 24, committed and trial state (bearing 16, gap 32), deformation,
//                  rate and force written 24, tangents (bearing 8, gap 16)
//                  pair: two nodes 8, stiffness and damping 16
//                  node: stiffness and damping to the ground 16, displacement and velocity read 16, force written 8
//   assembly       element: four places 16, tangents (bearing 8, gap 16)
//                  node: mass and its place 12; nonzero: stiffness and damping read, value of the matrix written 24
//   factorisation  matrix read 12 a nonzero; factors without fill, diagonal apart: 12 an entry
//   solution       factors read 12 an entry, diagonal 8 a node; right-hand side read and written twice, 32 a node
//   vectors        acceleration, prediction (2), mass, force read and displacement, velocity, acceleration, residual
//                  written 72 a node; new acceleration 24 a node
namespace bytes {
constexpr double nodes = 6, pairs = 9, nonzeros = 26, off_diagonal_factors = 20;
constexpr double evaluation =
    (8 + 24 + 16 + 24 + 8) + (8 + 24 + 32 + 24 + 16) + pairs * (8 + 16) + nodes * (16 + 16 + 8);
constexpr double assembly = (16 + 8) + (16 + 16) + nodes * 12 + nonzeros * 24;
constexpr double factorisation = nonzeros * 12 + off_diagonal_factors * 12 + nodes * 8;
constexpr double solution = off_diagonal_factors * 12 + nodes * 8 + nodes * 32;
constexpr double vectors = nodes * 72 + nodes * 24;
constexpr double iteration = evaluation + assembly + factorisation + solution + vectors;
}  // namespace bytes

// The parts of an iteration, each beside a copy of memory.
void measure_parts(Model& model, int buildings, StreetReport& report) {
  const StepScheme scheme = StepScheme::average_acceleration();
  const double time = model.state().time;
  const double ground = street_motion().acceleration_at(time);
  const int size = model.degrees_of_freedom();
  StepEquations equations{model};
  SparseMatrix tangent = model.zero_matrix();
  Vector acceleration = model.state().acceleration.head(size), next_acceleration(size);
  Vector residual(size), direction(size);
  // Two lengths in turn, so that the tangent changes every time.
  int round = -1;
  const auto length = [&] { return round % 2 == 0 ? step_length : 0.5 * step_length; };
  const auto require = [](bool good) {
    if (!good) throw Error{"The tangent of the street could not be factorised."};
  };
  const std::vector<std::function<void()>> parts{
      [&] { model.evaluate(); },
      [&] {
        model.assemble_tangent(1.0, scheme.velocity_weight(length()), scheme.displacement_weight(length()), tangent);
      },
      [&] {
        require(equations.compute_residual(acceleration, residual));
        require(equations.compute_jacobian());
        direction = -residual;
        equations.solve(direction);
        // Not the start of the next one, whose tangent would be another.
        next_acceleration = acceleration + direction;
      },
  };
  report.parts = {{"evaluation", buildings * bytes::evaluation, {}},
                  {"assembly", buildings * bytes::assembly, {}},
                  {"iteration", buildings * bytes::iteration, {}}};
  constexpr int rounds = 7;
  for (; round < rounds; ++round) {
    const double copy = seconds_per_byte_copied();
    equations.begin({.length = length(), .end_time = time + length(), .ground_acceleration = {ground}}, scheme,
                    acceleration);
    // So that the guess has been evaluated, as in every iteration but the first.
    require(equations.compute_residual(acceleration, residual));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double start = seconds(Clock::wall);
      parts[i]();
      if (round >= 0) report.parts[i].seconds.push_back(seconds(Clock::wall) - start);
    }
    if (round >= 0) report.seconds_per_byte.push_back(copy);
  }
}

}  // namespace

StreetReport measure_street(const StreetSetting& setting) {
  StreetReport report;
  double start = seconds(Clock::wall);
  Model model = street(setting.buildings);
  report.degrees_of_freedom = model.degrees_of_freedom();
  report.build_seconds = seconds(Clock::wall) - start;
  report.model_bytes = peak_resident_bytes();

  std::optional<Transient> transient{std::in_place, model, street_motion(), options()};
  EnergyLedger ledger;
  transient->attach(ledger);

  for (int i = 0; i < setting.steps_before; ++i) transient->advance();
  for (int i = 0; i < setting.steps; ++i) {
    const long iterations = transient->statistics().newton_iterations;
    start = seconds(Clock::wall);
    transient->advance();
    report.step_seconds.push_back(seconds(Clock::wall) - start);
    report.step_iterations.push_back(static_cast<double>(transient->statistics().newton_iterations - iterations));
  }
  report.peak_bytes = peak_resident_bytes();
  transient.reset();
  if (setting.parts) measure_parts(model, setting.buildings, report);
  return report;
}

StreetReport run_street(const StreetSetting& setting) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string arguments = " street --buildings " + std::to_string(setting.buildings) + " --steps-before " +
                                std::to_string(setting.steps_before) + " --steps " + std::to_string(setting.steps) +
                                (setting.parts ? " --parts" : "");
  return nlohmann::json::parse(output_of(shell_quoted(program) + arguments)).get<StreetReport>();
}

}  // namespace moat::performance
