# Checks what doc/architecture.md says of includes and dependencies, its table and its
# drawing, and that decisions have a date. ROOT: the repository; DECLARED: file that sets
# acmap_modules and acmap_<module>_depends.
cmake_minimum_required(VERSION 3.25)
include("${DECLARED}")
find_program(grep grep REQUIRED)

# refuse_lines (<what> <pattern> <folder or file>...): no source there has such a line
function(refuse_lines what pattern)
  execute_process(COMMAND "${grep}" -rnE --include=*.h --include=*.hpp --include=*.cpp
                          "${pattern}" ${ARGN}
                  WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE found)
  if(found)
    message(SEND_ERROR "${what}:\n${found}")
  endif()
endfunction()

refuse_lines("tools call no kernels" "include <pcl/.*_kernel\\.h>" apps)
refuse_lines("Python binds nothing of pipeline but CompactMapping"
             "include <pcl/pipeline/(.{0,14}>|[^c]|c[^o])" python)
# pcl/types.h has names of integers
file(GLOB kernels "${ROOT}/modules/*/include/pcl/*/impl/*_kernel.h")
foreach(kernel IN LISTS kernels)
  file(STRINGS "${kernel}" lines REGEX "^#include <pcl/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*<(.*)>.*" "\\1" header "${line}")
    file(GLOB of_acmap "${ROOT}/modules/*/include/${header}")
    if(NOT of_acmap AND NOT header STREQUAL "pcl/types.h")
      message(SEND_ERROR "${kernel}: a kernel knows no type of PCL, but this one includes <${header}>")
    endif()
  endforeach()
endforeach()

# doc/core/report.md says so to who links a program
file(GLOB headers "${ROOT}/modules/*/include/pcl/*/*.h")
list(FILTER headers EXCLUDE REGEX "/core/fields_json\\.h$")
refuse_lines("no other public header needs nlohmann-json"
             "include <(nlohmann/|pcl/core/(fields_json|impl/json_text)\\.h)" ${headers})

file(READ "${ROOT}/doc/architecture.md" page)
foreach(module IN LISTS acmap_modules)
  set(allowed core)
  if(module STREQUAL mpi)
    set(allowed core pipeline)
  elseif(module STREQUAL pipeline)
    set(allowed ${acmap_modules})
    list(REMOVE_ITEM allowed acquisition video visualization mpi)
  endif()
  set(others ${acmap_${module}_depends})
  list(REMOVE_ITEM others ${allowed})
  if(others)
    message(SEND_ERROR "module ${module} may not depend on ${others}")
  endif()
  string(REGEX MATCH "\n[|] `${module}` [|][^\n]*[|]([^|\n]*)[|]\n" row "${page}")
  set(told "${CMAKE_MATCH_1}")
  string(REGEX MATCHALL "`[a-z]+`" told "${told}")
  list(TRANSFORM told REPLACE "`" "")
  if(NOT row OR NOT told STREQUAL "${acmap_${module}_depends}")
    message(SEND_ERROR "doc/architecture.md: ${module} depends on \"${told}\", declared is "
                       "\"${acmap_${module}_depends}\"")
  endif()
endforeach()

# compare_library (<library> <pattern>): the modules in its row include its headers
function(compare_library library pattern)
  set(used)
  foreach(module IN LISTS acmap_modules)
    execute_process(COMMAND "${grep}" -rqE --include=*.h --include=*.hpp --include=*.cpp
                            "^ *# *include [<\"](${pattern})" modules/${module}
                    WORKING_DIRECTORY "${ROOT}" RESULT_VARIABLE is_absent)
    if(NOT is_absent)
      list(APPEND used ${module})
    endif()
  endforeach()
  list(SORT used)
  string(REGEX MATCH "\n[|] ${library} [|][^\n]*[|]([^|\n]*)[|]\n" row "${page}")
  string(REGEX MATCHALL "`[a-z]+`" told "${CMAKE_MATCH_1}")
  list(TRANSFORM told REPLACE "`" "")
  if(NOT row OR NOT told STREQUAL used)
    message(SEND_ERROR "doc/architecture.md: ${library} is used by \"${told}\", and included "
                       "by \"${used}\"")
  endif()
endfunction()

compare_library(PCL "pcl/[A-Za-z_0-9]+[.]h")
compare_library(FLANN "pcl/kdtree/|pcl/search/|flann/")
compare_library("FLANN, as OpenCV has it" "opencv2/flann")
compare_library(Eigen "Eigen/|unsupported/Eigen/")
compare_library(OpenCV "opencv2/")
compare_library(VTK "vtk")
compare_library(libusb "libusb")

file(GLOB flat "${ROOT}/modules/core/src/*.h" "${ROOT}/modules/core/src/*.cpp")
if(flat)
  message(SEND_ERROR "each source of core has a folder: ${flat}")
endif()

set(decisions 0)
file(GLOB pages "${ROOT}/modules/*/README.md" "${ROOT}/apps/README.md" "${ROOT}/doc/architecture.md")
foreach(page IN LISTS pages)
  file(READ "${page}" text)
  string(FIND "${text}" "\n## Decisions\n" place)
  if(place EQUAL -1)
    continue()
  endif()
  string(SUBSTRING "${text}" ${place} -1 text)
  string(REGEX REPLACE "\n## (Determinism|Files).*" "" text "${text}")
  string(REGEX MATCHALL "\n- [^:]*: [*][*]" dated "${text}")
  string(REGEX MATCHALL "\n- " all "${text}")
  list(FILTER dated INCLUDE REGEX "- 20[0-9][0-9]-[01][0-9]-[0-3][0-9]: ")
  list(LENGTH dated with)
  list(LENGTH all count)
  if(NOT with EQUAL count)
    message(SEND_ERROR "${page}: a decision begins with its day, as \"- 2026-11-29: **Title.**\"")
  endif()
  math(EXPR decisions "${decisions} + ${count}")
endforeach()
if(decisions LESS 130)
  message(SEND_ERROR "only ${decisions} decisions were found")
endif()

execute_process(COMMAND "${CMAKE_COMMAND}" -DCOMPARE=ON -P
                        "${CMAKE_CURRENT_LIST_DIR}/draw_architecture.cmake"
                COMMAND_ERROR_IS_FATAL ANY)
