# `cmake --build build/release --target moat_api_reference`: the API reference by Doxygen, in build/release/reference/html.
#
# Its symbols are those of all installed headers. The Doxyfile of the build folder is docs/Doxyfile with these headers;
# tests/documentation counts undocumented symbols with it.

get_target_property(_headers moat HEADER_SET)
get_target_property(_laws_and_elements moat HEADER_SET_laws_and_elements)
list(APPEND _headers ${_laws_and_elements})
list(TRANSFORM _headers REPLACE "^${PROJECT_SOURCE_DIR}/" "")
list(JOIN _headers " " MOAT_REFERENCE_HEADERS)
configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile ${CMAKE_BINARY_DIR}/Doxyfile @ONLY)

add_custom_target(moat_api_reference
  COMMAND doxygen ${CMAKE_BINARY_DIR}/Doxyfile
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Writing ${CMAKE_BINARY_DIR}/reference/html" VERBATIM)

# `cmake --build build/release --target moat_site`: the documents and the reference with formulas, in
# build/release/site/html/index.html.
configure_file(${PROJECT_SOURCE_DIR}/docs/Site.doxyfile ${CMAKE_BINARY_DIR}/Site.doxyfile @ONLY)
add_custom_target(moat_site
  COMMAND doxygen ${CMAKE_BINARY_DIR}/Site.doxyfile
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Writing ${CMAKE_BINARY_DIR}/site/html/index.html" VERBATIM)
