// The sections of a report.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/charts/tornado.hpp"
#include "output/files/case_result.hpp"

namespace moat::html {

/// Rows of impacts that are shown; impacts.csv has all.
inline constexpr std::size_t most_impacts = 100;
/// Rows of peaks of one quantity that are shown; of more places those with the largest values.
inline constexpr std::size_t most_places = 40;

/// Motion and size of the model in one line; the table of buildings (output/files/building_rows.hpp); then a card for
/// each of the largest impact force, if there is one, the number of impacts and the error of the energy balance. Values
/// carry their error bars; those that are not settled are shaded.
std::string summary_section(const CaseResult& result);

/// The verdict of the error bars and all warnings; empty without any.
std::string warning_section(const CaseResult& result);

/// The model to scale: the elevation of a model on a line, the plan of one in plan with the orbits of the corners and
/// the centre of mass of every base. The page's script moves it by the histories, with displacements and gaps drawn
/// larger by the same factor, so that bodies touch in the drawing when they touch in the model. Without script it shows
/// the model at rest. Empty without scene (CaseResult::scene) and for less than two rows of histories.
std::string drawing_section(const CaseResult& result);

/// The table of impacts, a sentence on each of its columns, and the loops (impact_loops()), each with the restitution
/// that its law asks for and the one that it delivered.
std::string impact_section(const CaseResult& result, const std::vector<Chart>& loops);

/// How peaks move with the parameters of contacts: charts, the number of impacts of every run, and notes; one sentence
/// where it was left out of a large run. Empty without contacts, and where it was not wanted.
std::string sensitivity_section(const ContactSensitivity& sensitivity, const std::vector<Tornado>& charts);

/// A table of peaks for each quantity, side by side where there is room, with errors and the method behind them.
std::string peak_section(const CaseResult& result);

/// Type, place, largest deformation and force of every bearing in plan that shares its place with others; empty
/// without.
std::string bearing_section(const CaseResult& result);

/// The largest ratio of demand over capacity, for every check and type of bearings; empty without checks.
std::string bearing_check_section(const CaseResult& result);

/// The smallest opening of every gap; empty without gaps.
std::string clearance_section(const CaseResult& result);

/// The residual displacement of every isolator; empty without isolators.
std::string section_at_the_end(const CaseResult& result);

/// Command line, script, version, commit and date.
std::string provenance_section(const Provenance& provenance);
/// All options of the analysis.
std::string analysis_section(const AnalysisFacts& analysis);
/// The motion with its file, scale factor and notes.
std::string motion_section(const MotionFacts& motion);
/// Nodes and elements with their parameters; of a long list the beginning.
std::string model_section(const ModelFacts& model);

}  // namespace moat::html
