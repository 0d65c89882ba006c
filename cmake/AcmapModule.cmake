# acmap_add_module (<name> SOURCES <file>... [DEPENDS <module>...] [PCL <component>...]
#                   [PUBLIC_LIBRARIES <target>...] [PRIVATE_LIBRARIES <target>...])
#
# Makes the shared library acmap_<name>, alias acmap::<name>, from the object library
# acmap_<name>_objects; tests and fuzzers that reach into the kernels link the latter.
function(acmap_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" ""
                        "SOURCES;DEPENDS;PCL;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES")
  set(siblings ${arg_DEPENDS})
  list(TRANSFORM siblings PREPEND acmap::)
  set(pcl_libraries ${arg_PCL})
  list(TRANSFORM pcl_libraries PREPEND pcl_)

  add_library(acmap_${name}_objects OBJECT ${arg_SOURCES})
  add_library(acmap_${name} SHARED)
  add_library(acmap::${name} ALIAS acmap_${name})
  foreach(target IN ITEMS acmap_${name}_objects acmap_${name})
    target_compile_features(${target} PUBLIC cxx_std_17)
    target_include_directories(
      ${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                       $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                       $<INSTALL_INTERFACE:${ACMAP_INSTALL_INCLUDEDIR}>)
    target_link_libraries(
      ${target} PUBLIC ${siblings} ${pcl_libraries} ${arg_PUBLIC_LIBRARIES}
                PRIVATE ${arg_PRIVATE_LIBRARIES})
  endforeach()
  target_include_directories(acmap_${name}_objects PUBLIC src)
  acmap_define_as_pcl_io(acmap_${name}_objects)
  acmap_use_module_headers(acmap_${name}_objects)
  target_link_libraries(acmap_${name} PRIVATE acmap_${name}_objects)
  set_target_properties(
    acmap_${name} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
                             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

  acmap_refuse_header_clash()
  acmap_install_module(${name})
  acmap_declare_module(${name})
endfunction()

# acmap_use_module_headers (<target>): the large headers that most sources of modules include
# are parsed once.
function(acmap_use_module_headers target)
  if(NOT TARGET acmap_module_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/module_headers.cpp" CONTENT "")
    add_library(acmap_module_headers OBJECT "${PROJECT_BINARY_DIR}/module_headers.cpp")
    target_compile_features(acmap_module_headers PRIVATE cxx_std_17)
    target_link_libraries(acmap_module_headers PRIVATE pcl_common Eigen3::Eigen TBB::tbb)
    acmap_define_as_pcl_io(acmap_module_headers)
    target_precompile_headers(
      acmap_module_headers PRIVATE <pcl/PCLPointCloud2.h> <pcl/point_cloud.h> <pcl/point_types.h>
      <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU>
      <oneapi/tbb/parallel_for.h> <algorithm> <array> <cmath> <filesystem> <functional> <map>
      <memory> <mutex> <optional> <set> <sstream> <string> <vector>)
  endif()
  target_precompile_headers(${target} REUSE_FROM acmap_module_headers)
endfunction()

# Refuses a public header that PCL has too: which one a user gets would be chance.
function(acmap_refuse_header_clash)
  file(GLOB_RECURSE headers RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}/include" CONFIGURE_DEPENDS
       include/*.h include/*.hpp)
  foreach(header IN LISTS headers)
    foreach(folder IN LISTS PCL_INCLUDE_DIRS)
      if(EXISTS "${folder}/${header}")
        message(FATAL_ERROR "<${header}> is a header of PCL too (${folder}): rename it")
      endif()
    endforeach()
  endforeach()
endfunction()

# Records what the module stands on, for the package config and the dependency test.
# Reads arg_DEPENDS, arg_PCL and arg_PUBLIC_LIBRARIES of acmap_add_module.
function(acmap_declare_module name)
  set(packages ${arg_PUBLIC_LIBRARIES})
  list(FILTER packages INCLUDE REGEX "::")
  list(TRANSFORM packages REPLACE "::.*" "")
  set_property(GLOBAL APPEND PROPERTY ACMAP_MODULES ${name})
  string(CONCAT data "set(acmap_${name}_depends \"${arg_DEPENDS}\")\n"
                "set(acmap_${name}_pcl \"${arg_PCL}\")\n"
                "set(acmap_${name}_packages \"${packages}\")\n")
  set_property(GLOBAL APPEND_STRING PROPERTY ACMAP_MODULE_DATA "${data}")
endfunction()
