#include "performance/street_run.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "analyses/step_equations.hpp"
#include "base/error.hpp"
#include "output/energy_ledger.hpp"
#include "performance/measure.hpp"
#include "performance/memory_bandwidth.hpp"
#include "performance/street.hpp"
#include "solvers/factorisation.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr const char* hidden_option = "--street-process";
constexpr double step_length = 0.0025;

class ChangeCounter final : public StepObserver {
 public:
  double changes = 0.0;
  void start(const StepView&) override {}
  void step(const StepView&) override {}
  void event(const StepView&, std::span<const RegimeChange> list) override {
    changes += static_cast<double>(list.size());
  }
  void finish(const StepView&) override {}
};

double peak_resident_bytes() {
  std::ifstream status{"/proc/self/status"};
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024.0 * std::stod(line.substr(6));
  throw Error{"/proc/self/status has no line VmHWM."};
}

// FNV-1a over whole words: streets that differ in one bit anywhere differ here.
std::uint64_t fingerprint(const MotionState& state) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const Vector* vector : {&state.displacement, &state.velocity, &state.acceleration})
    for (const double value : *vector) hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ull;
  return hash;
}

double contacts(const Model& model) { return model.contacts_going_on(); }

TransientOptions options_of(const StreetSetting& setting) {
  TransientOptions options{.step = step_length * s, .location_tolerance = setting.location_tolerance * m};
  // A street has many contacts, none of which chatters.
  options.max_events_per_second = 1'000'000'000;
  return options;
}

// The bytes that one Newton iteration must touch, per building: 5 storeys, 10 dampers, a bearing, a gap, 6 degrees of
// freedom. Every array is counted once for each part that reads or writes it, as large as it must be: indices of 4
// bytes, numbers of 8, nothing padded, nothing that could be left out. Between parts nothing stays in the caches.
//
//   evaluation     element: two nodes 8, parameters (storey 8, damper 8, bearing 24, gap 24), committed and trial
//                  state (bearing 16, gap 32), deformation, rate and force written 24, tangents (bearing 8, gap 16)
//                  node: displacement and velocity read 16, force written 8
//   assembly       element: four places 16, tangents (storey 8, damper 8, bearing 8, gap 16); masses 8 a node;
//                  values of the matrix written 8 a nonzero
//   factorisation  matrix read 12 a nonzero; factors without fill, diagonal apart: 12 an entry
//   solution       factors read 12 an entry, diagonal 8 a node; right-hand side there and back 32 a node
//   vectors        acceleration, prediction (2), mass, force read and displacement, velocity, acceleration, residual
//                  written 72 a node; new acceleration 24 a node
struct BytesPerBuilding {
  static constexpr double nodes = 6, nonzeros = 26, off_diagonal_factors = 20;
  static constexpr double evaluation =
      5 * (8 + 8 + 24) + 10 * (8 + 8 + 24) + (8 + 24 + 16 + 24 + 8) + (8 + 24 + 32 + 24 + 16) + nodes * (16 + 8);
  static constexpr double assembly = 5 * (16 + 8) + 10 * (16 + 8) + (16 + 8) + (16 + 16) + nodes * 8 + nonzeros * 8;
  static constexpr double factorisation = nonzeros * 12 + off_diagonal_factors * 12 + nodes * 8;
  static constexpr double solution = off_diagonal_factors * 12 + nodes * 8 + nodes * 32;
  static constexpr double vectors = nodes * 72 + nodes * 24;
  static constexpr double iteration = evaluation + assembly + factorisation + solution + vectors;
};

