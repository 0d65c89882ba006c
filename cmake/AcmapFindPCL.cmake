# PCL 1.14 asks for OpenMP in some of its parts, which acmap, with TBB, does not use: what is
# compiled with it cannot share precompiled headers with what is not.
function(acmap_drop_openmp)
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
endfunction()

# acmap_find_pcl (<component>...): finds these parts of PCL without VTK, OpenNI, libpcap and
# libusb, which PCL's package file looks for with many components and which no algorithm
# needs. A macro, because find_package leaves its variables in the caller's scope.
macro(acmap_find_pcl)
  foreach(acmap_package IN ITEMS VTK OpenNI OpenNI2 Pcap libusb)
    set(CMAKE_DISABLE_FIND_PACKAGE_${acmap_package} ON)
  endforeach()
  find_package(PCL 1.12 QUIET REQUIRED COMPONENTS ${ARGN})
  foreach(acmap_package IN ITEMS VTK OpenNI OpenNI2 Pcap libusb)
    unset(CMAKE_DISABLE_FIND_PACKAGE_${acmap_package})
  endforeach()
  unset(acmap_package)
  acmap_drop_openmp()
endmacro()
