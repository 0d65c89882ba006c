# acmap_add_tool (<pcl_name> SOURCES <file>... LIBRARIES <target>...): an installed program.
# Target product builds all that is installed.
function(acmap_add_tool name)
  acmap_add_program(${name} ${ARGN})
  acmap_use_tool_headers(${name})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  install(FILES "${PROJECT_SOURCE_DIR}/share/completion/acmap.bash"
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          RENAME ${name} COMPONENT tools)
  acmap_join(product ${name})
  acmap_add_manual(${name})
endfunction()

# acmap_add_manual (<name>): the tool writes its page of the manual, where it can be run.
function(acmap_add_manual name)
  if(CMAKE_CROSSCOMPILING OR NOT CMAKE_BUILD_TYPE STREQUAL Release)
    return()
  endif()
  set(page "${PROJECT_BINARY_DIR}/man/${name}.1")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/man")
  add_custom_command(TARGET ${name} POST_BUILD COMMAND ${name} --help man > "${page}"
                     BYPRODUCTS "${page}" VERBATIM)
  install(FILES "${page}" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
endfunction()

# acmap_add_tool_part (<name> SOURCES <file>... LIBRARIES <target>...): what a tool is made
# of, as a library that other tools and the tests can link; it is not installed.
function(acmap_add_tool_part name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES})
  acmap_use_tool_headers(${name})
endfunction()

# Tools parse options and write JSON; what takes time is in the modules.
set(acmap_tool_options $<$<CONFIG:Release>:-O1>)

# acmap_use_tool_headers (<target>): the large headers that most tools include are parsed
# once. A precompiled header is of one kind, therefore all define what PCL's headers look at,
# and programs are compiled as parts of libraries are.
function(acmap_use_tool_headers target)
  if(NOT TARGET acmap_tool_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/tool_headers.cpp" CONTENT "")
    add_library(acmap_tool_headers STATIC "${PROJECT_BINARY_DIR}/tool_headers.cpp")
    target_link_libraries(acmap_tool_headers PRIVATE acmap::core CLI11::CLI11
                                                     nlohmann_json::nlohmann_json)
    target_compile_options(acmap_tool_headers PRIVATE -fPIC ${acmap_tool_options})
    acmap_define_as_pcl_io(acmap_tool_headers)
    target_precompile_headers(
      acmap_tool_headers PRIVATE <CLI/CLI.hpp> <nlohmann/json.hpp> <pcl/PCLPointCloud2.h>
      <pcl/point_cloud.h> <pcl/point_types.h> <Eigen/Geometry> <algorithm> <filesystem>
      <functional> <map> <optional> <string> <vector>)
  endif()
  target_compile_options(${target} PRIVATE -fPIC ${acmap_tool_options})
  acmap_define_as_pcl_io(${target})
  target_precompile_headers(${target} REUSE_FROM acmap_tool_headers)
endfunction()

# PCL's headers look at what its pcl_io defines; precompiled ones are of one kind.
function(acmap_define_as_pcl_io target)
  target_compile_definitions(
    ${target} PRIVATE $<TARGET_PROPERTY:pcl_io,INTERFACE_COMPILE_DEFINITIONS>)
endfunction()

# acmap_add_benchmark (<name> SOURCES <file>... LIBRARIES <target>...): target benchmarks
# builds them all; target benchmarks_compile compiles their sources, as the long run does,
# which is not about their speed.
function(acmap_add_benchmark name)
  acmap_add_program(${name} ${ARGN})
  acmap_join(benchmarks ${name})
  if(NOT CMAKE_BUILD_TYPE STREQUAL Release)
    acmap_compile_quickly(${name})
  endif()
  add_custom_target(${name}_compile DEPENDS $<TARGET_OBJECTS:${name}>)
  acmap_join(benchmarks_compile ${name}_compile)
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
