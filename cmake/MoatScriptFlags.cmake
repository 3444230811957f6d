# Files from which the launcher compiles a user's script, one argument per line so that paths may hold spaces:
#   script_compile.txt  the compiler and its flags        script_link.txt  the arguments after the source file
# and the target moat_for_scripts: the library, and <moat.hpp> precompiled for these flags.
#
# -O1: the elements and laws of moat are compiled in the library, with -O3; a script is quick to compile, and a law of
# its own still runs at nearly full speed.
#
# A script sees moat's headers as system headers: its warnings are its own, and the compiler's dependency
# output (-MMD) lists the script's own files alone.

set(_header_folder ${CMAKE_BINARY_DIR}/script_header)
file(CONFIGURE OUTPUT ${_header_folder}/moat.hpp CONTENT [[#include "@PROJECT_SOURCE_DIR@/src/moat.hpp"
]] @ONLY)

separate_arguments(_of_user NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
# -fno-elide-type: the message about a wrong dimension shows all exponents of both types. The launcher reads columns.
set(_flags -std=c++20 ${_of_user} -O1 -DNDEBUG -DMOAT_IS_SCRIPT -Wall -Wextra -fno-elide-type
  "$<$<STREQUAL:${CMAKE_CXX_COMPILER_ID},GNU>:-fdiagnostics-column-unit=byte>")
foreach(_sanitizer IN LISTS MOAT_SANITIZE)
  list(APPEND _flags -fsanitize=${_sanitizer} -fno-omit-frame-pointer -fno-sanitize-recover=all)
endforeach()

set(_folders "$<FILTER:$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:moat,INTERFACE_INCLUDE_DIRECTORIES>>,EXCLUDE,^$>")
set(_definitions "$<TARGET_PROPERTY:moat,INTERFACE_COMPILE_DEFINITIONS>")
set(_compile ${CMAKE_CXX_COMPILER} ${_flags} "$<$<BOOL:${_definitions}>:-D$<JOIN:${_definitions},;-D>>"
  -isystem ${_header_folder} -isystem "$<JOIN:${_folders},;-isystem;>")
set(_link "$<TARGET_FILE:moat>" -Xlinker -rpath -Xlinker "$<TARGET_FILE_DIR:moat>")
# gold, a part of binutils, links a script in less than half the time: it does not read the libraries behind moat.
find_program(MOAT_GOLD ld.gold)
mark_as_advanced(MOAT_GOLD)
if(MOAT_GOLD)
  list(APPEND _link -fuse-ld=gold)
endif()
foreach(_sanitizer IN LISTS MOAT_SANITIZE)
  list(APPEND _link -fsanitize=${_sanitizer})
endforeach()

set(_lines "$<JOIN:$<FILTER:${_compile},EXCLUDE,^$>,\n>\n")
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/script_compile.txt CONTENT "${_lines}")
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/script_link.txt CONTENT "$<JOIN:${_link},\n>\n")

# Other compilers than GCC name and use precompiled headers differently; scripts then compile without.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_custom_command(OUTPUT ${_header_folder}/moat.hpp.gch
    COMMAND "$<FILTER:${_compile},EXCLUDE,^$>" -x c++-header ${_header_folder}/moat.hpp
      -MD -MF ${_header_folder}/moat.hpp.d -MT script_header/moat.hpp.gch -o ${_header_folder}/moat.hpp.gch
    DEPENDS ${_header_folder}/moat.hpp ${CMAKE_BINARY_DIR}/script_compile.txt
    DEPFILE ${_header_folder}/moat.hpp.d
    COMMENT "Precompiling moat.hpp for scripts"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(moat_for_scripts DEPENDS moat ${_header_folder}/moat.hpp.gch)
else()
  add_custom_target(moat_for_scripts DEPENDS moat)
endif()
add_dependencies(moat_for_scripts moat_vtk)
if(TARGET moat_mpi)
  add_dependencies(moat_for_scripts moat_mpi)
endif()
