# Language standard, optimisation, warnings, sanitizers and the compiler cache, for every target of moat.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo or Debug" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without these words it compiles everything that has precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    CCACHE_COMMENTS=1 ${CCACHE})  # g++ compares a header with the precompiled one byte by byte
endif()

add_library(moat_compiler INTERFACE)
# -Wno-restrict: g++ 12 sees overlapping copies in "text" + std::string (its bug 105651).
target_compile_options(moat_compiler INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-restrict)
if(MOAT_WARNINGS_AS_ERRORS)
  target_compile_options(moat_compiler INTERFACE -Werror)
endif()
# Against overwritten memory: addresses are bound and read-only before main(), and functions of the C library check sizes.
# Buffers on the stack are guarded in programs alone: GCC takes the library's options from its precompiled header.
add_link_options(-Wl,-z,relro,-z,now)
set(MOAT_GUARDED -fstack-protector-strong)
set(MOAT_CHECKED_SIZES)
if(NOT MOAT_SANITIZE AND NOT CMAKE_BUILD_TYPE STREQUAL Debug)
  set(MOAT_CHECKED_SIZES _FORTIFY_SOURCE=2)
endif()
# Sanitizers must be in every object of a program, so they are not a property of one target.
foreach(sanitizer IN LISTS MOAT_SANITIZE)
  add_compile_options(-fsanitize=${sanitizer} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${sanitizer})
  # GCC 12 takes variables of <regex> that it instruments for uninitialised.
  target_compile_options(moat_compiler INTERFACE -Wno-maybe-uninitialized)
endforeach()
