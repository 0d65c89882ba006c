#pragma once

#include <pcl/core/build_config.h>
#include <pcl/impl/pcl_base.hpp> // PCL is not instantiated for the types below
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

// PCL's macros and its way to write a point type use extensions of C++.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"

namespace pcl {

/** \brief A point of a map: position, colour, normal, and the observation that saw it.
 *
 * \c view is the index of that observation in its `trajectory.txt`, -1 if unknown.
 * \ingroup core */
struct EIGEN_ALIGN16 PointXYZRGBNormalView {
  PCL_ADD_POINT4D;
  PCL_ADD_NORMAL4D;
  union {
    struct {
      PCL_ADD_UNION_RGB;
      float curvature;
      std::int32_t view;
    };
    float data_c[4];
  };
  PCL_ADD_EIGEN_MAPS_RGB;
  PCL_MAKE_ALIGNED_OPERATOR_NEW

  PointXYZRGBNormalView()
  {
    x = y = z = 0;
    data[3] = 1;
    normal_x = normal_y = normal_z = data_n[3] = 0;
    rgba = 0xff000000;
    curvature = 0;
    view = -1;
  }
};

/** \brief A point of an observation: position, colour, and standard deviation along the
 * ray.
 *
 * \c sigma is in metres; NaN if the point has no position. The colour is always valid.
 * \ingroup core */
struct EIGEN_ALIGN16 PointXYZRGBSigma {
  PCL_ADD_POINT4D;
  union {
    struct {
      PCL_ADD_UNION_RGB;
      float sigma;
    };
    float data_c[4];
  };
  PCL_ADD_EIGEN_MAPS_RGB;
  PCL_MAKE_ALIGNED_OPERATOR_NEW

  PointXYZRGBSigma()
  {
    x = y = z = 0;
    data[3] = 1;
    rgba = 0xff000000;
    sigma = 0;
  }
};

} // namespace pcl

#pragma GCC diagnostic pop

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(
  pcl::PointXYZRGBNormalView,
  (float, x, x)
  (float, y, y)
  (float, z, z)
  (float, normal_x, normal_x)
  (float, normal_y, normal_y)
  (float, normal_z, normal_z)
  (float, rgb, rgb)
  (float, curvature, curvature)
  (std::int32_t, view, view))
POINT_CLOUD_REGISTER_POINT_STRUCT(
  pcl::PointXYZRGBSigma,
  (float, x, x)
  (float, y, y)
  (float, z, z)
  (float, rgb, rgb)
  (float, sigma, sigma))
// clang-format on
