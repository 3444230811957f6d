#include "app/results.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <string_view>
#include <system_error>

#include "base/text/number_format.hpp"
#include "output/files/building_rows.hpp"
#include "output/files/csv_writer.hpp"
#include "output/files/peak_table.hpp"
#include "output/files/results_folder.hpp"
#include "output/files/sensitivity_table.hpp"
#include "output/files/summary.hpp"
#include "output/peaks/peak_groups.hpp"
#include "output/recorders/energy_columns.hpp"
#include "output/vtk/vtk_files.hpp"
#include "report/charts/result_charts.hpp"
#include "report/report.hpp"

namespace moat {

void write_results(const CaseResult& result, const std::filesystem::path& folder, const WritingProgress& progress) {
  constexpr double parts = 6.0;
  double done = 0.0;
  const auto written = [&](const std::string& part) {
    if (progress) progress(++done, parts, " (" + part + ")");
  };
  // The longest file and the many small ones are written beside the others. Without a free thread they are written at
  // get().
  const auto beside = [](auto write) { return std::async(std::launch::async | std::launch::deferred, write); };
  std::future<void> histories = beside([&] { write_csv(result.histories, folder / results_file::histories_csv); });
  const ResultCharts charts = result_charts(result);
  std::future<void> files_of_charts = beside([&] { write_charts(charts, folder); });
  write_csv(result.impacts, folder / results_file::impacts);
  write_peaks_csv(result, folder / results_file::peaks);
  write_participating_masses_csv(result, folder / results_file::participating_masses);
  write_bearing_checks_csv(result, folder / results_file::bearing_checks);
  write_floor_spectra_csv(result, folder / results_file::floor_spectra);
  written(results_file::impacts);
  vtk_files().write_table(result.histories, folder / results_file::histories_vtt);
  written(results_file::histories_vtt);
  write_report_html(result, charts, folder);
  written(results_file::report);
  files_of_charts.get();
  written("charts");
  histories.get();
  written(results_file::histories_csv);
  write_summary_json(result, folder / results_file::summary);
  written(results_file::summary);
}

std::string keep_results(const CaseResult& result, const std::filesystem::path& folder) {
  using namespace results_file;
  std::error_code error;
  for (const char* name : {frames_folder, charts_folder}) std::filesystem::remove_all(folder / name, error);
  for (const std::string_view name : all_names)
    if (name != unfinished && name != checkpoint) std::filesystem::remove(folder / name, error);
  std::string kept, missing = "frames";
  const auto keep = [&](const char* name, const std::function<void()>& write) {
    try {
      write();
      kept += (kept.empty() ? "" : ", ") + std::string{name};
    } catch (const std::exception&) {
      for (const char* one_of_many : {charts_folder, results_file::charts})
        std::filesystem::remove_all(folder / one_of_many, error);
      missing += ", " + std::string{name};
    }
  };
  keep(summary, [&] { write_summary_json(result, folder / summary); });
  keep(peaks, [&] { write_peaks_csv(result, folder / peaks); });
  keep(impacts, [&] { write_csv(result.impacts, folder / impacts); });
  keep(histories_csv, [&] { write_csv(result.histories, folder / histories_csv); });
  keep(report, [&] { write_report_html(result, result_charts(result), folder); });
  keep(histories_vtt, [&] { vtk_files().write_table(result.histories, folder / histories_vtt); });
  keep(charts_folder, [&] { write_charts(result_charts(result), folder); });
  return "Kept: " + (kept.empty() ? "nothing" : kept) + ". Left out: " + missing + ".";
}

namespace {

std::string count_of(long number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

std::string error_bar_line(const ErrorBars& bars) {
  if (!bars.checked) return bars.companion.empty() ? "" : "\n" + bars.companion + "\n";
  return "\n+- estimated numerical error, from a second run with finer steps (" +
         count_of(static_cast<long>(bars.companion_impacts), "impact") + ", " +
         std::to_string(bars.companion_solver.accepted_steps) + " steps, " +
         to_significant(bars.companion_solver.cpu_seconds, 3) + " s)\n";
}

std::string period_lines(const std::vector<NamedPeriod>& periods) {
  if (periods.empty()) return "";
  std::size_t width = 0;
  for (const NamedPeriod& period : periods) width = std::max(width, period.name.size());
  std::string text = "\nperiods [s]\n";
  for (const NamedPeriod& period : periods)
    text += "  " + period.name + std::string(width - period.name.size(), ' ') + "  " + to_fixed(period.value, 3) + "\n";
  return text;
}

std::string energy_lines(const EnergyBalance& energy) {
  std::string text = "\nenergy [kJ]\n ";
  const char* before = " ";
  for (const EnergyColumn& column : energy_columns(energy.in_plan, energy.weights_change)) {
    text += before + std::string{column.name} + " " + to_significant(energy.*column.value / 1e3, 4);
    const bool is_input = column.value == &EnergyBalance::input && !energy.weights_change;
    before = is_input || column.value == &EnergyBalance::weight_work ? " = " : " + ";
  }
  return text + " + error " + to_significant((energy.integration_error - energy.equation_residual) / 1e3, 2) + "\n";
}

}  // namespace

std::string terminal_summary(const CaseResult& result) {
  const std::string buildings = text_of(building_table(result));
  return (buildings.empty() ? "" : "\n" + buildings) + period_lines(result.periods) + "\n" + peak_table(result) +
         clearance_table(result) + table_at_the_end(residual_displacements(result.histories)) +
         error_bar_line(result.error_bars) + sensitivity_table(result.contact_sensitivity, result.solver.cpu_seconds) +
         energy_lines(result.energy) + "\n" + count_of(static_cast<long>(result.impacts.size()), "impact") + ", " +
         std::to_string(result.solver.accepted_steps) + " steps, " + std::to_string(result.solver.newton_iterations) +
         " Newton iterations, " + to_significant(result.solver.cpu_seconds, 3) + " s of processor time\n";
}

}  // namespace moat
