# `cmake --install`: the library, its headers and a CMake package (`find_package(moat)`, target moat::moat).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS moat EXPORT moat-targets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moat
  FILE_SET laws_and_elements DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moat)
install(EXPORT moat-targets NAMESPACE moat:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/moat)

file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/moat-config.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(Eigen3)\ninclude(\${CMAKE_CURRENT_LIST_DIR}/moat-targets.cmake)\n")
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/moat-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/moat-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/moat-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/moat)
