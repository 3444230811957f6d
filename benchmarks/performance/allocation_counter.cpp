#include "performance/allocation_counter.hpp"

#include <cstddef>

namespace {

constinit thread_local long requests = 0;

}  // namespace

// glibc lets a program define these functions itself and keeps its own under other names.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++requests;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++requests;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++requests;
  return __libc_realloc(memory, size);
}
}

namespace moat::performance {

long heap_requests() { return requests; }

}  // namespace moat::performance
