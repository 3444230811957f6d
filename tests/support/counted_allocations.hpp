// The number of allocations of this program.
#pragma once

namespace moat::testing {

/// Calls of malloc, calloc and realloc since the program started, of all threads and libraries; operator new calls
/// malloc. 0 under the address sanitizer, which brings its own malloc.
long count_of_allocations();

}  // namespace moat::testing
