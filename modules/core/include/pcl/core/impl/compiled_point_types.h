#pragma once

#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

/** \file
 * Point types for which the class templates are instantiated. For other types include
 * the headers in `impl/`. Builds with sanitizers instantiate fewer types. */
#ifdef ACMAP_FEW_POINT_TYPES
/** \brief Point types with x, y, z: PCL's and acmap's own. */
#define ACMAP_ALL_POINT_TYPES                                                      \
  (pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointNormal)(pcl::PointXYZRGBNormalView)( \
      pcl::PointXYZRGBSigma)
/** \brief Point types for organized views with colour. */
#define ACMAP_VIEW_POINT_TYPES (pcl::PointXYZRGB)(pcl::PointXYZRGBSigma)
#else
#define ACMAP_ALL_POINT_TYPES \
  PCL_XYZ_POINT_TYPES(pcl::PointXYZRGBNormalView)(pcl::PointXYZRGBSigma)
#define ACMAP_VIEW_POINT_TYPES \
  (pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBSigma)
#endif
