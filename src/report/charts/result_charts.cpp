#include "report/charts/result_charts.hpp"

#include <set>

#include "output/files/csv_writer.hpp"
#include "output/files/file_io.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
ResultCharts result_charts(const CaseResult& result) {
  ResultCharts charts{.histories = history_charts(result),
                      .floor_profiles = floor_profiles(result),
                      .isolator_loops = isolator_loops(result),
                      .impact_loops = impact_loops(result.impacts),
                      .energy = {},
                      .floor_spectra = floor_spectra(result),
                      .orbits = orbit_charts(result),
                      .sensitivity = sensitivity_charts(result.contact_sensitivity)};
  if (auto energy = energy_chart(result)) charts.energy.push_back(std::move(*energy));
  return charts;
}

std::vector<const Chart*> ResultCharts::all() const {
  std::vector<const Chart*> list;
  for (const std::vector<Chart>* group :
       {&histories, &floor_profiles, &isolator_loops, &impact_loops, &energy, &floor_spectra, &orbits})
    for (const Chart& chart : *group) list.push_back(&chart);
  return list;
}

void write_charts(const ResultCharts& charts, const std::filesystem::path& folder) {
  if (!charts.histories.empty()) write_svg(charts.histories, folder / results_file::charts);
  const std::filesystem::path singles = folder / results_file::charts_folder;
  std::set<std::string> taken;
  const auto write = [&](const auto& chart, const auto& write_picture) {
    if (taken.empty()) std::filesystem::create_directories(singles);
    const std::string title = file_name_of(chart.title);
    std::string name = title;
    for (int number = 2; !taken.insert(name).second; ++number) name = title + "_" + std::to_string(number);
    write_picture(singles / (name + ".svg"));
    write_csv(table_of(chart), singles / (name + ".csv"));
  };
  for (const Chart* chart : charts.all())
    write(*chart, [&](const std::filesystem::path& path) { write_svg(*chart, path); });
  for (const Tornado& chart : charts.sensitivity)
    write(chart, [&](const std::filesystem::path& path) { write_file(path, svg_text(chart)); });
}

}  // namespace moat
