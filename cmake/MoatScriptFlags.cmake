# What the launcher needs to compile a user's script, one argument per line so that paths may hold spaces:
#   script_compile.txt  the compiler and its flags        script_link.txt  what follows the source file
# and the target moat_script_header, which precompiles <moat.hpp> for these flags.
#
# A script sees moat's headers as system headers: its warnings are its own, and the compiler's dependency
# output (-MMD) lists the script's own files alone.

set(_header_folder ${CMAKE_BINARY_DIR}/script_header)
file(CONFIGURE OUTPUT ${_header_folder}/moat.hpp CONTENT [[#include "@PROJECT_SOURCE_DIR@/src/moat.hpp"
]] @ONLY)

string(TOUPPER "${CMAKE_BUILD_TYPE}" _build_type)
separate_arguments(_optimisation NATIVE_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${_build_type}}")
# -fno-elide-type: the message about a wrong dimension shows all exponents of both types.
set(_flags -std=c++20 ${_optimisation} -Wall -Wextra -fno-elide-type)
foreach(_sanitizer IN LISTS MOAT_SANITIZE)
  list(APPEND _flags -fsanitize=${_sanitizer} -fno-omit-frame-pointer -fno-sanitize-recover=all)
endforeach()

set(_folders "$<FILTER:$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:moat,INTERFACE_INCLUDE_DIRECTORIES>>,EXCLUDE,^$>")
set(_definitions "$<TARGET_PROPERTY:moat,INTERFACE_COMPILE_DEFINITIONS>")
set(_compile ${CMAKE_CXX_COMPILER} ${_flags} "$<$<BOOL:${_definitions}>:-D$<JOIN:${_definitions},;-D>>"
  -isystem ${_header_folder} -isystem "$<JOIN:${_folders},;-isystem;>")
set(_link "$<TARGET_FILE:moat>" -Xlinker -rpath -Xlinker "$<TARGET_FILE_DIR:moat>")
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
  add_custom_target(moat_script_header DEPENDS ${_header_folder}/moat.hpp.gch)
else()
  add_custom_target(moat_script_header)
endif()
