# moat_embed(target variable file...): the text of files, one behind the other, as a constant of the program.
#
# A source of the target includes <embedded/VARIABLE.hpp> and has `std::string_view moat::embedded::VARIABLE`. The
# header is made again when a file changes. Included, this file defines the function; as a script (cmake -P) it writes
# the header.

if(CMAKE_SCRIPT_MODE_FILE)
  set(text "")
  string(REPLACE "|" ";" files "${FILES}")
  foreach(file IN LISTS files)
    file(READ "${file}" content)
    string(APPEND text "${content}")
  endforeach()
  string(FIND "${text}" ")moat\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${FILES}: a text that holds )moat\" cannot be embedded.")
  endif()
  file(WRITE "${OUTPUT}" "#include <string_view>
namespace moat::embedded {
inline constexpr std::string_view ${VARIABLE} = R\"moat(${text})moat\";
}
")
  return()
endif()

set(MOAT_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# All headers that a build makes: clang-tidy needs them, and nothing else of a build.
if(NOT TARGET moat_generated_headers)
  add_custom_target(moat_generated_headers)
endif()

function(moat_embed target variable)
  set(files)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file)
    list(APPEND files ${file})
  endforeach()
  set(header ${CMAKE_CURRENT_BINARY_DIR}/embed_${variable}/embedded/${variable}.hpp)
  add_custom_command(OUTPUT ${header}
    COMMAND ${CMAKE_COMMAND} "-DFILES=$<JOIN:${files},|>" -DVARIABLE=${variable} -DOUTPUT=${header}
      -P ${MOAT_EMBED_SCRIPT}
    DEPENDS ${files} ${MOAT_EMBED_SCRIPT}
    COMMENT "Embedding ${variable}"
    VERBATIM)
  # The target may belong to another folder, which knows nothing of the command above.
  add_custom_target(${target}_embeds_${variable} DEPENDS ${header})
  add_dependencies(${target} ${target}_embeds_${variable})
  add_dependencies(moat_generated_headers ${target}_embeds_${variable})
  target_include_directories(${target} PRIVATE $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/embed_${variable}>)
endfunction()
