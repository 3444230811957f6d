// Columns of histories as series of charts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// The columns of a quantity that hold values.
std::vector<const Column*> columns_of(const Table& table, std::string_view quantity);

/// That of a place; null if there is none.
const Column* column_of(const std::vector<const Column*>& columns, const std::string& where);

/// Base and top of up to three buildings, each once, in a table of the result. The last column if the model has no
/// building.
std::vector<const Column*> bases_and_tops(const CaseResult& result, const Table& table, std::string_view quantity);

/// The values in their engineering unit.
std::vector<double> in_engineering_unit(const Column& column);

/// "displacement [cm]".
std::string axis_label(std::string_view quantity, std::string_view si_unit);

}  // namespace moat
