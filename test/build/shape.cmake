# Checks that modules have a README, which lists their public headers, libraries do not affect the whole
# process and are deterministic, and CITATION.cff has the current version. ROOT: the
# repository.
cmake_minimum_required(VERSION 3.25)
file(GLOB modules "${ROOT}/modules/*/CMakeLists.txt")
foreach(module IN LISTS modules)
  cmake_path(GET module PARENT_PATH folder)
  set(text)
  if(EXISTS "${folder}/README.md")
    file(READ "${folder}/README.md" text)
  endif()
  file(GLOB headers "${folder}/include/pcl/*/*.h" "${folder}/include/pcl/*/*.h.in")
  foreach(header IN LISTS headers)
    cmake_path(GET header STEM name)
    if(NOT text MATCHES "[`/]${name}\\.h`")
      message(SEND_ERROR "${folder}/README.md does not list ${name}.h")
    endif()
  endforeach()
endforeach()

find_program(grep grep REQUIRED)
set(sources --include=*.h --include=*.hpp --include=*.cpp)
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
