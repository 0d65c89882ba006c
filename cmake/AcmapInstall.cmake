include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Every installed file belongs to a component, which is a Debian package (AcmapPackages):
#   libraries  what programs load
#   dev        headers, links, package files
#   tools      programs, what they need of the system, files to try them with
#   python     the Python module, where it is built
#
# A root of our own: <prefix>/include stays free of a second pcl folder, and two versions
# of acmap can stand side by side.
set(ACMAP_INSTALL_INCLUDEDIR
    "${CMAKE_INSTALL_INCLUDEDIR}/acmap-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(ACMAP_INSTALL_CMAKEDIR "${CMAKE_INSTALL_LIBDIR}/cmake/acmap")
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

# Library, headers and target file of a module.
function(acmap_install_module name)
  install(TARGETS acmap_${name} EXPORT acmap_${name}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
                  COMPONENT libraries NAMELINK_COMPONENT dev)
  install(EXPORT acmap_${name} FILE acmap_${name}.cmake NAMESPACE acmap::
          DESTINATION ${ACMAP_INSTALL_CMAKEDIR} COMPONENT dev)
  install(DIRECTORY include/ DESTINATION ${ACMAP_INSTALL_INCLUDEDIR} COMPONENT dev
          FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
  acmap_install_pkgconfig_file(${name})
  acmap_join(product acmap_${name})
endfunction()

# acmap_<name>.pc, for pkg-config, beside PCL's; it has no path of its own, so that it is right
# under any prefix. Reads arg_DEPENDS, arg_PCL and arg_PUBLIC_LIBRARIES of acmap_add_module.
function(acmap_install_pkgconfig_file name)
  set(suffix)
  if(PCL_VERSION VERSION_LESS 1.13)
    set(suffix -${PCL_VERSION_MAJOR}.${PCL_VERSION_MINOR})
  endif()
  set(name_of_Eigen3::Eigen eigen3)
  set(name_of_TBB::tbb tbb)
  set(name_of_MPI::MPI_CXX mpi-cxx)
  list(TRANSFORM arg_DEPENDS PREPEND acmap_ OUTPUT_VARIABLE requirements)
  foreach(part IN LISTS arg_PCL)
    list(APPEND requirements pcl_${part}${suffix})
  endforeach()
  foreach(library IN LISTS arg_PUBLIC_LIBRARIES)
    list(APPEND requirements ${name_of_${library}})
  endforeach()
  list(JOIN requirements " " requirements)
  file(RELATIVE_PATH includes "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig"
       "${CMAKE_INSTALL_PREFIX}/${ACMAP_INSTALL_INCLUDEDIR}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/acmap_module.pc.in"
                 "${PROJECT_BINARY_DIR}/pkgconfig/acmap_${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/pkgconfig/acmap_${name}.pc"
          DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)
endfunction()

# The package files of all modules declared so far, and the generated headers.
function(acmap_install_package)
  get_property(modules GLOBAL PROPERTY ACMAP_MODULES)
  get_property(data GLOBAL PROPERTY ACMAP_MODULE_DATA)
  file(WRITE "${PROJECT_BINARY_DIR}/acmapModules.cmake"
       "set(acmap_modules \"${modules}\")\n${data}")
  configure_package_config_file(
    cmake/acmapConfig.cmake.in "${PROJECT_BINARY_DIR}/acmapConfig.cmake"
    INSTALL_DESTINATION ${ACMAP_INSTALL_CMAKEDIR} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/acmapConfigVersion.cmake"
                                   COMPATIBILITY SameMinorVersion)
  # where ROS looks for packages
  install(FILES "${PROJECT_SOURCE_DIR}/package.xml"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/acmap" COMPONENT dev)
  install(FILES "${PROJECT_BINARY_DIR}/acmapConfig.cmake"
                "${PROJECT_BINARY_DIR}/acmapConfigVersion.cmake"
                "${PROJECT_BINARY_DIR}/acmapModules.cmake" cmake/AcmapFindPCL.cmake
          DESTINATION ${ACMAP_INSTALL_CMAKEDIR} COMPONENT dev)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/include/"
          DESTINATION ${ACMAP_INSTALL_INCLUDEDIR} COMPONENT dev)
endfunction()
