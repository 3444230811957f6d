// A case and the state in which it ended.
#pragma once

#include "analyses/case/case_run.hpp"

namespace moat::testing {

/// The result of a case, and its state at the end.
struct EndedCase {
  CaseResult result;
  AnalysisState state;
};
inline EndedCase run_to_end(const Model& model, const GroundMotion& motion, const CaseOptions& options = {}) {
  CaseRun run{model, motion, options};
  run.run();
  return {run.result(), run.transient().state()};
}

}  // namespace moat::testing
