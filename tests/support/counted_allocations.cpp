#include "counted_allocations.hpp"

#include <atomic>
#include <cstddef>

namespace {

std::atomic<long> calls = 0;

}  // namespace

// These definitions replace the functions of the C library, in shared libraries too.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

void* malloc(std::size_t size) {
  ++calls;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++calls;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++calls;
  return __libc_realloc(memory, size);
}
}

namespace moat::testing {

long count_of_allocations() { return calls; }

}  // namespace moat::testing
