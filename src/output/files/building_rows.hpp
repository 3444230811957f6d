// The most important numbers of every building, for the first screen of a report and the terminal.
#pragma once

#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// A number with its place. All texts are empty where the building has no such number.
struct BuildingCell {
  std::string value{};     ///< with unit, and an error that is visible: "13.4 +- 0.2 cm", "0.571 g", "closed, right"
  std::string more{};      ///< "5.600 +- 0.003 m/s^2"; of a margin its share of the clearance: "26.7 %"
  std::string where{};     ///< "storey 3 at 4.520 s"
  bool unsettled = false;  ///< Whether its error is above 1 %.
};

/// A table with a row for every building.
struct BuildingTable {
  /// A row has the cells of one building.
  struct Row {
    std::string name;                 ///< "building" where it has none
    std::vector<BuildingCell> cells;  ///< as many as headings
  };
  std::vector<std::string> headings;  ///< of the columns in which a building has a number
  std::vector<Row> rows;              ///< in the order of the result
};

/// Says whether gaps of a building closed, and where, and its least margin, negative where the sides indented each
/// other. It has the largest deformation of the isolators, the largest ratio of drift, or drift where storeys have no
/// heights, and the largest absolute acceleration of base and floors, in plan at their corners. At most 20 buildings.
BuildingTable building_table(const CaseResult& result);

/// The table as text. Empty without buildings.
std::string text_of(const BuildingTable& table);

}  // namespace moat
