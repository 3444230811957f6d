// All charts of a run, for the report and as files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/charts/tornado.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Buildings of a chart at most, so that it stays legible.
inline constexpr std::size_t most_charted_buildings = 3;
/// Impacts with a chart at most.
inline constexpr std::size_t most_impact_loops = 12;

/// Histories of up to so many rows are drawn with all of them. Of longer ones a chart has about so many at most: those
/// where one of its curves is smallest or largest in one of many equal pieces of time, so that every peak stays. Those
/// of the script of a report, which needs constant intervals, are thinned to so many.
inline constexpr std::size_t most_rows_of_charts = 20'000;

/// Displacement and absolute acceleration of base and top of up to three buildings, and the forces of gaps that
/// closed (of more than seven the largest), over time: those of them whose columns `result.histories` holds. The last
/// node where the model has no building. Then a chart for every quantity that recorders offered. stride > 0: every
/// stride-th row; 0: those of a picture (most_rows_of_charts). Throws InputError where columns differ in length.
std::vector<Chart> history_charts(const CaseResult& result, std::size_t stride = 0);

/// A chart for each quantity that the floors or storeys of a building have peaks of: displacement, drift, absolute
/// acceleration and storey shear; in plan their resultants, the drift at the corners. A curve for each of up to three
/// buildings of at least two levels, over the height of the floors; values of storeys stand at their middle. Where the
/// nodes have no heights, levels count from 0.
std::vector<Chart> floor_profiles(const CaseResult& result);

/// On a line a chart for each of up to three isolated buildings, with a loop for every isolator. In plan one for the
/// bearing with the largest deformation, with a loop for each component. Isolators without columns for force and
/// deformation are left out. Throws InputError where columns differ in length.
std::vector<Chart> isolator_loops(const CaseResult& result);

/// A chart for every impact, in order of time; of more than `most_impact_loops` those with the largest forces.
std::vector<Chart> impact_loops(const std::vector<Impact>& impacts);
/// The name of an impact: "2.659 s, moat left". The time comes first, so that a shortened title keeps it.
std::string title_of(const Impact& impact);

/// Dissipated energies, strain and kinetic energy on top of each other, and the input as a line: the stack reaches it
/// but for errors. None where the histories have no energies.
std::optional<Chart> energy_chart(const CaseResult& result);

/// Pseudo-acceleration spectra of floors (CaseResult::floor_spectra), in plan at centres of mass: a chart for each
/// direction and damping.
std::vector<Chart> floor_spectra(const CaseResult& result);

/// For every base of a model in plan its displacement along y over that along x, at the centre of mass and at every
/// corner of the outline. None on a line and without histories.
std::vector<Chart> orbit_charts(const CaseResult& result);

/// How the largest peaks move with the parameters of contacts (largest_changed_peaks()): a chart for each, the
/// parameter that moves it most on top. None without runs with changed contacts.
std::vector<Tornado> sensitivity_charts(const ContactSensitivity& sensitivity);

/// All charts of a run.
struct ResultCharts {
  /// Charts of one kind each.
  std::vector<Chart> histories, floor_profiles, isolator_loops, impact_loops, energy, floor_spectra, orbits;
  /// Tornado charts of the contacts.
  std::vector<Tornado> sensitivity{};

  /// Returns all of them with curves, in this order.
  [[nodiscard]] std::vector<const Chart*> all() const;
};

/// Throws InputError where columns of the histories differ in length.
ResultCharts result_charts(const CaseResult& result);

/// For papers: `charts/<title>.svg` and `charts/<title>.csv`, its numbers, for every chart, and
/// charts.svg with all histories. Names of files have small letters, digits and underscores. Throws FileError.
void write_charts(const ResultCharts& charts, const std::filesystem::path& folder);

}  // namespace moat
