// How often this program has asked for memory.
#pragma once

namespace moat::testing {

/// Calls of operator new since the program started, of all threads.
long count_of_new();

}  // namespace moat::testing
