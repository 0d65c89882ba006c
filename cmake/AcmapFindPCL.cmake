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
endmacro()
