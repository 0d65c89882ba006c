# Checks that modules have a README, files are short, libraries do not affect the whole
# process and are deterministic, and CITATION.cff has the current version. ROOT: the
# repository.
cmake_minimum_required(VERSION 3.25)
file(GLOB modules "${ROOT}/modules/*/CMakeLists.txt")
foreach(module IN LISTS modules)
  cmake_path(REPLACE_FILENAME module README.md)
  if(NOT EXISTS "${module}")
    message(SEND_ERROR "missing: ${module}")
  endif()
endforeach()

find_program(grep grep REQUIRED)
set(sources --include=*.h --include=*.hpp --include=*.cpp)
execute_process(COMMAND "${grep}" -rc ${sources} "" modules apps python test share
                WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE lengths)
string(REGEX MATCHALL "[^:\n]+:[0-9]+" lengths "${lengths}")
if(NOT lengths)
  message(FATAL_ERROR "no sources were found")
endif()
foreach(length IN LISTS lengths)
  string(REGEX MATCH "^(.*):([0-9]+)$" whole "${length}")
  if(CMAKE_MATCH_2 GREATER 400)
    message(SEND_ERROR "${CMAKE_MATCH_1} has ${CMAKE_MATCH_2} lines: split it")
  endif()
endforeach()
execute_process(
  COMMAND "${grep}" -rnE ${sources}
          "(^|[^_a-z])(exit|abort|rand|srand) *\\(|random_device|march=|-mavx" modules
  WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE found)
if(found)
  message(SEND_ERROR "not in a library:\n${found}")
endif()

file(STRINGS "${ROOT}/CMakeLists.txt" version REGEX "^project\\(acmap VERSION")
string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" version "${version}")
file(STRINGS "${ROOT}/CITATION.cff" cited REGEX "^version: ${version}$")
if(NOT cited)
  message(SEND_ERROR "CITATION.cff is not of version ${version}")
endif()
