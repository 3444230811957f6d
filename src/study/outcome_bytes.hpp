// Outcomes as bytes, for messages between processes and checksums.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/outcome.hpp"

namespace moat {

/// Every bit of the outcomes, as CBOR; NaN has one form. Checksums in files of studies are made of these bytes: another
/// layout needs another format of the file.
std::string to_bytes(const std::vector<CaseOutcome>& outcomes);

/// The outcomes with these bytes.
std::vector<CaseOutcome> from_bytes(std::string_view bytes);

}  // namespace moat
