# colcon takes the repository as a package of its workspace, by package.xml. Only core is
# built, without optimization: what is tested is that colcon finds, builds and installs it.
find_program(COLCON colcon)
if(NOT COLCON)
  message("skipped: colcon is not installed")
  return()
endif()
file(REMOVE_RECURSE "${WORKSPACE}")
file(MAKE_DIRECTORY "${WORKSPACE}")
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env CMAKE_GENERATOR=Ninja COLCON_HOME=${WORKSPACE}/home
          ${COLCON} --log-base ${WORKSPACE}/log build --base-paths ${ROOT}
          --packages-select acmap --build-base ${WORKSPACE}/build
          --install-base ${WORKSPACE}/install --cmake-args -DACMAP_MODULES=core
          -DACMAP_BUILD_TESTS=OFF -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0
          -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16
  WORKING_DIRECTORY "${WORKSPACE}" RESULT_VARIABLE failure OUTPUT_VARIABLE told
  ERROR_VARIABLE told)
if(failure)
  message(FATAL_ERROR "colcon build fails:\n${told}")
endif()
foreach(name IN ITEMS lib/libacmap_core.so share/acmap/package.xml)
  file(GLOB_RECURSE found "${WORKSPACE}/install/acmap/${name}")
  if(NOT found)
    message(FATAL_ERROR "colcon build installs no ${name}:\n${told}")
  endif()
endforeach()
message("colcon built and installed acmap")
