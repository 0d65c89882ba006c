#pragma once

#include <pcl/egomotion/keypoint_kernel.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief Brightness of an endless wallpaper: waves in all directions, 8 to 60 pixels long,
 * about 128. */
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

/** \brief How a camera before a wallpaper is turned, and how near it is. */
struct ViewChange {
  double turn = 0;                                 ///< radians
  double scale = 1;                                ///< of the picture
  Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< pixels

  /** \brief Where a pixel of the plain view (or a place of the paper) lies in this one. */
  Eigen::Vector2d
  operator()(const Eigen::Vector2d& pixel) const;

  Eigen::Vector2d
  inverse(const Eigen::Vector2d& pixel) const;
};

/** \brief The wallpaper as seen, 240 x 180 pixels, turned about the middle. */
GreyImage
paint(const Wallpaper& paper, const ViewChange& change = {});

/** \brief Maxima of the gradient away from the border. */
std::vector<std::int32_t>
keypointsOf(const GreyImage& image, std::size_t most = 400);

Eigen::Vector2d
placeOf(std::int32_t pixel, const GreyImage& image);

/** \brief The image on a wall 2 m before a camera of 200 pixels focal length, turned by its
 * side so that every pixel has a depth of its own. */
PointCloud<PointXYZRGB>::Ptr
wallOf(const GreyImage& image);

} // namespace pcl::acmap::test
