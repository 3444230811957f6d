// The result of a run for programs.
#pragma once

#include <filesystem>

#include "output/files/case_result.hpp"

namespace moat {

/// Writes summary.json, all numbers in SI units, a value that is not finite and a text that is not known as null:
///
///     { "title", "moat_version",
///       "provenance": { "command_line", "script", "script_sha256", "options": { name: value as text }, "moat_version",
///                       "git_commit", "date" },
///       "motion": { "name", "peak_acceleration", "peak_velocity", "time_step", "duration",
///                   "file", "sha256", "scale_factor": in plan those of the first component,
///                   "components": [ { "name", "file", "sha256", "scale_factor" } ], one, or two in plan,
///                   "notes": [ ... ], "units": { name: unit } },
///       "model": { "nodes": [ { "name", "mass", "x", "height", "initial_displacement", "initial_velocity" } ],
///                  "node_units": { name: unit },
///                  "elements": [ { "name", "kind": "storey", "bearing", "gap" or "other", "law", "first", "second",
///                                  "first_point", "second_point": { "other", "share" }, only of an end between two
///                                  nodes: the share of the way to the other,
///                                  "first_position", "second_position": [ x, y ], only of a spring in plan,
///                                  "direction": [ x, y ], only if its force has one direction,
///                                  "parameters": { name: { "value", "unit" } } } ],
///                  "buildings": [ { "name", "base": null if fixed, "floors", "isolators" } ],
///                  only in plan: "plan_units": { name: unit },
///                  "diaphragms": [ { "name", "radius_of_gyration", "centre_of_mass": [ x, y ],
///                                    "outline": [ [ x, y ], ... ] } ],
///                  "corners": [ { "element", "corner", "edge", "position", "normal", "edge_begin", "edge_end": [ x, y
///                  ],
///                                 "clearance" } ] },
///       "analysis": { "integrator", "events", "error_bars", "contact_sensitivity",
///                     "options": { name as in TransientOptions and CaseOptions, or number of the scheme:
///                                  { "value", "unit" } } },
///       "periods": [ { "name", "value" } ], "assumptions": [ ... ],
///       "peaks": [ { "quantity", "where", "value": with its sign, "unit", "time", "error": estimated, same unit, null
///                    if not known, "side" } ],
///       "clearances": [ { "where", "clearance", "clearance_left": negative while indented, "time", "error" } ],
///       "isolators_at_the_end": [ { "where", "deformation", "residual_displacement", "time" } ],
///       "constant_quantities": [ names of quantities that never change ],
///       "error_bars": { "checked", "method", "companion", "companion_impacts",
///                       "companion_solver": { the fields of SolverStatistics }, "unsettled", "reason",
///                       "unsettled_peaks": [ { "quantity", "where" } ] }, three of them null if not checked,
///       "contact_sensitivity": null without contacts, else { "computed", "reason": null with runs, "unsettled":
///       whether
///                       the nominal run is, "rigid_walls", "impacts": of the nominal run,
///                       "changes": [ { "parameter": "stiffness", "restitution", "clearance" or "soil",
///                                      "factor", or of the restitution "difference" and "restitutions": those used,
///                                      "places": null for all, "impacts", "contact": { place: "same", "fewer", "more",
///                                      "appears" or "vanishes" }, "failure": null with results } ],
///                       "peaks": [ { "quantity", "where", "unit", "value", "error", "changed": [ one per change, with
///                                  its sign ] } ], "unchanged_laws": [ names of laws ] },
///       "impacts": number of impacts,
///       "impact_table": [ { "where", "start", "duration", "approach_speed", "largest_indentation", "largest_force",
///                           "rebound_ratio", "restitution", "energy_lost" } ],
///       "energy": { "unit": "J", the fields of EnergyBalance }, "warnings": [ ... ],
///       "solver": { the fields of SolverStatistics } }
///
/// Throws FileError where the file cannot be written.
void write_summary_json(const CaseResult& result, const std::filesystem::path& path);

}  // namespace moat
