# Finds Trilinos NOX by its header and libraries.
#
# Trilinos' own package configuration asks for 26 development packages of Trilinos; NOX itself needs
# itself and three Teuchos libraries. Defines the target NOX::NOX.

find_path(NOX_INCLUDE_DIR NOX.H PATH_SUFFIXES trilinos)
set(NOX_LIBRARIES)
set(_nox_required NOX_INCLUDE_DIR)
foreach(_name nox teuchosparameterlist teuchosparser teuchoscore)
  find_library(NOX_${_name}_LIBRARY trilinos_${_name})
  list(APPEND NOX_LIBRARIES ${NOX_${_name}_LIBRARY})
  list(APPEND _nox_required NOX_${_name}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NOX REQUIRED_VARS ${_nox_required}
  REASON_FAILURE_MESSAGE "install libtrilinos-nox-dev and libtrilinos-teuchos-dev")

if(NOX_FOUND AND NOT TARGET NOX::NOX)
  add_library(NOX::NOX INTERFACE IMPORTED)
  target_include_directories(NOX::NOX SYSTEM INTERFACE ${NOX_INCLUDE_DIR})
  target_link_libraries(NOX::NOX INTERFACE ${NOX_LIBRARIES})
endif()
mark_as_advanced(${_nox_required})
