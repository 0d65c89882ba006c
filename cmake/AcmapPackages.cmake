# How cpack makes Debian packages of the install components (AcmapInstall).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT
    "acmap maintainers <maintainers@users.noreply.h-seed-39cc7cce.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME
    libacmap${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/triggers")
set(CPACK_DEBIAN_LIBRARIES_DESCRIPTION "compact maps of noisy point clouds: libraries
Consolidation, open triangle meshes, normals, planes, textures, active stereo,
egomotion and straightening of maps, as classes in the manner of PCL.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libacmap-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS nlohmann-json3-dev) # of core/fields_json.h alone
set(CPACK_DEBIAN_DEV_DESCRIPTION "compact maps of noisy point clouds: headers
What find_package (acmap) of CMake and pkg-config find.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME acmap-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/postinst")
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "compact maps of noisy point clouds: tools
From recordings of a trinocular camera with projector, RGB-D folders, laser
logs and clouds to meshes, planes and textured compact maps. With rigs and
scenes to try them with, and the udev rule that opens the cameras to who sits
at the machine.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-acmap)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "compact maps of noisy point clouds: Python module
Stages of acmap as functions of numpy's arrays.")

# acmap_make_packages (): cpack makes a package of each component used so far.
function(acmap_make_packages)
  acmap_find_headers_packages(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
  if(NOT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
    message(STATUS "No Debian packages of acmap: it stands on libraries from elsewhere")
    return()
  endif()
  acmap_listed_packages(picture CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS)

  get_property(modules GLOBAL PROPERTY ACMAP_MODULES)
  list(TRANSFORM modules PREPEND "${PROJECT_BINARY_DIR}/modules/"
       OUTPUT_VARIABLE CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS)

  set(changelog "${PROJECT_BINARY_DIR}/changelog.gz")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CHANGELOG.md)
  execute_process(COMMAND gzip -9nc "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
                  OUTPUT_FILE "${changelog}" COMMAND_ERROR_IS_FATAL ANY)
  get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} key)
    set(package ${CPACK_DEBIAN_${key}_PACKAGE_NAME})
    set(folder "${CMAKE_INSTALL_DATADIR}/doc/${package}")
    install(FILES LICENSE DESTINATION "${folder}" RENAME copyright COMPONENT ${component})
    install(FILES "${changelog}" DESTINATION "${folder}" COMPONENT ${component})
    if(NOT component STREQUAL libraries)
      set(CPACK_COMPONENT_${key}_DEPENDS libraries) # of the very same version
    endif()
  endforeach()
  include(CPack)
endfunction()

# acmap_find_headers_packages (<result>): the Debian packages, parted by commas, of what the
# modules' headers include: PCL and what the modules declare as PUBLIC_LIBRARIES. Nothing
# if one of them is no Debian package.
function(acmap_find_headers_packages result)
  set(${result} "" PARENT_SCOPE)
  include("${PROJECT_BINARY_DIR}/acmapModules.cmake")
  set(libraries PCL)
  foreach(module IN LISTS acmap_modules)
    list(APPEND libraries ${acmap_${module}_packages})
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  set(files)
  foreach(library IN LISTS libraries)
    if(library STREQUAL MPI) # which CMake finds without a package file
      list(APPEND files "${MPI_CXX_HEADER_DIR}/mpi.h")
    else()
      list(APPEND files "${${library}_CONFIG}")
    endif()
  endforeach()
  execute_process(COMMAND dpkg-query --search ${files} OUTPUT_VARIABLE owners
                  ERROR_QUIET RESULT_VARIABLE failure)
  if(failure)
    return()
  endif()
  string(REGEX MATCHALL "(^|\n)[^:\n]+" owners "${owners}")
  list(TRANSFORM owners STRIP)
  list(SORT owners)
  list(JOIN owners ", " owners)
  set(${result} "${owners}" PARENT_SCOPE)
endfunction()

# acmap_listed_packages (<group> <result>): a group of cmake/packages.txt, parted by commas.
function(acmap_listed_packages group result)
  file(STRINGS "${PROJECT_SOURCE_DIR}/cmake/packages.txt" lines REGEX "^${group} +[^ ]+$")
  list(TRANSFORM lines REPLACE "^${group} +" "")
  list(JOIN lines ", " lines)
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()
