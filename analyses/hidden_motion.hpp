// Motion of the ground that a step over several samples would hide.
#pragma once

#include <vector>

#include "analyses/step_equations.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Peaks and changes of regime are looked for on smooth paths between the ends of a step. If a step spans several
/// samples, displacements relative to the ground differ from such paths by the bumps of the ground (GroundSpan). A step
/// hides motion where a bump is not negligible (1e-4) beside the displacement of a building, or is more than half the
/// margin of an element. The displacement is the largest of its nodes at the starts of the steps over several samples
/// so far. A building here is a set of nodes that elements other than gaps connect; the one with the smallest
/// displacement counts.
class HiddenMotion {
 public:
  /// The model must be complete.
  explicit HiddenMotion(const Model& model);

  /// Notes the displacements at the start of the step, and returns whether the step to the trial state hides motion.
  /// `margin` is the smallest one of an element at the ends of the step, m.
  [[nodiscard]] bool in(const StepTask& step, const Model& model, double margin);
  /// Whether such a margin, m, and not the size of the displacements, decides which bumps are hidden motion. True as
  /// long as nothing moved.
  [[nodiscard]] bool is_close(double margin) const {
    const double bump = negligible_bump();
    return bump == 0.0 || share_of_margin * margin <= bump;
  }

 private:
  static constexpr double negligible = 1e-4;  // share of a displacement
  static constexpr double share_of_margin = 0.5;

  // m
  [[nodiscard]] double negligible_bump() const { return negligible * largest_.minCoeff(); }

  std::vector<int> building_;  // of every node
  Vector largest_;             // displacement of every building, m
};

}  // namespace moat
