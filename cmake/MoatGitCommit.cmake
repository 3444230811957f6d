# Writes git_commit.hpp: the commit that moat is built from. Included, it sets up the target and the folder of the
# header, MOAT_GIT_COMMIT_DIR; as a script (cmake -P) it writes the header.
#
# The header is made again when a source file or HEAD changes, and compiled again only if its text differs.

if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=40 --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(commit "")
  endif()
  file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "namespace moat {
inline constexpr const char* git_commit = \"${commit}\";
}
")
  return()
endif()

find_program(MOAT_GIT git)
mark_as_advanced(MOAT_GIT)
set(MOAT_GIT_COMMIT_DIR ${CMAKE_BINARY_DIR}/git_commit)
set(_sources)
set(_head)
if(MOAT_GIT)
  execute_process(COMMAND ${MOAT_GIT} -C ${PROJECT_SOURCE_DIR} rev-parse --path-format=absolute --git-path logs/HEAD
    OUTPUT_VARIABLE _head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT EXISTS "${_head}")
    set(_head)
  endif()
endif()
foreach(_folder ${MOAT_LIBRARY_FOLDERS})
  file(GLOB_RECURSE _found ${PROJECT_SOURCE_DIR}/${_folder}/*.?pp)
  list(APPEND _sources ${_found})
endforeach()
add_custom_command(OUTPUT ${MOAT_GIT_COMMIT_DIR}/stamp
  BYPRODUCTS ${MOAT_GIT_COMMIT_DIR}/git_commit.hpp
  COMMAND ${CMAKE_COMMAND} -DGIT=${MOAT_GIT} -DSOURCE=${PROJECT_SOURCE_DIR}
    -DOUTPUT=${MOAT_GIT_COMMIT_DIR}/git_commit.hpp -P ${CMAKE_CURRENT_LIST_FILE}
  COMMAND ${CMAKE_COMMAND} -E touch ${MOAT_GIT_COMMIT_DIR}/stamp
  DEPENDS ${_sources} ${_head} ${CMAKE_CURRENT_LIST_FILE}
  COMMENT "Looking up the commit"
  VERBATIM)
add_custom_target(moat_git_commit DEPENDS ${MOAT_GIT_COMMIT_DIR}/stamp)
add_dependencies(moat_generated_headers moat_git_commit)
