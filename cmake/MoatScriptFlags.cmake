# Writes script_flags.txt into the build folder: what the launcher passes to the compiler for a user's script.

get_target_property(_eigen_include Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
string(TOUPPER "${CMAKE_BUILD_TYPE}" _type)
set(_flags "-std=c++20 ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${_type}}")
if(MOAT_SANITIZE)
  string(APPEND _flags " -fsanitize=${MOAT_SANITIZE} -fno-omit-frame-pointer")
endif()
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/script_flags.txt CONTENT
"${CMAKE_CXX_COMPILER}
${_flags} -I${CMAKE_SOURCE_DIR}/src -I${CMAKE_SOURCE_DIR} -isystem ${_eigen_include}
-L$<TARGET_FILE_DIR:moat> -lmoat -Wl,-rpath,$<TARGET_FILE_DIR:moat>
")
