# The command `moat` as a part of the installation, and a Debian package of the whole: `cpack -G DEB` in the build folder.
#
# With it `moat run tower.cpp` works without the sources: the programs lie in lib/moat/bin, the compiler's words for
# scripts in lib/moat, examples in share/moat. There {root} stands for share/moat, so that the tree
# may be moved.

set(_programs ${CMAKE_INSTALL_LIBDIR}/moat)
set(_root share/moat)
install(TARGETS moat_launcher moat_study moat_motion moat_report RUNTIME DESTINATION ${_programs}/bin)
set_target_properties(moat_study moat_motion moat_report PROPERTIES INSTALL_RPATH "$ORIGIN/../..")

configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/moat.in ${CMAKE_BINARY_DIR}/debian/moat @ONLY)
install(PROGRAMS ${CMAKE_BINARY_DIR}/debian/moat DESTINATION ${CMAKE_INSTALL_BINDIR})

set(_library {root}/../../${CMAKE_INSTALL_LIBDIR})
get_target_property(_eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(JOIN _eigen "\n-isystem\n" _eigen)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/debian/script_compile.txt CONTENT "/usr/bin/g++
-std=c++20
-O1
-DNDEBUG
-Wall
-Wextra
-fno-elide-type
-fdiagnostics-column-unit=byte
-isystem
{root}/src
-isystem
@_eigen@
")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/debian/script_link.txt CONTENT "@_library@/libmoat.so
-Xlinker
-rpath
-Xlinker
@_library@
-fuse-ld=gold
")
install(FILES ${CMAKE_BINARY_DIR}/debian/script_compile.txt ${CMAKE_BINARY_DIR}/debian/script_link.txt
  DESTINATION ${_programs})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${_root} FILES_MATCHING PATTERN *.cpp
  PATTERN data/* PATTERN project/*)
# The notices of moat, and of the code of others inside its programs.
install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/copyright DESTINATION share/doc/moat)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/completion DESTINATION share/bash-completion/completions RENAME moat)
# Headers, for scripts, and for the launcher, which reads the fields of structs from them; and the command itself, which
# the results of a study name as the command that goes on.
install(CODE "set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${_root}\")
  file(CREATE_LINK ../../${CMAKE_INSTALL_INCLUDEDIR}/moat \${root}/src SYMBOLIC)
  file(CREATE_LINK ../../${CMAKE_INSTALL_BINDIR}/moat \${root}/moat SYMBOLIC)")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_NAME moat)
set(CPACK_PACKAGE_CONTACT "moat developers <moat@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# To compile a script, to let its report zoom, and to run it: the libraries behind those of moat in Debian 12, which
# tests/package compares with those that the programs name.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
set(_depends g++ libeigen3-dev libjs-dygraphs "libc6 (>= 2.36)" libgcc-s1 "libstdc++6 (>= 12)" libklu1
  libmd0 libsqlite3-0 libtrilinos-nox-13.2 libtrilinos-teuchos-13.2 libvtk9.1)
if(MOAT_MPI)
  list(APPEND _depends libopenmpi3)
endif()
list(JOIN _depends ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, openmpi-bin, paraview, python3-paraview")
set(CPACK_STRIP_FILES OFF)
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
