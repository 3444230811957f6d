// The smallest gap that nothing closes under one motion.
#pragma once

#include <functional>

#include "analyses/questions/study.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"

namespace moat {

/// Where smallest_gap() looks.
struct GapSearch {
  Length first = 50 * units::cm;       ///< > 0, tried first
  Length largest = 10 * units::m;      ///< >= first; doubled gaps up to this are tried
  Length accuracy = 0.01 * units::mm;  ///< > 0
};

/// The answer of smallest_gap().
struct SmallestGap {
  /// Without contact, at most GapSearch::accuracy above one with contact; if `beyond`, GapSearch::largest.
  Length gap{};
  /// Even the largest gap is closed: the smallest gap is larger than `gap`, and not known.
  bool beyond = false;
};

/// The gap at which the closest approach is zero: the root of clearance_left(gap), the smallest opening of all gaps
/// over time where they have this clearance at rest, negative where they are indented. Without contact the motion does
/// not depend on the gap, so that one analysis with a wide gap gives the root and a second confirms it. Otherwise the
/// root is bracketed and found by the method of Alefeld, Potra and Shi.
///
/// Throws InputError for a parameter outside its range.
SmallestGap smallest_gap(const std::function<Length(Length gap)>& clearance_left, const GapSearch& search = {});

/// Finds the smallest gap of a model, as a case of a study, from the smallest `clearance_left` of all its gaps. The
/// result is `smallest_gap` [m]. Where even the largest gap is closed, it is infinite, and a second result,
/// `smallest_gap_above` [m], is that largest gap: the case is done, and known to need more.
///
///     const StudyResult study = script.study({record_axis("record", records)}, [&](const StudyCase& each) {
///       return smallest_gap_of([&](Length gap) { ... return StudyModel{model, records[each.position("record")]}; });
///     });
///     const GapDemand demand{study};
///     demand.gap(0.1);    // pounding is less than 10 % probable
StudyRecord smallest_gap_of(const std::function<StudyModel(Length gap)>& make, const GapSearch& search = {},
                            const TransientOptions& options = {});

}  // namespace moat
