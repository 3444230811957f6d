#include "app/results.hpp"

#include <algorithm>
#include <cstdio>

#include "output/csv_writer.hpp"
#include "output/report.hpp"
#include "output/result_charts.hpp"
#include "output/results_folder.hpp"
#include "output/summary.hpp"
#include "output/vtk_table.hpp"

namespace moat {

void write_results(const CaseResult& result, const std::filesystem::path& folder) {
  write_summary_json(result, folder / results_file::summary);
  write_csv(result.impacts, folder / results_file::impacts);
  write_csv(result.histories, folder / results_file::histories_csv);
  write_vtt(result.histories, folder / results_file::histories_vtt);
  write_report_html(result, folder);
  if (const auto charts = history_charts(result); !charts.empty()) write_svg(charts, folder / results_file::charts);
}

namespace {

std::string error_bar_line(const ErrorBars& bars) {
  if (!bars.checked) return bars.companion.empty() ? "" : "\n" + bars.companion + "\n";
  char line[160];
  std::snprintf(
      line, sizeof line,
      "\n+- estimated numerical error, from a second run with finer steps (%zu impact%s, %ld steps, %.3g s)\n",
      bars.companion_impacts, bars.companion_impacts == 1 ? "" : "s", bars.companion_solver.accepted_steps,
      bars.companion_solver.cpu_seconds);
  return line;
}

}  // namespace

std::string terminal_summary(const CaseResult& result) {
  std::string text;
  char line[160];
  if (!result.periods.empty()) text += "\nperiods [s]\n";
  std::size_t width = 0;
  for (const NamedPeriod& period : result.periods) width = std::max(width, period.name.size());
  for (const NamedPeriod& period : result.periods) {
    std::snprintf(line, sizeof line, "  %.3f\n", period.value);
    text += "  " + period.name + std::string(width - period.name.size(), ' ') + line;
  }
  text += "\n" + peak_table(result) + error_bar_line(result.error_bars);
  const EnergyBalance& energy = result.energy;
  std::snprintf(
      line, sizeof line, "\nenergy [kJ]\n  input %.4g = kinetic %.4g + strain %.4g + viscous %.4g + hysteretic %.4g",
      energy.input / 1e3, energy.kinetic / 1e3, energy.strain / 1e3, energy.viscous / 1e3, energy.hysteretic / 1e3);
  text += line;
  std::snprintf(line, sizeof line, " + impact %.4g + error %.2g\n", energy.impact / 1e3,
                (energy.integration_error - energy.equation_residual) / 1e3);
  text += line;
  std::snprintf(line, sizeof line, "\n%zu impact%s, %ld steps, %ld Newton iterations, %.3g s of processor time\n",
                result.impacts.size(), result.impacts.size() == 1 ? "" : "s", result.solver.accepted_steps,
                result.solver.newton_iterations, result.solver.cpu_seconds);
  return text + line;
}

}  // namespace moat
