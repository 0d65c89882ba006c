# Installs the build folder FROM into a fresh PREFIX; nothing of how it was built may reach
# its users.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${FROM}" --prefix "${PREFIX}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files "${PREFIX}/lib*/cmake/acmap/*.cmake")
if(NOT files)
  message(FATAL_ERROR "no package files were installed")
endif()
foreach(file IN LISTS files)
  file(READ "${file}" text)
  foreach(leak IN ITEMS COMPILE_OPTIONS LINK_OPTIONS Werror sanitize ffp-contract "${FROM}")
    string(FIND "${text}" "${leak}" place)
    if(NOT place EQUAL -1)
      message(SEND_ERROR "${file} tells its users of ${leak}")
    endif()
  endforeach()
endforeach()
