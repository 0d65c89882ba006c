#include <pcl/core/compiled_point_types.h>
#include <pcl/egomotion/impl/visual_egomotion.hpp>

PCL_INSTANTIATE(VisualEgomotion, ACMAP_VIEW_POINT_TYPES)
