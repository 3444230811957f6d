// Counts requests for heap memory.
#pragma once

namespace moat::performance {

/// How often this thread has asked for heap memory since it began: new, malloc, calloc and realloc, in moat and in all
/// libraries. The counter stands in place of the C library's functions and calls them.
long heap_requests();

}  // namespace moat::performance
