# Checks what find_package says of a misspelt component, and that an optional one does no harm.
# PREFIX: of an installation; OUTPUT: a folder.
cmake_minimum_required(VERSION 3.25)

# configure (<arguments of find_package>...): a project with it; sets result and output.
function(configure)
  list(JOIN ARGN " " arguments)
  file(WRITE "${OUTPUT}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(misspelt LANGUAGES CXX)
find_package(acmap ${arguments})
")
  execute_process(COMMAND ${CMAKE_COMMAND} -S "${OUTPUT}" -B "${OUTPUT}/build"
                          -DCMAKE_PREFIX_PATH=${PREFIX}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(sentence "acmap has no component \"surfaces\"; it has core .*surface")
configure(REQUIRED COMPONENTS core surfaces)
if(result EQUAL 0 OR NOT output MATCHES "${sentence}")
  message(SEND_ERROR "a required component that is misspelt is not named: ${output}")
endif()
configure(COMPONENTS surfaces)
if(NOT result EQUAL 0 OR NOT output MATCHES "${sentence}")
  message(SEND_ERROR "a component that is misspelt is not named: ${output}")
endif()
configure(REQUIRED COMPONENTS core OPTIONAL_COMPONENTS surfaces)
if(NOT result EQUAL 0)
  message(SEND_ERROR "an optional component is required: ${output}")
endif()
