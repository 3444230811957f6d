// The message of an exception, for tests of bad input.
#pragma once

#include <string>

#include "base/error.hpp"

namespace moat::testing {

/// The message of the Exception that the action throws; another exception goes on to the test framework.
template <class Exception = InputError, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace moat::testing
