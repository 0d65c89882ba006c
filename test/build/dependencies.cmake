# Compares the headers that each module includes from other modules with its DEPENDS.
# ROOT: the repository; DECLARED: file that sets acmap_modules and
# acmap_<module>_depends.
cmake_minimum_required(VERSION 3.25)
include("${DECLARED}")

# The module that owns header <name>, or nothing, as PCL has folders of the same names.
function(find_owner name result)
  foreach(module IN LISTS acmap_modules)
    if(EXISTS "${ROOT}/modules/${module}/include/${name}"
       OR EXISTS "${ROOT}/modules/${module}/include/${name}.in")
      set(${result} ${module} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${result} "" PARENT_SCOPE)
endfunction()

foreach(module IN LISTS acmap_modules)
  set(used)
  file(GLOB_RECURSE files "${ROOT}/modules/${module}/*.h" "${ROOT}/modules/${module}/*.hpp"
       "${ROOT}/modules/${module}/*.cpp")
  foreach(file IN LISTS files)
    file(STRINGS "${file}" lines REGEX "^ *# *include *[<\"]pcl/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE ".*[<\"](pcl/[^>\"]*)[>\"].*" "\\1" header "${line}")
      find_owner("${header}" owner)
      if(owner AND NOT owner STREQUAL module)
        list(APPEND used ${owner})
        if(NOT owner IN_LIST acmap_${module}_depends)
          message(SEND_ERROR "${file} includes <${header}>, but module ${module} does not "
                             "declare that it depends on ${owner}")
        endif()
      endif()
    endforeach()
  endforeach()
  foreach(declared IN LISTS acmap_${module}_depends)
    if(NOT declared IN_LIST used)
      message(SEND_ERROR "module ${module} declares ${declared}, but includes none of it")
    endif()
  endforeach()
endforeach()
