// Elements whose law changes at instants: contacts that touch and separate, bearings that yield.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "model/impulses.hpp"

namespace moat {

/// The regimes of all elements at the end of a trial step.
struct RegimeScan {
  /// Smallest margin, m: how far the nearest element is from its next change of regime; negative: beyond it.
  double margin = std::numeric_limits<double>::infinity();
  /// Index of the element with that margin in its block, for a scan of one block.
  std::size_t nearest = 0;
  /// True if an element crossed its margin inside the step, also if all margins are positive again at its end.
  bool crossed = false;
  /// True if an element crossed its margin inside the step and came back before the end; the margins at the end alone
  /// would miss it.
  bool crossed_back = false;
  /// Number of elements that crossed.
  int crossings = 0;
  /// Fraction of the step at which the first margin is expected to reach the aim; 1 if none does. Given as 0 it is not
  /// looked for.
  double fraction = 1.0;
};

/// One change of regime that happened.
struct RegimeChange {
  std::size_t block = 0;    ///< index into Model::blocks()
  std::size_t element = 0;  ///< index in that block
  double time = 0.0;        ///< s
  double rate = 0.0;        ///< m/s, of the deformation at that time
  bool touched = false;     ///< a gap closed
  bool opened = false;      ///< a gap opened
  bool inside = false;      ///< of the last step, which went on; else at its end, where values may jump
};

/// Whether quantities may jump where these changes are reported; none are reported where the ground stops.
inline bool values_jump(std::span<const RegimeChange> changes) {
  return changes.empty() || !std::ranges::all_of(changes, &RegimeChange::inside);
}

/// The side of an ElementBlock whose elements have regimes. A margin is a length in m that is positive while the
/// committed regime lasts and falls below zero beyond it.
class Regimes {
 public:
  /// Looks for changes between the committed state and the last evaluate(), `step` seconds later. `aim` <= 0 m is the
  /// margin at which a located step is meant to end, just beyond zero.
  virtual void scan(double step, double aim, RegimeScan& scan) const = 0;

  /// The time, s, from the last evaluate_rates() on at which the first margin falls to `aim`, on the parabola through
  /// the deformation with both rates there; negative: it has fallen to it before. Infinite where none falls.
  [[nodiscard]] virtual double next_fall(double aim) const = 0;

  /// Puts every element that is beyond its margin at the committed state into its next regime and lists it.
  virtual void change(std::size_t block_index, std::vector<RegimeChange>& changes) = 0;

  /// Puts elements that are beyond their margin at the last evaluate(), `step` seconds after the committed state, into
  /// their next regime from the interpolated instant on, and lists them, with times from the committed state. The step
  /// is then solved again with the new regimes instead of ending there. False if a force would jump, which no step can
  /// cross; elements before that one stay changed until undo_changes_inside().
  virtual bool change_inside(double step, double aim, std::size_t block_index, std::vector<RegimeChange>& changes) = 0;

  /// Undoes the changes inside the step being tried.
  virtual void undo_changes_inside() = 0;

  /// Adds the part that these rules leave out of the forces of elements that change inside the step being tried, or
  /// changed inside the last ones: forces that begin, end or bend inside a step. They are integrated along the
  /// interpolated deformation of the last evaluate(). Returns whether there are such elements.
  virtual bool add_missed_impulses(double step, const ImpulseRules& rules, MissedImpulses& missed) = 0;

 protected:
  ~Regimes() = default;
};

}  // namespace moat
