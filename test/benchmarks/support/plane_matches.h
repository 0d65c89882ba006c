#pragma once

#include "plane_finders.h"
#include "simulated_clouds.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The true planes of a cloud, in its frame. */
struct PlaneTruth {
  std::vector<TruthPlane> planes;
  std::vector<std::int32_t> labels; ///< plane of each point, -1 for none
};

/** \brief A simulated cloud for plane detection, with its truth. */
struct PlaneCase {
  std::string name;
  PlaneInput input;
  PlaneTruth truth;
};

PlaneCase
makePlaneCase(const SimulatedCloud& cloud);

/** \brief Floor, ceiling, walls and ends of the standard corridor. */
bool
isMainPlane(const TruthPlane& plane);

/** \brief The common planes of the doors on one side of the corridor. */
bool
isDoorPlane(const TruthPlane& plane);

/** \brief Numbers of points that detected and true planes have in common. */
class PlaneOverlaps {
public:
  /** \param[in] truth,found plane of each point, -1 for none */
  PlaneOverlaps(const std::vector<std::int32_t>& truth,
                std::size_t truth_planes,
                const std::vector<std::int32_t>& found,
                std::size_t found_planes);

  std::size_t
  truths() const
  {
    return truth_sizes_.size();
  }

  std::size_t
  founds() const
  {
    return found_sizes_.size();
  }

  std::size_t
  common(std::size_t found, std::size_t truth) const
  {
    return common_[found * truths() + truth];
  }

  /** \brief Points of a true plane. */
  std::size_t
  truthSize(std::size_t truth) const
  {
    return truth_sizes_[truth];
  }

  /** \brief All points of a detected plane. */
  std::size_t
  foundSize(std::size_t found) const
  {
    return found_sizes_[found];
  }

  /** \brief Points of a detected plane that belong to any true plane. */
  std::size_t
  labelledSize(std::size_t found) const;

  /** \brief The true plane with most points of a detected one, -1 for none. */
  std::int32_t
  majority(std::size_t found) const;

private:
  std::vector<std::size_t> truth_sizes_;
  std::vector<std::size_t> found_sizes_;
  std::vector<std::size_t> common_;
};

/** \brief Number of planes with points, and how many of them were found. */
struct FoundShare {
  std::size_t found = 0, there = 0;

  FoundShare&
  operator+=(const FoundShare& other)
  {
    found += other.found;
    there += other.there;
    return *this;
  }

  std::string
  text() const
  {
    return std::to_string(found) + " of " + std::to_string(there);
  }
};

/** \brief Maximum deviations of a detected plane from its true plane. */
struct MatchLimits {
  double angle = 2;     ///< degrees
  double offset = 0.02; ///< metres, at the centroid of the true plane's points
};

/** \brief Deviation of a detected plane from the true one. */
struct MatchDeviation {
  double angle = 0;  ///< degrees, independent of the signs of the normals
  double offset = 0; ///< metres, at the centroid of the true plane's points
};

/** \brief Assignment of detected planes to true planes. */
struct PlaneMatches {
  std::vector<std::int32_t> finder;      ///< detected plane of each true plane, -1 for
                                         ///< none
  std::vector<MatchDeviation> deviation; ///< of these pairs
  std::size_t spurious = 0;   ///< less than half from one true plane, or too large a
                              ///< deviation
  std::size_t astray = 0;     ///< of these, those with only too large a deviation
  std::size_t duplicates = 0; ///< of true planes for which others have more points
};

PlaneMatches
matchPlanes(const PlaneCase& plane_case,
            const FoundPlanes& found,
            const PlaneOverlaps& overlaps,
            const MatchLimits& limits = {});

/** \brief Comparison of two plane segmentations after Hoover et al. 1996, at 80 %
 * overlap. Points without a true plane are not evaluated: they do not count for the
 * size of a detected plane, and a detected plane that mostly consists of them is not
 * noise. */
struct SegmentScores {
  std::size_t truths = 0;        ///< true planes
  std::size_t large = 0;         ///< of these, those with \ref largeCount points
  std::size_t given = 0;         ///< detected planes
  std::size_t correct = 0;       ///< true planes that match one detected plane
  std::size_t correct_large = 0; ///< of these, large ones
  std::size_t over = 0;          ///< true planes split into several detected ones
  std::size_t under = 0;         ///< detected planes that merge several true ones
  std::size_t missed = 0;        ///< true planes in none of these categories
  std::size_t noise = 0;         ///< detected planes in none of these categories

  /** \brief Percentage of the points of true planes that are in the detected plane that
   * has most of their plane's points and mostly consists of them. */
  double labels = 0;
};

SegmentScores
scoreSegments(const PlaneOverlaps& overlaps, std::size_t large_count);

} // namespace pcl::acmap::bench
