# The libraries acmap stands on, found once for all folders.
include(AcmapFindPCL)

acmap_find_pcl(common search surface io features)
find_package(Eigen3 3.3 REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(pugixml REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
if(NOT ACMAP_MODULES)
  find_package(CLI11 REQUIRED)
endif()
acmap_if_chosen(needs_x11 acquisition visualization)
if(needs_x11)
  find_package(X11 REQUIRED COMPONENTS Xrandr xcb)
endif()

# acmap_find_library (<target> <header> <library>): the target of a library without a package
# file, unless a project around this one has made it.
function(acmap_find_library target header library)
  if(TARGET ${target})
    return()
  endif()
  string(TOUPPER ${target} NAME)
  find_path(${NAME}_INCLUDE_DIR ${header} PATH_SUFFIXES libusb-1.0 opencv4 REQUIRED)
  find_library(${NAME}_LIBRARY ${library} REQUIRED)
  mark_as_advanced(${NAME}_INCLUDE_DIR ${NAME}_LIBRARY)
  add_library(${target} UNKNOWN IMPORTED)
  set_target_properties(
    ${target} PROPERTIES IMPORTED_LOCATION "${${NAME}_LIBRARY}"
                         INTERFACE_INCLUDE_DIRECTORIES "${${NAME}_INCLUDE_DIR}")
endfunction()

acmap_find_library(lzf liblzf/lzf.h lzf)
# These five have package files in some distributions only. FLANN's headers call lz4, too: a
# search tree of PCL's, compiled for our point type, needs it.
acmap_find_library(turbojpeg turbojpeg.h turbojpeg)
acmap_find_library(lz4 lz4frame.h lz4)
acmap_find_library(zstd zstd.h zstd)
acmap_find_library(bz2 bzlib.h bz2)
acmap_find_library(sqlite3 sqlite3.h sqlite3)
# libusb has one for pkg-config alone.
acmap_if_chosen(needs_libusb acquisition)
if(needs_libusb)
  acmap_find_library(libusb libusb.h usb-1.0)
endif()
# OpenCV's package file comes with all of OpenCV only; six parts of it are enough.
acmap_if_chosen(needs_opencv acquisition egomotion stereo video)
if(needs_opencv)
  foreach(part IN ITEMS core flann imgproc features2d calib3d videoio)
    acmap_find_library(opencv_${part} opencv2/${part}.hpp opencv_${part})
  endforeach()
endif()

# stb has headers only, among them the one that packs rectangles.
find_path(STB_INCLUDE_DIR stb_rect_pack.h PATH_SUFFIXES stb REQUIRED)
mark_as_advanced(STB_INCLUDE_DIR)
if(NOT TARGET stb)
  add_library(stb INTERFACE IMPORTED)
endif()
set_target_properties(stb PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${STB_INCLUDE_DIR}")

include(AcmapEigenAlignment)
