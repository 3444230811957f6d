// An outcome as bytes, for messages between processes and checksums.
#pragma once

#include <string>
#include <string_view>

#include "study/outcome.hpp"

namespace moat {

/// Every bit of the outcome, as CBOR; NaN has one form. Checksums in files of studies are made of these bytes: another
/// layout needs another format of the file.
std::string to_bytes(const CaseOutcome& outcome);

/// The outcome with these bytes.
CaseOutcome from_bytes(std::string_view bytes);

}  // namespace moat
