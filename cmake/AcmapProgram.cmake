# acmap_add_tool (<pcl_name> SOURCES <file>... LIBRARIES <target>...): an installed program.
function(acmap_add_tool name)
  acmap_add_program(${name} ${ARGN})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# acmap_add_example (<name> SOURCES <file>... LIBRARIES <target>...): built, not installed.
function(acmap_add_example name)
  acmap_add_program(${name} ${ARGN})
endfunction()

# acmap_add_benchmark (<name> SOURCES <file>... LIBRARIES <target>...): target benchmarks
# builds them all.
function(acmap_add_benchmark name)
  acmap_add_program(${name} ${ARGN})
  acmap_join(benchmarks ${name})
endfunction()

function(acmap_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
endfunction()

# Makes target <all> build target <one> too.
function(acmap_join all one)
  if(NOT TARGET ${all})
    add_custom_target(${all})
  endif()
  add_dependencies(${all} ${one})
endfunction()
