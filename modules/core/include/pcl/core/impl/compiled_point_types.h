#pragma once

#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

/** \file
 * Point types for which the class templates are instantiated. For other types include
 * the headers in `impl/`. Builds with sanitizers instantiate fewer types. */
#ifdef ACMAP_FEW_POINT_TYPES
/** \brief PCL's point types for clouds and maps. */
#define ACMAP_PCL_POINT_TYPES (pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointNormal)
/** \brief Point types for organized views with colour. */
#define ACMAP_VIEW_POINT_TYPES (pcl::PointXYZRGB)(pcl::PointXYZRGBSigma)
#else
#define ACMAP_PCL_POINT_TYPES                                           \
  (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)( \
      pcl::PointNormal)(pcl::PointXYZRGBNormal)
#define ACMAP_VIEW_POINT_TYPES \
  (pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBSigma)
#endif
/** \brief Point types for clouds and maps. */
#define ACMAP_MAP_POINT_TYPES ACMAP_PCL_POINT_TYPES(pcl::PointXYZRGBNormalView)
/** \brief Types for the steps from a cloud to its planes: also all others of PCL with
 * coordinates. */
#ifdef ACMAP_FEW_POINT_TYPES
#define ACMAP_ALL_POINT_TYPES ACMAP_MAP_POINT_TYPES
#else
#define ACMAP_ALL_POINT_TYPES \
  PCL_XYZ_POINT_TYPES(pcl::PointXYZRGBNormalView)(pcl::PointXYZRGBSigma)
#endif
