// A design sheet as a page to print and to sign.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "design/design_sheet.hpp"

namespace moat {

/// A whole page that needs nothing else: for each sheet the gap and all rules that are not kept, the given numbers, and
/// a table of all lines. Each prints on A4 pages of its own: lines of 12 storeys fit on one. Recalled clauses are
/// marked; the value that governs is bold.
std::string sheet_page(const std::vector<DesignSheet>& sheets);

/// A formula of a sheet as HTML: `D_TM` and `T^2` with index and exponent, beta, lambda, pi, sqrt and >= as signs.
std::string formula_as_html(const std::string& formula);

/// Writes the page. Throws FileError where the file cannot be written.
void write_design_sheets(const std::vector<DesignSheet>& sheets, const std::filesystem::path& file);

}  // namespace moat
