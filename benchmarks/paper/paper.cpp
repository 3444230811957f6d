// Computes the tables and figures of the paper and puts them on one page. Called by ./moat bench paper.
#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "documentation_section.hpp"
#include "paper/exhibit.hpp"
#include "paper/records.hpp"

namespace {

using namespace moat;
using namespace moat::paper;

struct Entry {
  const char *id, *title, *source;
  bool needs_records;
  void (*show)(Exhibit& exhibit);
};

constexpr const char* sweeps = "figures_7_to_11";
/// In the order of the page.
constexpr std::array<Entry, 11> entries{
    {{"table1", "Table 1: restitution of a pendulum against a wall", "table1", false, show_table1},
     {"table2", "Table 2: peaks for five impact laws", "table2", true, show_table2},
     {"table3_fig6", "Table 3 and Figure 6: ground motions", "table3_fig6", true, show_table3_fig6},
     {"fig4", "Figure 4: histories", "figures_4_and_5", true, show_fig4},
     {"fig5", "Figure 5: peaks over the height", "figures_4_and_5", true, show_fig5},
     {"fig7", "Figure 7: isolation period", sweeps, true, show_fig7},
     {"fig8", "Figure 8: yield displacement", sweeps, true, show_fig8},
     {"fig9", "Figure 9: gap", sweeps, true, show_fig9},
     {"fig10", "Figure 10: number of storeys", sweeps, true, show_fig10},
     {"fig11", "Figure 11: impact stiffness", sweeps, true, show_fig11},
     {"pulse", "Synthetic near-fault pulse", sweeps, false, show_pulse}}};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int run_all(const std::filesystem::path& folder, const std::string& only, bool coarse, bool write_docs) {
  const auto start = std::chrono::steady_clock::now();
  const std::string missing = missing_records();
  if (write_docs && !missing.empty())
    throw InputError{"--write-docs needs the records: documentation without them would be empty. " + missing};
  if (write_docs && (coarse || !only.empty())) throw InputError{"--write-docs excludes --coarse and --only."};
  std::filesystem::create_directories(folder);

  std::vector<Exhibit> exhibits;
  bool failed = false;
  for (const auto& [id, title, source, needs_records, show] : entries) {
    if (!only.empty() && only != id) continue;
    const auto started = std::chrono::steady_clock::now();
    Exhibit& exhibit = exhibits.emplace_back(Exhibit{folder, id, title, source, coarse});
    try {
      if (needs_records && !missing.empty())
        exhibit.skipped = missing;
      else
        show(exhibit);
    } catch (const std::exception& error) {
      exhibit.failure = error.what();
      failed = true;
      std::fprintf(stderr, "moat: error: %s: %s\n", id, error.what());
    }
    std::printf("%-12s %5.1f s\n", id, seconds_since(started));
    std::fflush(stdout);
  }
  write_page(folder, exhibits);
  if (write_docs && !failed) replace_section(MOAT_VERIFICATION, "paper", documentation(exhibits));

  const Totals totals = totals_of(exhibits);
  if (totals.skipped > 0)
    std::printf("\nSkipped: %zu of %zu tables and figures. %s\n", totals.skipped, exhibits.size(), missing.c_str());
  std::printf("\nPage: %s   (%.1f s)\n%s\n", (folder / "index.html").c_str(), seconds_since(start),
              totals.in_words().c_str());
  return failed || totals.held != totals.asserted ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Tables and figures of Zhao, Liu & Li (2017), side by side with the printed numbers",
               "./moat bench paper"};
  std::string folder = "results/paper", only;
  bool coarse = false, write_docs = false;
  app.add_option("--out", folder, "folder for the page, figures and tables of numbers")->capture_default_str();
  std::vector<std::string> ids;
  for (const Entry& entry : entries) ids.emplace_back(entry.id);
  app.add_option("--only", only, "one table or figure alone")->check(CLI::IsMember(ids));
  app.add_flag("--write-docs", write_docs, "also bring docs/verification/paper.md up to date");
  app.add_flag("--coarse", coarse, "five points per curve, to try the page");
  app.footer(
      "Recorded motions are looked for in the folder MOAT_RECORDS; exhibits that need them are skipped without.\n"
      "Exit code: 0 if all that is asserted holds, 1 if not or after an error, 2 for wrong usage.");
  return run_command(app, "./moat bench paper", argc, argv, [&] { return run_all(folder, only, coarse, write_docs); });
}
