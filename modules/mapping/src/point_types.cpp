#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/mapping/impl/entropy_rectification.hpp>
#include <pcl/mapping/impl/map_entropy.hpp>
#include <pcl/mapping/impl/map_levelling.hpp>
#include <pcl/mapping/impl/map_verdict.hpp>
#include <pcl/mapping/impl/plane_adjustment.hpp>

PCL_INSTANTIATE(MapEntropy, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(EntropyRectification, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(MapLevelling, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(MapVerdict, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(PlaneAdjustment, ACMAP_ALL_POINT_TYPES)
