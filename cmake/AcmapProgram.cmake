# acmap_add_tool (<pcl_name> SOURCES <file>... LIBRARIES <target>...): an installed program.
# Target product builds all that is installed.
function(acmap_add_tool name)
  acmap_add_program(${name} ${ARGN})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  acmap_join(product ${name})
endfunction()

# acmap_add_tool_part (<name> SOURCES <file>... LIBRARIES <target>...): what a tool is made
# of, as a library that other tools and the tests can link; it is not installed.
function(acmap_add_tool_part name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES})
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
  if(ACMAP_BUILD_TESTS AND CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize=address")
    target_link_libraries(${name} PRIVATE acmap_leaks_of_drivers)
  endif()
endfunction()

# Makes target <all> build target <one> too.
function(acmap_join all one)
  if(NOT TARGET ${all})
    add_custom_target(${all})
  endif()
  add_dependencies(${all} ${one})
endfunction()
