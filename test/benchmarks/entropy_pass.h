#pragma once

#include "entropy_maps.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What any entropy of points has to do at least: move each one by its pose and
 * find its bin, from arrays of floats, eight at once where the processor can. */
class EntropyPass {
public:
  EntropyPass(const EntropyMap& map, double bin_size);

  /** \brief Finds all bins.
   * \return something of their numbers, that nothing is left out */
  std::int64_t
  find();

  /** \brief Finds all bins and counts the points in them: the plain histogram. */
  std::int64_t
  count();

private:
  struct Observation {
    std::vector<float> x, z; ///< bins
    PlanarPose pose;
  };

  template <typename Visit>
  void
  forEachChunk(const Visit& visit);

  std::vector<Observation> observations_;
  float x0_, z0_; ///< first bin
  std::int32_t row_;
  double bin_size_;
  std::vector<std::uint32_t> counts_;
};

} // namespace pcl::acmap::bench
