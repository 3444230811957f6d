// Outcomes as bytes, for messages between processes and checksums.
#pragma once

#include <cstddef>
#include <string>

#include "study/outcome.hpp"

namespace moat {

/// Every bit of an outcome, its number in front. Checksums in files of studies are made of these bytes: another layout
/// needs another format of the file.
std::string to_bytes(std::size_t number, CaseOutcome outcome);

/// The outcome whose bytes begin at the position `at`, which moves behind them.
CaseOutcome from_bytes(const std::string& bytes, std::size_t& at);

}  // namespace moat
