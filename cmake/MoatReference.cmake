# `cmake --build build/release --target moat_api_reference`: the API reference by Doxygen, in build/release/reference/html.
#
# Its symbols are those that a script can use: the headers that moat.hpp includes, and the laws. The Doxyfile of the build
# folder is docs/Doxyfile with these headers; tests/documentation counts what is undocumented with it.

file(STRINGS ${PROJECT_SOURCE_DIR}/src/moat.hpp _includes REGEX "^#include")
set(_headers src/moat.hpp)
foreach(_include IN LISTS _includes)
  string(REGEX REPLACE "^#include \"(.*)\"$" "\\1" _include "${_include}")
  if(EXISTS ${PROJECT_SOURCE_DIR}/src/${_include})
    set(_include src/${_include})
  endif()
  list(APPEND _headers ${_include})
endforeach()
# What these headers list or build on.
file(GLOB _laws CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/materials/impact/*.hpp
  ${PROJECT_SOURCE_DIR}/materials/isolation/*.hpp ${PROJECT_SOURCE_DIR}/materials/dampers/*.hpp
  ${PROJECT_SOURCE_DIR}/materials/storeys/*.hpp ${PROJECT_SOURCE_DIR}/materials/soil/*.hpp
  ${PROJECT_SOURCE_DIR}/materials/friction/*.hpp)
list(APPEND _headers ${_laws} materials/response.hpp src/model/node.hpp src/model/diaphragm.hpp
  src/model/plan_outline.hpp)
list(JOIN _headers " " MOAT_REFERENCE_HEADERS)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/moat.hpp)
configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile ${CMAKE_BINARY_DIR}/Doxyfile @ONLY)

add_custom_target(moat_api_reference
  COMMAND doxygen ${CMAKE_BINARY_DIR}/Doxyfile
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Writing ${CMAKE_BINARY_DIR}/reference/html" VERBATIM)
