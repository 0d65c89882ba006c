# Configures test/subproject both ways and checks what acmap makes of the project around it, and
# the other way round; compiles its source, but not acmap, which takes minutes. ROOT: the
# repository; OUTPUT: a folder; COMPILER; GENERATOR: one of Ninja's.
cmake_minimum_required(VERSION 3.25)

# commands_of (<result> <source>): those of compile_commands.json.
function(commands_of result source)
  file(STRINGS "${build}/compile_commands.json" lines REGEX "\"command\": .*/${source}\"")
  if(NOT lines)
    message(SEND_ERROR "${build} does not compile ${source}")
  endif()
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

foreach(fetch IN ITEMS OFF ON)
  set(build "${OUTPUT}/fetch_${fetch}")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S "${ROOT}/test/subproject" -B "${build}" -G "${GENERATOR}"
            -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
            -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DFETCH=${fetch} -DACMAP_FOLDER=${ROOT}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build "${build}" --target
                          "${ROOT}/test/consumer/mesh_grid.cpp^" COMMAND_ERROR_IS_FATAL ANY)

  commands_of(command mesh_grid.cpp)
  if(command MATCHES " (-O[1-3]|-Wall|-ffp-contract|-fvisibility|-DEIGEN_FAST_MATH)")
    message(SEND_ERROR "acmap changes how the project around it is compiled: ${command}")
  endif()
  commands_of(command dewall_avx2.cpp)
  if(NOT command MATCHES " -O3 -DNDEBUG" OR command MATCHES "-Werror")
    message(SEND_ERROR "acmap is compiled as the project around it: ${command}")
  endif()
  execute_process(COMMAND ${CMAKE_CTEST_COMMAND} -N --test-dir "${build}" OUTPUT_VARIABLE tests)
  if(NOT tests MATCHES "Total Tests: 0")
    message(SEND_ERROR "the project around acmap has its tests: ${tests}")
  endif()
endforeach()