// The parts of an iteration, each beside a copy of memory.
void measure_parts(Model& model, int buildings, StreetReport& report) {
  const StepScheme scheme = StepScheme::average_acceleration();
  const double time = model.state().time;
  const double ground = street_motion().acceleration_at(time);
  const int size = model.degrees_of_freedom();
  StepEquations equations{model};
  SparseMatrix tangent = model.pattern();
  Factorisation factorisation;
  Vector acceleration = model.state().acceleration.head(size), next_acceleration(size);
  Vector residual(size), direction(size);
  // Two lengths in turn, so that the tangent changes every time.
  int count = 0;
  const auto length = [&] { return count % 2 == 0 ? step_length : 0.5 * step_length; };
  const auto assemble = [&] {
    model.assemble_tangent(1.0, scheme.velocity_weight(length()), scheme.displacement_weight(length()), tangent);
  };
  const auto succeeded = [](bool good) {
    if (!good) throw Error{"The tangent of the street could not be factorised."};
  };
  const auto bytes = [&](double per_building) { return buildings * per_building; };
  using Bytes = BytesPerBuilding;
  report.parts = {
      {"evaluation", bytes(Bytes::evaluation), {}},
      {"assembly", bytes(Bytes::assembly), {}},
      {"refactorisation", bytes(Bytes::factorisation), {}},
      {"solution", bytes(Bytes::solution), {}},
      {"iteration", bytes(Bytes::iteration), {}},
      {"iteration with the factors of the last", bytes(Bytes::iteration - Bytes::factorisation), {}},
  };
  const auto iteration = [&] {
    succeeded(equations.compute_residual(acceleration, residual));
    succeeded(equations.compute_direction(residual, direction));
    // Not where the next one starts: its tangent would be another.
    next_acceleration = acceleration + direction;
  };
  const std::vector<Candidate> candidates{
      {"", [&] { model.evaluate(); }},
      {"", assemble},
      {"", [&] { succeeded(factorisation.factorise(tangent)); }},
      {"",
       [&] {
         direction = model.internal_forces().head(size);
         factorisation.solve(direction);
       }},
      {"", iteration},
      {"", iteration},
  };
  constexpr int rounds = 7;
  for (int round = -1; round < rounds; ++round, ++count) {
    const double copy = seconds_per_byte_copied();
    equations.begin({.length = length(), .end_time = time + length(), .ground_acceleration = ground}, scheme,
                    acceleration);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double start = seconds(Clock::wall);
      candidates[i].run();
      const double taken = seconds(Clock::wall) - start;
      if (round >= 0) report.parts[i].seconds.push_back(taken);
    }
    if (round >= 0) report.seconds_per_byte.push_back(copy);
  }
}

// One entry a line: its name, then its numbers.
void print(const StreetReport& report) {
  const auto line = [](const std::string& name, const std::vector<double>& values) {
    std::printf("%s", name.c_str());
    for (const double value : values) std::printf(" %.17g", value);
    std::printf("\n");
  };
  line("numbers", {static_cast<double>(report.degrees_of_freedom), report.build_seconds, report.start_seconds,
                   report.motion_seconds, report.solves, report.factorisations, report.events, report.changes,
                   report.contacts_at_end, report.peak_bytes});
  std::printf("fingerprint %llu\n", static_cast<unsigned long long>(report.fingerprint));
  line("step_seconds", report.step_seconds);
  line("step_iterations", report.step_iterations);
  line("seconds_per_byte", report.seconds_per_byte);
  for (const StreetPart& part : report.parts) {
    std::printf("part %s\n", part.name.c_str());
    line("part_bytes", {part.bytes});
    line("part_seconds", part.seconds);
  }
  std::printf("complete\n");
}

StreetReport parse(const std::string& output) {
  StreetReport report;
  bool complete = false;
  std::istringstream lines{output};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    std::string name;
    words >> name;
    const auto values = [&] {
      std::vector<double> list;
      for (double value; words >> value;) list.push_back(value);
      return list;
    };
    if (name == "numbers") {
      words >> report.degrees_of_freedom >> report.build_seconds >> report.start_seconds >> report.motion_seconds >>
          report.solves >> report.factorisations >> report.events >> report.changes >> report.contacts_at_end >>
          report.peak_bytes;
    } else if (name == "fingerprint") {
      words >> report.fingerprint;
    } else if (name == "step_seconds") {
      report.step_seconds = values();
    } else if (name == "step_iterations") {
      report.step_iterations = values();
    } else if (name == "seconds_per_byte") {
      report.seconds_per_byte = values();
    } else if (name == "part") {
      report.parts.push_back({line.substr(5), 0.0, {}});
    } else if (name == "part_bytes") {
      words >> report.parts.back().bytes;
    } else if (name == "part_seconds") {
      report.parts.back().seconds = values();
    } else if (name == "complete") {
      complete = true;
    }
  }
  if (!complete) throw Error{"The process of a street ended before its report was complete."};
  return report;
}

