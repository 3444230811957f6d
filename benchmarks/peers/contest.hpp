// Both programs on the same models, in turns.
#pragma once

#include <string>
#include <vector>

#include "measuring/record.hpp"
#include "peers/building.hpp"
#include "peers/opensees.hpp"

namespace moat::peers {

/// Holds the sentences of the summary on a model.
struct Outcome {
  std::string model;
  performance::Spread textbook{}, best{};  ///< OpenSees' time over moat's
  std::string best_setting{};              ///< of OpenSees
  std::string remark{};                    ///< where the times are not of equal errors, or are missing
};

struct ContestOptions {
  std::string section;
  int rounds = 9;
  bool finer = false;                        ///< steps of OpenSees down to an 80th of the interval
  std::optional<double> textbook{}, best{};  ///< targets of the ratios, at least
};

/// Reads off the time of an error of 0.1 % for moat, adaptive and automatic, and for OpenSees with every setting, and
/// the errors of OpenSees' steps. Ratios are those to moat adaptive, the default. Pendulums are computed as
/// singleFPBearing too.
std::vector<Outcome> compare(performance::Record& record, const OpenSees& opensees, const std::vector<Case>& cases,
                             const ContestOptions& options);

/// The ratios of all models, and which program is faster.
void summarise(performance::Record& record, const std::vector<Outcome>& outcomes);

}  // namespace moat::peers
