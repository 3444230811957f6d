// Outcomes as bytes, for messages between processes.
#pragma once

#include <string>
#include <vector>

#include "study/outcome.hpp"

namespace moat {

/// Every bit of an outcome, its number in front. Checksums in files of studies are made of these bytes: another layout
/// needs another format of the file.
std::string to_bytes(std::size_t number, const CaseOutcome& outcome);
/// The outcome; its number goes to `number`.
CaseOutcome from_bytes(const std::string& bytes, std::size_t& number);

/// The bytes of all cases of a study, in their order.
std::string to_bytes(const std::vector<CaseOutcome>& outcomes);
std::vector<CaseOutcome> outcomes_from_bytes(const std::string& bytes);

}  // namespace moat