// The output of this program run with other arguments.
std::string output_of(std::vector<std::string> arguments) {
  char program[4096];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  int ends[2];
  if (length <= 0 || pipe(ends) != 0) throw Error{"A process for a street could not be prepared."};
  program[length] = '\0';
  arguments.insert(arguments.begin(), program);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw Error{"A process for a street could not be started."};
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execv(program, pointers.data());
    _exit(127);
  }
  close(ends[1]);
  std::string output;
  char buffer[4096];
  for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;)
    output.append(buffer, static_cast<std::size_t>(count));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error{"The process of a street failed."};
  return output;
}

}  // namespace

StreetReport run_street(const StreetSetting& setting) {
  return parse(
      output_of({hidden_option, std::to_string(setting.buildings), to_text(setting.location_tolerance),
                 std::to_string(setting.steps_before), std::to_string(setting.steps), setting.parts ? "1" : "0"}));
}

StreetReport measure_street(const StreetSetting& setting) {
  StreetReport report;
  double start = seconds(Clock::wall);
  Model model = street(setting.buildings);
  report.degrees_of_freedom = model.degrees_of_freedom();
  report.build_seconds = seconds(Clock::wall) - start;

  start = seconds(Clock::wall);
  std::optional<Transient> transient{std::in_place, model, street_motion(), options_of(setting)};
  EnergyLedger ledger;
  ChangeCounter counter;
  transient->attach(ledger);
  transient->attach(counter);
  report.start_seconds = seconds(Clock::wall) - start;

  for (int i = 0; i < setting.steps_before; ++i) transient->advance();
  counter.changes = 0.0;
  const SolverStatistics before = transient->statistics();
  const double motion_before = model.state().time;
  for (int i = 0; i < setting.steps; ++i) {
    const long iterations = transient->statistics().newton_iterations;
    start = seconds(Clock::wall);
    transient->advance();
    report.step_seconds.push_back(seconds(Clock::wall) - start);
    report.step_iterations.push_back(static_cast<double>(transient->statistics().newton_iterations - iterations));
  }
  const SolverStatistics& after = transient->statistics();
  const auto grown = [&](long SolverStatistics::*number) {
    return static_cast<double>(after.*number - before.*number);
  };
  report.motion_seconds = model.state().time - motion_before;
  report.solves = grown(&SolverStatistics::accepted_steps) + grown(&SolverStatistics::event_solves) +
                  grown(&SolverStatistics::rejected_steps);
  report.factorisations = grown(&SolverStatistics::factorisations);
  report.events = grown(&SolverStatistics::events);
  report.changes = counter.changes;
  report.contacts_at_end = contacts(model);
  report.fingerprint = fingerprint(model.state());
  report.peak_bytes = peak_resident_bytes();
  transient.reset();
  if (setting.parts) measure_parts(model, setting.buildings, report);
  return report;
}

std::optional<int> street_process(int argc, char** argv) {
  constexpr int arguments = 7;
  if (argc != arguments || std::string{argv[1]} != hidden_option) return {};
  try {
    print(measure_street({.buildings = std::atoi(argv[2]),
                          .location_tolerance = std::atof(argv[3]),
                          .steps_before = std::atoi(argv[4]),
                          .steps = std::atoi(argv[5]),
                          .parts = std::atoi(argv[6]) != 0}));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace moat::performance
