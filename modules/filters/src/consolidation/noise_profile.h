#pragma once

#include <vector>

namespace pcl::acmap {

/** \brief Thickness of the plane of a window, and position of its sensors. */
struct PlaneNoise {
  float range = 0;     ///< distance of the sensors, metres; 0 if unknown
  float height = 1;    ///< height of the sensors above the plane, metres; 1 if unknown
  float thickness = 0; ///< edges
};

/** \brief Expected thickness of a plane. If a ray of length r meets a plane at a slant,
 * the noise across the plane is smaller than that along the ray by the ratio of the
 * height of the sensor above the plane to r. The profile is therefore the median of
 * thickness / height as a function of r. */
class NoiseProfile {
public:
  NoiseProfile() = default;

  /** \param[in] samples of planar windows; they are reordered */
  explicit NoiseProfile(std::vector<PlaneNoise>& samples);

  /** \brief Expected thickness of a plane, edges. */
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
  double slope_ = 0; // median of thickness / height over all ranges
  int first_bin_ = 0;
  std::vector<double> slopes_; // for bins of half an octave of the range
};

} // namespace pcl::acmap
