# Builds and runs the source of test/consumer by what pkg-config says of an installation, also
# for this machine's processor as doc/install.md says. ROOT: the repository; PREFIX: of the
# installation; COMPILER; OUTPUT: a folder.
cmake_minimum_required(VERSION 3.25)
find_program(pkgconfig pkg-config)
if(NOT pkgconfig)
  message("skipped: there is no pkg-config")
  return()
endif()
file(GLOB_RECURSE files "${PREFIX}/lib*/acmap_*.pc")
list(GET files 0 file)
cmake_path(GET file PARENT_PATH folder)
cmake_path(GET folder PARENT_PATH libraries)
set(ENV{PKG_CONFIG_PATH} "${folder}")
set(ENV{LD_LIBRARY_PATH} "${libraries}")
foreach(file IN LISTS files)
  cmake_path(GET file STEM LAST_ONLY module)
  execute_process(COMMAND "${pkgconfig}" --exists --print-errors ${module}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()

execute_process(COMMAND "${pkgconfig}" --cflags --libs acmap_filters acmap_surface
                OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
file(MAKE_DIRECTORY "${OUTPUT}")
set(native -march=native -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16
           -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
foreach(options IN ITEMS "" "${native}")
  execute_process(COMMAND "${COMPILER}" -std=c++17 -O1 ${options}
                          "${ROOT}/test/consumer/mesh_grid.cpp" -o "${OUTPUT}/mesh_grid" ${flags}
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${OUTPUT}/mesh_grid" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
