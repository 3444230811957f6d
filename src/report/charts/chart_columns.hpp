// Columns of histories as series of charts and motions of drawings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// The columns of a quantity that hold values.
std::vector<const Column*> columns_of(const Table& table, std::string_view quantity);

/// The column of a quantity at a place; null if there is none that holds values.
const Column* column_of(const Table& table, std::string_view quantity, std::string_view where);

/// Base and top of up to three buildings, each once, in a table of the result. The last column if the model has no
/// building.
std::vector<const Column*> bases_and_tops(const CaseResult& result, const Table& table, std::string_view quantity);

/// Numbers of rows, from 0.
using ChartRows = std::vector<std::size_t>;

/// The values in their engineering unit: all, or those of these rows.
std::vector<double> in_engineering_unit(const Column& column, const ChartRows* rows = nullptr);

/// The second scale of an axis whose values have the engineering unit of this one: g of accelerations.
std::optional<SecondUnit> second_scale(std::string_view si_unit, bool of_x = false);

/// "displacement [cm]".
std::string axis_label(std::string_view quantity, std::string_view si_unit);

/// The displacement of a node is `factor` times the column.
struct NodeMotion {
  const Column* column = nullptr;  ///< null: the histories lack it
  double factor = 1.0;             ///< m for a rotation, the gyration; else 1
};

/// One for every node of `result.model`, in its order. The third degree of freedom of a diaphragm is its rotation times
/// its gyration, m.
std::vector<NodeMotion> motions_of_nodes(const CaseResult& result);

}  // namespace moat
