# Finds KLU of SuiteSparse, which ships no CMake package in Debian 12. Defines SuiteSparse::KLU.
#
# Only these: KLU pulls BTF, AMD and COLAMD; none of them is GPL. CHOLMOD and UMFPACK are (docs/dependencies.md).

find_path(SuiteSparse_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_KLU_LIBRARY klu)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_INCLUDE_DIR SuiteSparse_KLU_LIBRARY
  REASON_FAILURE_MESSAGE "install libsuitesparse-dev")

if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::KLU)
  add_library(SuiteSparse::KLU INTERFACE IMPORTED)
  target_include_directories(SuiteSparse::KLU SYSTEM INTERFACE ${SuiteSparse_INCLUDE_DIR})
  target_link_libraries(SuiteSparse::KLU INTERFACE ${SuiteSparse_KLU_LIBRARY})
endif()
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_KLU_LIBRARY)
