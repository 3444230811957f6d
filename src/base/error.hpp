// The exceptions of moat.
#pragma once

#include <stdexcept>
#include <string>

namespace moat {

/// Base of everything moat throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A parameter, option or model that cannot be right. The message names the object, the parameter,
/// its value, the allowed range with its unit, and the remedy.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read, understood or written. The message names the file and the line.
class FileError : public Error {
 public:
  using Error::Error;
};

/// A time step that did not converge although it was cut down to the smallest length.
/// All results before `time` have been recorded.
class ConvergenceError : public Error {
 public:
  /// The fields below, in their order.
  ConvergenceError(const std::string& message, double time_s, double step_s, double residual_ratio, std::string worst)
      : Error{message}, time{time_s}, step{step_s}, residual{residual_ratio}, worst_place{std::move(worst)} {}

  double time;  ///< start of the failed step, s
  double step;  ///< its last length, s
  /// Largest out-of-balance force over the largest force in the equations. Where a change of an element could not be
  /// located: the margin of the element, m.
  double residual;
  std::string worst_place;  ///< the node with that force, or the element
};

/// The weight of a building leaves its bearings: no axial forces of theirs balance its overturning moment. All results
/// before `time` have been recorded.
class RockingError : public Error {
 public:
  /// `message`, and the time in s.
  RockingError(const std::string& message, double time_s) : Error{message}, time{time_s} {}

  double time;  ///< s
};

}  // namespace moat
