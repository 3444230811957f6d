# moat_add_script(tower.cpp): the program `tower` from an input script, a source with a main().
function(moat_add_script source)
  cmake_path(GET source STEM name)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE moat::moat)
  target_compile_definitions(${name} PRIVATE MOAT_IS_SCRIPT)
endfunction()
