# `cmake --install`: the library, its headers, a CMake package (`find_package(moat)`: target moat::moat and the function
# moat_add_script) and a pkg-config file. The build folder can be used as a package too (-Dmoat_DIR=build/release).

include(CMakePackageConfigHelpers)

install(TARGETS moat EXPORT moat-targets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moat
  FILE_SET laws_and_elements DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moat)

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/moat)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/moat-config.cmake.in ${CMAKE_BINARY_DIR}/moat-config.cmake
  INSTALL_DESTINATION ${_package} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/moat-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_file(${CMAKE_CURRENT_LIST_DIR}/MoatAddScript.cmake ${CMAKE_BINARY_DIR}/MoatAddScript.cmake COPYONLY)
install(FILES ${CMAKE_BINARY_DIR}/moat-config.cmake ${CMAKE_BINARY_DIR}/moat-config-version.cmake
  ${CMAKE_BINARY_DIR}/MoatAddScript.cmake DESTINATION ${_package})
install(EXPORT moat-targets NAMESPACE moat:: DESTINATION ${_package})
export(EXPORT moat-targets NAMESPACE moat:: FILE ${CMAKE_BINARY_DIR}/moat-targets.cmake)

file(RELATIVE_PATH MOAT_FROM_PKGCONFIG /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/moat.pc.in ${CMAKE_BINARY_DIR}/moat.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/moat.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
