#pragma once

#include "texturing/sheet.h"

#include <Eigen/Geometry>

namespace pcl::acmap::texturing {

/** The plane of a sheet, and where its texels are. */
struct SheetPlane {
  TextureChart chart; ///< of the whole sheet, without colours
  Eigen::Vector4d plane;

  /** \param[in] first canvas of the sheet, which is not of a cylinder */
  SheetPlane(const Canvas& first, const Sheet& sheet)
  : chart(first.chart)
  , plane(*first.surface.plane())
  {
    chart.colors.width = sheet.width();
    chart.colors.height = sheet.height();
  }

  /** The homography from places on the sheet to those which a camera, before it was moved,
   * shows there afterwards. Both are in blocks of so many texels, from the outer corner of the
   * first one.
   * \param[in] eye position of the camera before */
  Eigen::Matrix3d
  sourceOf(const Eigen::Vector3d& eye,
           const Eigen::Isometry3d& inverse_move,
           double block) const
  {
    const Eigen::Vector3d normal = plane.head<3>();
    const double from = normal.dot(eye) + plane[3];
    const Eigen::Vector3d u = chart.texel_u / (block * chart.texel_u.squaredNorm());
    const Eigen::Vector3d v = chart.texel_v / (block * chart.texel_v.squaredNorm());
    Eigen::Matrix3d
        of_rays; // the ray pierces the plane at eye - from / (normal . ray) ray
    of_rays << (eye - chart.origin).dot(u) * normal.transpose() - from * u.transpose(),
        (eye - chart.origin).dot(v) * normal.transpose() - from * v.transpose(),
        normal.transpose();
    Eigen::Matrix3d rays; // of a block to the right, one down, and of the corner
    rays << inverse_move.linear() * (block * chart.texel_u),
        inverse_move.linear() * (block * chart.texel_v),
        inverse_move * chart.origin - eye;
    return of_rays * rays;
  }
};

} // namespace pcl::acmap::texturing
