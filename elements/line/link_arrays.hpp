// The part of a block of links that is the same for every law.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "elements/line/link_motion.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Names, motion and forces of the links of a block, one entry per link. None of it depends on their law. It is
/// compiled in the library, so that a block of a script's own law compiles faster.
class LinkArrays {
 public:
  LinkArrays();
  LinkArrays(const LinkArrays& other);             ///< A copy.
  LinkArrays& operator=(const LinkArrays& other);  ///< A copy.
  ~LinkArrays();

 protected:
  /// Which of the arrays a block needs.
  struct Needs {
    bool tangents;  ///< of every link
    bool start;     ///< the motion at the last commit
    bool before;    ///< and that at the one before
  };

  /// Appends a link; its results follow with resize().
  void append(ElementInfo&& info);
  /// Room for the results of all links; new entries are zero.
  void resize(Needs needs);
  /// The motion now becomes that at the last commit.
  void start_motion();
  /// The stiffnesses now become those at the last commit.
  void keep_stiffnesses();

  std::deque<ElementInfo> infos_;               ///< as added; names do not move when links are added
  std::vector<double> offsets_;                 ///< m, of the deformation; empty where all are zero
  LinkMotion now_;                              ///< at the last evaluate()
  LinkMotion start_, before_;                   ///< at the last commit, and at the one before
  double last_step_ = 0.0;                      ///< between them, s
  double step_ = 0.0;                           ///< from the committed to the trial state, s
  std::vector<double> forces_, force_rates_;    ///< of the last evaluate(), N, N/s
  std::vector<double> stiffnesses_, dampings_;  ///< of the last evaluate(), N/m, N s/m; empty for linear laws
  std::vector<double> start_stiffnesses_;       ///< at the last commit, of laws with corners
};

}  // namespace moat
