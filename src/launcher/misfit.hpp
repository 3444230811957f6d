// Values that do not fit their field, found in the source.
#pragma once

#include <string>

#include "launcher/designated_list.hpp"

namespace moat::launcher {

/// "PerStorey<Mass>" -> "Mass"
std::string type_of_item(const std::string& type);

/// "field pulse_period of NearFaultPulse is a time [s], but 1.3 is a number without unit; give it a unit, as in
/// 1.3 * s", for a field of `type` that is declared as `declared`. Empty where the value fits, and where it is no
/// product of numbers and units, nor a list of such.
std::string misfit_of_field(const NamedField& field, const std::string& type, const std::string& declared);

}  // namespace moat::launcher
