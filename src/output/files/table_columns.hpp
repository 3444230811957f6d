// How the columns of a table are called in files.
#pragma once

#include <string>

#include "output/files/table.hpp"

namespace moat {

/// `quantity [unit] where`, for example `displacement [m] base`; `time [s]` where there is no place.
std::string column_name(const Column& column);

/// Throws InputError naming the first column whose length differs from that of the first one.
void require_equal_lengths(const Table& table);

}  // namespace moat
