// Runs all scripts of this folder and puts their output on one page. Called by ./moat bench paper.
#include <spawn.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "documentation_section.hpp"
#include "paper/page.hpp"
#include "paper/records.hpp"

extern char** environ;

namespace {

using namespace moat;
using namespace moat::paper;

/// Programs and the names of their results, in the order of the page.
constexpr std::array<std::array<const char*, 2>, 11> scripts{{{"table1", "table1"},
                                                              {"table2", "table2"},
                                                              {"table3_fig6", "table3_fig6"},
                                                              {"fig4", "fig4"},
                                                              {"fig5", "fig5"},
                                                              {"fig7_isolation_period", "fig7"},
                                                              {"fig8_yield_displacement", "fig8"},
                                                              {"fig9_gap", "fig9"},
                                                              {"fig10_storeys", "fig10"},
                                                              {"fig11_impact_stiffness", "fig11"},
                                                              {"pulse", "pulse"}}};

/// Runs a program to its end; returns a description of the failure, or nothing if it ended by itself.
std::string run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  if (const int error = posix_spawn(&child, program.c_str(), nullptr, nullptr, pointers.data(), environ); error != 0)
    return program.string() + ": cannot be started (" + std::strerror(error) + ").";
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return program.string() + ": was lost.";
  return WIFEXITED(status) ? "" : program.string() + ": ended by signal " + std::to_string(WTERMSIG(status)) + ".";
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int run_all(const std::filesystem::path& folder, const std::filesystem::path& programs, bool coarse, bool write_docs) {
  const auto start = std::chrono::steady_clock::now();
  const std::string missing = missing_records();
  if (write_docs && !missing.empty())
    throw InputError{"--write-docs needs the records: documentation without them would be empty. " + missing};
  if (write_docs && coarse) throw InputError{"--write-docs and --coarse exclude each other."};
  std::filesystem::create_directories(folder);

  std::vector<ScriptRun> runs;
  bool failed = false;
  for (const auto& [program, id] : scripts) {
    const auto started = std::chrono::steady_clock::now();
    ScriptRun& run = runs.emplace_back(ScriptRun{.id = id, .program = program, .failure = {}});
    const std::filesystem::path results = folder / (run.id + ".json");
    std::filesystem::remove(results);  // one of an earlier run must not stand in
    std::vector<std::string> arguments{"--out", folder.string()};
    if (coarse) arguments.emplace_back("--coarse");
    run.failure = run_program(programs / program, arguments);
    if (run.failure.empty() && !std::filesystem::exists(results)) run.failure = run.program + " ended without results.";
    failed = failed || !run.failure.empty();
    if (!run.failure.empty()) std::fprintf(stderr, "moat: error: %s\n", run.failure.c_str());
    std::printf("%-24s %5.1f s\n", program, seconds_since(started));
    std::fflush(stdout);
  }
  write_page(folder, runs);
  if (write_docs && !failed) replace_section(MOAT_VERIFICATION, "paper", documentation(folder, runs));

  const Totals totals = totals_of(folder, runs);
  if (totals.skipped > 0)
    std::printf("\nSkipped: %zu of %zu tables and figures. %s\n", totals.skipped, scripts.size(), missing.c_str());
  std::printf("\nPage: %s   (%.1f s)\n", (folder / "index.html").c_str(), seconds_since(start));
  std::printf("%zu asserted, %zu held, %zu reported\n", totals.asserted, totals.held, totals.reported);
  return failed || totals.held != totals.asserted ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int exit_usage = 2;
  CLI::App app{"Tables and figures of Zhao, Liu & Li (2017), side by side with the printed numbers"};
  app.name("./moat bench paper");
  std::string folder = "results/paper";
  bool coarse = false, write_docs = false;
  app.add_option("--out", folder, "folder for the page, figures and tables of numbers")->capture_default_str();
  app.add_flag("--write-docs", write_docs, "also bring docs/verification.md up to date");
  app.add_flag("--coarse", coarse, "five points per curve, to try the page");
  app.footer(
      "Recorded motions are looked for in the folder MOAT_RECORDS; exhibits that need them are skipped without.\n"
      "Exit code: 0 if all that is asserted holds, 1 if not or after an error, 2 for wrong usage.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  try {
    const std::filesystem::path programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    return run_all(folder, programs, coarse, write_docs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
}
