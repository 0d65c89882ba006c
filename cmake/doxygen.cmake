# Makes OUTPUT/html of the headers' comments; a warning is an error. ROOT: the repository,
# which stays as it is. Without Doxygen: a line "skipped: ".
cmake_minimum_required(VERSION 3.25)
find_program(doxygen doxygen)
if(NOT doxygen)
  message("skipped: doxygen is not installed")
  return()
endif()

file(GLOB headers RELATIVE "${ROOT}" "${ROOT}/modules/*/include")
list(JOIN headers " " headers)
file(READ "${ROOT}/doc/Doxyfile" settings)
string(APPEND settings "INPUT = doc/modules.dox ${headers}\n"
                       "STRIP_FROM_INC_PATH = ${headers}\n"
                       "OUTPUT_DIRECTORY = \"${OUTPUT}\"\n")
file(MAKE_DIRECTORY "${OUTPUT}")
file(WRITE "${OUTPUT}/Doxyfile" "${settings}")
execute_process(COMMAND "${doxygen}" "${OUTPUT}/Doxyfile" WORKING_DIRECTORY "${ROOT}"
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the comments above need mending")
endif()

# An unknown group is no warning of Doxygen's: what names it is on no page of a module.
file(GLOB_RECURSE sources "${ROOT}/modules/*/include/*.h" "${ROOT}/modules/*/include/*.h.in")
file(READ "${ROOT}/doc/modules.dox" groups)
foreach(source IN LISTS sources)
  file(STRINGS "${source}" lines REGEX "[\\]ingroup")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*[\\]ingroup +([a-z]*).*" "\\1" group "${line}")
    if(NOT groups MATCHES "defgroup ${group} ")
      message(SEND_ERROR "${source}: group \"${group}\" is not in doc/modules.dox")
    endif()
  endforeach()
endforeach()
message("${OUTPUT}/html/index.html")
