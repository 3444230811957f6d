// The progress of a study for programs. Included by .cpp files alone.
#pragma once

#include <nlohmann/json.hpp>

#include "study/result.hpp"

namespace moat {

/// How many cases there are, and how many are in each state.
inline nlohmann::ordered_json counts_of(const StudyResult& result) {
  return {{"cases", result.cases().count()},
          {"done", result.count(CaseState::done)},
          {"not_converged", result.count(CaseState::not_converged)},
          {"failed", result.count(CaseState::failed)},
          {"open", result.count(CaseState::open)}};
}

}  // namespace moat
