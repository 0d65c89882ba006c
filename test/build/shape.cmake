# Modules have a README; files stay short; libraries leave the process to its owner and are
# deterministic. ROOT: the repository.
cmake_minimum_required(VERSION 3.25)
file(GLOB modules "${ROOT}/modules/*/CMakeLists.txt")
foreach(module IN LISTS modules)
  cmake_path(REPLACE_FILENAME module README.md)
  if(NOT EXISTS "${module}")
    message(SEND_ERROR "missing: ${module}")
  endif()
endforeach()

foreach(folder IN ITEMS modules apps test share)
  file(GLOB_RECURSE files "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.hpp"
       "${ROOT}/${folder}/*.cpp")
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    string(REGEX REPLACE "[^\n]" "" line_ends "${text}")
    string(LENGTH "${line_ends}" length)
    if(length GREATER 400)
      message(SEND_ERROR "${file} has ${length} lines: split it")
    endif()
    file(STRINGS "${file}" found
         REGEX "[^_a-z](exit|abort|rand|srand) *\\(|random_device|march=|-mavx")
    if(folder STREQUAL "modules" AND found)
      message(SEND_ERROR "${file}: not in a library: ${found}")
    endif()
  endforeach()
endforeach()
