# The libraries acmap stands on, found once for all folders.
include(AcmapFindPCL)
include(CheckCXXSourceCompiles)

acmap_find_pcl(common search surface io features)
# PCL 1.14 asks for OpenMP in some of its parts, which acmap, with TBB, does not use: what is
# compiled with it cannot share precompiled headers with what is not.
foreach(part IN ITEMS common kdtree octree search sample_consensus filters geometry io features
                      segmentation surface registration)
  if(TARGET pcl_${part})
    get_target_property(libraries pcl_${part} INTERFACE_LINK_LIBRARIES)
    if("OpenMP::OpenMP_CXX" IN_LIST libraries)
      list(REMOVE_ITEM libraries OpenMP::OpenMP_CXX)
      set_target_properties(pcl_${part} PROPERTIES INTERFACE_LINK_LIBRARIES "${libraries}")
    endif()
  endif()
endforeach()
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

# liblzf comes without a package file.
find_path(LZF_INCLUDE_DIR liblzf/lzf.h REQUIRED)
find_library(LZF_LIBRARY lzf REQUIRED)
mark_as_advanced(LZF_INCLUDE_DIR LZF_LIBRARY)
add_library(lzf UNKNOWN IMPORTED)
set_target_properties(lzf PROPERTIES IMPORTED_LOCATION "${LZF_LIBRARY}"
                                     INTERFACE_INCLUDE_DIRECTORIES "${LZF_INCLUDE_DIR}")

# TurboJPEG has one since 2.1 only.
find_path(TURBOJPEG_INCLUDE_DIR turbojpeg.h REQUIRED)
find_library(TURBOJPEG_LIBRARY turbojpeg REQUIRED)
mark_as_advanced(TURBOJPEG_INCLUDE_DIR TURBOJPEG_LIBRARY)
add_library(turbojpeg UNKNOWN IMPORTED)
set_target_properties(
  turbojpeg PROPERTIES IMPORTED_LOCATION "${TURBOJPEG_LIBRARY}"
                       INTERFACE_INCLUDE_DIRECTORIES "${TURBOJPEG_INCLUDE_DIR}")

# stb has headers only, among them the one that packs rectangles.
find_path(STB_INCLUDE_DIR stb_rect_pack.h PATH_SUFFIXES stb REQUIRED)
mark_as_advanced(STB_INCLUDE_DIR)
add_library(stb INTERFACE IMPORTED)
set_target_properties(stb PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${STB_INCLUDE_DIR}")

# libusb has one for pkg-config alone.
acmap_if_chosen(needs_libusb acquisition)
if(needs_libusb)
  find_path(LIBUSB_INCLUDE_DIR libusb.h PATH_SUFFIXES libusb-1.0 REQUIRED)
  find_library(LIBUSB_LIBRARY usb-1.0 REQUIRED)
  mark_as_advanced(LIBUSB_INCLUDE_DIR LIBUSB_LIBRARY)
  add_library(libusb UNKNOWN IMPORTED)
  set_target_properties(
    libusb PROPERTIES IMPORTED_LOCATION "${LIBUSB_LIBRARY}"
                      INTERFACE_INCLUDE_DIRECTORIES "${LIBUSB_INCLUDE_DIR}")
endif()

# lz4 and zstd have package files in some distributions only. FLANN's headers call lz4, too: a
# search tree of PCL's, compiled for our point type, needs it.
foreach(name IN ITEMS lz4 zstd)
  string(TOUPPER ${name} NAME)
  string(REPLACE lz4 lz4frame header ${name})
  find_path(${NAME}_INCLUDE_DIR ${header}.h REQUIRED)
  find_library(${NAME}_LIBRARY ${name} REQUIRED)
  mark_as_advanced(${NAME}_INCLUDE_DIR ${NAME}_LIBRARY)
  add_library(${name} UNKNOWN IMPORTED)
  set_target_properties(${name} PROPERTIES IMPORTED_LOCATION "${${NAME}_LIBRARY}"
                                           INTERFACE_INCLUDE_DIRECTORIES "${${NAME}_INCLUDE_DIR}")
endforeach()

# OpenCV's package file comes with all of OpenCV only; six parts of it are enough.
acmap_if_chosen(needs_opencv acquisition egomotion stereo video)
if(needs_opencv)
  find_path(OPENCV_INCLUDE_DIR opencv2/calib3d.hpp PATH_SUFFIXES opencv4 REQUIRED)
  mark_as_advanced(OPENCV_INCLUDE_DIR)
  foreach(part IN ITEMS core flann imgproc features2d calib3d videoio)
    find_library(OPENCV_${part}_LIBRARY opencv_${part} REQUIRED)
    mark_as_advanced(OPENCV_${part}_LIBRARY)
    add_library(opencv_${part} UNKNOWN IMPORTED)
    set_target_properties(
      opencv_${part} PROPERTIES IMPORTED_LOCATION "${OPENCV_${part}_LIBRARY}"
                                INTERFACE_INCLUDE_DIRECTORIES "${OPENCV_INCLUDE_DIR}")
  endforeach()
endif()

# Eigen's alignment decides the layout of PCL's points: users of acmap must agree with it.
set(CMAKE_REQUIRED_LIBRARIES Eigen3::Eigen)
foreach(bytes IN ITEMS 16 0 32 64)
  check_cxx_source_compiles(
    "#include <Eigen/Core>
     static_assert(EIGEN_MAX_ALIGN_BYTES == ${bytes}, \"\");
     int main() {}" ACMAP_EIGEN_ALIGNS_TO_${bytes})
  if(ACMAP_EIGEN_ALIGNS_TO_${bytes})
    set(ACMAP_EIGEN_MAX_ALIGN_BYTES ${bytes})
    break()
  endif()
endforeach()
unset(CMAKE_REQUIRED_LIBRARIES)
if(NOT DEFINED ACMAP_EIGEN_MAX_ALIGN_BYTES)
  message(FATAL_ERROR "cannot tell EIGEN_MAX_ALIGN_BYTES of this compiler and its flags")
endif()
