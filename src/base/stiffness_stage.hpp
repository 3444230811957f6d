// Which branch of a yielding element counts in a linear (modal) analysis.
#pragma once

namespace moat {

/// The branch of a law whose stiffness is asked for.
enum class StiffnessStage {
  initial,     ///< before first yield
  post_yield,  ///< on the branch after yield, for elements that have one
  joined,      ///< 1 N/m for every element: the matrix shows which motions the elements resist
};

}  // namespace moat
