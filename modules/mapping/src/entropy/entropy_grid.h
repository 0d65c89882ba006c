#pragma once

#include <pcl/mapping/map_entropy_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The bins that a map needs: bin (i, j) begins at (i, j) times the bin's edge,
 * whatever the map, so that entropies of different poses compare. */
struct BinRange {
  std::int64_t least_x = INT64_MAX, most_x = INT64_MIN;
  std::int64_t least_z = INT64_MAX, most_z = INT64_MIN;

  void
  add(std::int64_t x, std::int64_t z);

  void
  add(const BinRange& other);

  bool
  isEmpty() const
  {
    return most_x < least_x;
  }
};

/** \brief q(x, z) of Eq. 3, in one layer or in one for each direction of walls and one
 * for points without. Fill it, then \ref smooth, \ref terms, \ref toSensitivities. */
class EntropyGrid {
public:
  /** \param[in] range of the bins that will be filled; the grid adds what smoothing
   * needs
   */
  EntropyGrid(const BinRange& range, const MapEntropySettings& settings);

  /** \brief Bins of all layers, before anything is allocated. */
  static double
  binsOf(const BinRange& range, const MapEntropySettings& settings);

  void
  allocate();

  double&
  at(int layer, std::int64_t x, std::int64_t z)
  {
    return bins_[(static_cast<std::size_t>(layer) * width_ +
                  static_cast<std::size_t>(x - first_x_)) *
                     depth_ +
                 static_cast<std::size_t>(z - first_z_)];
  }

  /** \brief Convolves with the Gaussian, cut at 3 sigma. */
  void
  smooth();

  /** \brief The entropies of smoothed bins.
   * \param[in] points sum of what was filled in */
  MapEntropyTerms
  terms(double points);

  /** \brief After \ref terms: each bin becomes d total / d Q, where Q is the share of
   * points filled into it; constants, which cancel, are left out. */
  void
  toSensitivities(double points);

  void
  tell(MapEntropyReport& report) const;

private:
  void
  convolveRow(std::size_t row, std::vector<double>& scratch);

  MapEntropySettings settings_;
  std::int64_t first_x_, first_z_;
  std::size_t width_, depth_, layers_;
  std::vector<double> kernel_; ///< from its middle outwards
  std::vector<double> bins_, spare_;
  std::vector<double> on_x_, on_z_; ///< q_X and q_Z, not normalised
};

/** \brief Layers of a grid. */
int
layersOf(const MapEntropySettings& settings);

} // namespace pcl::acmap
