#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/image_file.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

class RandomLinePattern;

namespace acmap {
class PatternSamples;
}

/** \brief Chooses the next pattern of an observation among candidates: the one that
 * distinguishes best what the patterns before did not. With chosen patterns an
 * observation needs fewer of them than with random ones.
 *
 * Stereo confuses two points of a row or column whose light was similar in all shots.
 * Which points of the projector's image these are does not depend on the scene:
 * therefore neither the pose of the projector nor a shot is needed, and a sequence is
 * chosen once for all observations. Points are sampled every 4 pixels. A pair of them
 * within the disparity range is distinguished by the sum of its squared differences of
 * grey levels over the patterns, up to the contrast that suffices; a candidate's gain
 * is what it adds to these sums.
 *
 * The same patterns give the same choice on every machine. A candidate takes time
 * O(pixels * disparity range / 64). \code
 * pcl::RandomLinePattern lines;
 * const auto patterns = pcl::PatternSelection ().selectFrom (lines, 7);
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT PatternSelection {
public:
  /** \brief Sets the range in which points are confused, in pixels of the projector
   * (default 64).
   * \throws BadArgumentException unless within [4, 1024] px */
  void
  setDisparityRange(int pixels);

  int
  getDisparityRange() const
  {
    return disparity_range_;
  }

  /** \brief Sets the root of the sum of squared differences that suffices (default 400
   * grey levels); more is not rewarded.
   * \throws BadArgumentException unless within [1, 4000] levels */
  void
  setSufficientContrast(double levels);

  double
  getSufficientContrast() const
  {
    return contrast_;
  }

  /** \brief Sets the number of candidates among which \ref selectFrom chooses each
   * pattern (default 120).
   * \throws BadArgumentException unless within [1, 1000] */
  void
  setNumberOfCandidates(int candidates);

  int
  getNumberOfCandidates() const
  {
    return candidates_;
  }

  /** \brief Adds a pattern that is shown. Settings must not change afterwards.
   * \throws BadArgumentException for an incomplete pattern, or one of another size than
   * those before */
  void
  add(const RgbImage& pattern);

  /** \brief Returns what a pattern would add, without adding it.
   * \throws BadArgumentException as \ref add */
  std::uint64_t
  gainOf(const RgbImage& pattern) const;

  /** \brief Forgets the patterns that were added. */
  void
  clear();

  /** \brief Chooses patterns one after another. The candidates are those that a
   * generator draws from number 0 on; each choice is replaced by the next number, and
   * of equal candidates the one with the lowest number is chosen. Patterns that were
   * added before count. \return as many patterns as requested, all of which are added
   * \throws BadArgumentException if their size differs from those added before */
  std::vector<RgbImage>
  selectFrom(RandomLinePattern& generator, std::size_t count);

private:
  struct Candidate;

  std::uint64_t
  gainOf(const acmap::PatternSamples& samples) const;
  std::vector<Candidate>::iterator
  bestOf(std::vector<Candidate>& candidates, std::size_t patterns) const;
  void
  requireFitting(const RgbImage& pattern) const;

  int disparity_range_ = 64;
  double contrast_ = 400;
  int candidates_ = 120;
  int width_ = 0, height_ = 0; // of the patterns, 0 before the first one
  std::vector<std::uint32_t> sums_;
};

} // namespace pcl
