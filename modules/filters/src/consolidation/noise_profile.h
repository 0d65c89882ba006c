#pragma once

#include <vector>

namespace pcl::acmap {

/** \brief What a plane's window shows: how far its sensors stood off, how thick it is. */
struct PlaneNoise {
  float range = 0;     ///< distance of the sensors, metres; 0 unknown
  float height = 1;    ///< their height over the plane, metres; 1 where unknown
  float thickness = 0; ///< edges
};

/** \brief Expected thickness of a plane. Noise along a ray of length r that meets a plane
 * at a slant is less across it, by the ratio of the sensor's height over the plane to r:
 * the profile is the median thickness at a height of one metre, by r. */
class NoiseProfile {
public:
  NoiseProfile() = default;

  /** \param[in] samples of planar windows; are reordered */
  explicit NoiseProfile(std::vector<PlaneNoise>& samples);

  /** \brief Edges. */
  double
  expectedThickness(const PlaneNoise& plane) const;

  /** \brief Median thickness of the samples, edges. */
  double
  medianThickness() const
  {
    return thickness_;
  }

private:
  double thickness_ = 0;
  double slope_ = 0; // thickness at a height of one metre, over all ranges
  int first_bin_ = 0;
  std::vector<double> slopes_; // by half octaves of the range
};

} // namespace pcl::acmap
