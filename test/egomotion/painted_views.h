#pragma once

#include <pcl/egomotion/impl/keypoint_kernel.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief Brightness of an infinite wallpaper: waves in all directions, with a mean of
 * about 128 and wavelengths of 8 to 60 pixels. */
class Wallpaper {
public:
  explicit Wallpaper(std::uint64_t seed, double contrast = 30);

  double
  at(const Eigen::Vector2d& place) const;

private:
  struct Wave {
    Eigen::Vector2d frequency;
    double phase = 0;
  };

  std::vector<Wave> waves_;
  double amplitude_;
};

/** \brief Motion of a camera in front of a wallpaper. */
struct ViewChange {
  double turn = 0;                                 ///< radians
  double scale = 1;                                ///< of the image
  Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< pixels

  /** \brief Position in this view of a pixel of the plain view (or of a point of the
   * paper). */
  Eigen::Vector2d
  operator()(const Eigen::Vector2d& pixel) const;

  Eigen::Vector2d
  inverse(const Eigen::Vector2d& pixel) const;
};

/** \brief Image of the wallpaper, 240 x 180 pixels, rotated about its centre. */
GreyImage
paint(const Wallpaper& paper, const ViewChange& change = {});

/** \brief Maxima of the gradient that are not close to the border. */
std::vector<std::int32_t>
keypointsOf(const GreyImage& image, std::size_t maximum = 400);

Eigen::Vector2d
placeOf(std::int32_t pixel, const GreyImage& image);

/** \brief The image on a wall at 2 m, for a camera with 200 pixels focal length. The
 * wall is oblique, so that all pixels have different depths. */
PointCloud<PointXYZRGB>::Ptr
wallOf(const GreyImage& image);

} // namespace pcl::acmap::test
