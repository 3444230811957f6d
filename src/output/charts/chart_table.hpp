// The numbers of a chart as a table.
#pragma once

#include "output/charts/chart.hpp"
#include "output/files/table.hpp"

namespace moat {

/// A column of x and one of y for every series, of a band one for each edge; x once where all series share it. Shorter
/// series end with values that are not a number. Quantity and unit come from the labels of the axes: "displacement
/// [cm]".
Table table_of(const Chart& chart);

}  // namespace moat
