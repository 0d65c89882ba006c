#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/image_file.h>
#include <pcl/core/report.h>

#include <cstdint>

namespace pcl {

/** \brief What is known of the last pattern. \ingroup acquisition */
struct RandomLinePatternReport : Report {
  int lines = 0;       ///< drawn, those included that others hide or that miss it
  int redraws = 0;     ///< patterns rejected before, for their side lobes
  double coverage = 0; ///< share of the pixels that are lit

  /** \brief Highest side lobe but for the worst 1 % of the rows: what is gated. */
  double row_side_lobe = 0;
  double column_side_lobe = 0;
  double worst_row_side_lobe = 0; ///< of all rows looked at
  double worst_column_side_lobe = 0;
};

/** \brief Patterns of random lines that a projector casts on walls without texture, so
 * that stereo finds something there. Section II-A of "Active Stereo Based Compact
 * Mapping": N patterns of L lines of random orientation, intensity and colour.
 *
 * The paper names no law. Here lines are uniform (Cauchy, Crofton): any part of the
 * pattern is hit as often as any other of its size, in every direction. The angle phi
 * from the rows is uniform in [0, pi), the signed distance rho from the middle in
 * [-D/2, D/2], D the diagonal. Widths are whole pixels, uniform between the bounds;
 * intensities uniform in 64..255 on black. Later lines cover earlier ones. No pixel is
 * mixed of two.
 *
 * A pattern that looks like itself a few pixels further misleads stereo. So a side lobe
 * is measured along rows and columns: the highest correlation coefficient of a row with
 * itself, shifted within the disparity range, behind the main lobe. A pattern with 0.5
 * or more in over 1 % of its rows or columns (256 of each are looked at: in four or
 * more) is drawn again, at most 16 times; then the best of them is taken, and the report
 * says so. The 1 % leaves room for a line that lies along rows and leaves no contrast in
 * them, which the other patterns make good.
 *
 * The same settings and number give the same bytes on every machine. Time O(lines *
 * diagonal * line width) to paint; the gate takes the length of 512 rows times the
 * disparity range; together 10 ms.
 * \code
 * pcl::RandomLinePattern pattern;
 * pattern.setSize (1024, 768);
 * const pcl::RgbImage first = pattern.generate (0);
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT RandomLinePattern {
public:
  /** \brief Sets the pattern's size, which is the projector's (default 1024 x 768).
   * \throws BadArgumentException unless both are within [16, 8192] px */
  void
  setSize(int width, int height);

  int
  getWidth() const
  {
    return width_;
  }

  int
  getHeight() const
  {
    return height_;
  }

  /** \brief Sets L, the number of lines of a pattern (default 200, the paper's).
   * \throws BadArgumentException unless within [1, 10000] lines */
  void
  setNumberOfLines(int lines);

  int
  getNumberOfLines() const
  {
    return lines_;
  }

  /** \brief Sets the bounds of the lines' widths (default 2 and 6 px). The narrowest
   * should be two pixels of the projector for each one of the camera.
   * \throws BadArgumentException unless 1 <= least <= most <= 64 px */
  void
  setLineWidths(int least, int most);

  int
  getLeastLineWidth() const
  {
    return least_line_width_;
  }

  int
  getMostLineWidth() const
  {
    return most_line_width_;
  }

  /** \brief Sets whether each channel has an intensity of its own (default true, the
   * paper), else lines are grey. */
  void
  setColored(bool colored)
  {
    colored_ = colored;
  }

  bool
  getColored() const
  {
    return colored_;
  }

  /** \brief Sets the least angle between a line and the rows (default 0). Lines along
   * the rows tell a horizontal pair of cameras nothing; for rigs that have no vertical
   * pair 15 degrees (0.26) are right. Above 0 only rows are gated.
   * \throws BadArgumentException unless within [0, 1.5] rad */
  void
  setMinimumAngle(double radians);

  double
  getMinimumAngle() const
  {
    return minimum_angle_;
  }

  /** \brief Sets how far, in pixels of the projector, matches are searched: the side
   * lobes' range (default 64). At most half of a row or column is looked at.
   * \throws BadArgumentException unless within [4, 1024] px */
  void
  setDisparityRange(int pixels);

  int
  getDisparityRange() const
  {
    return disparity_range_;
  }

  /** \brief Sets what all randomness begins with (default 1). */
  void
  setSeed(std::uint64_t seed)
  {
    seed_ = seed;
  }

  std::uint64_t
  getSeed() const
  {
    return seed_;
  }

  /** \brief Draws a pattern of the seed.
   * \param[in] index which one, whatever others were drawn before
   * \return of the set size */
  RgbImage
  generate(std::uint32_t index);

  /** \brief Counts, seconds and remarks of the last pattern. */
  const RandomLinePatternReport&
  getReport() const
  {
    return report_;
  }

private:
  int width_ = 1024;
  int height_ = 768;
  int lines_ = 200;
  int least_line_width_ = 2;
  int most_line_width_ = 6;
  bool colored_ = true;
  double minimum_angle_ = 0;
  int disparity_range_ = 64;
  std::uint64_t seed_ = 1;
  RandomLinePatternReport report_;
};

} // namespace pcl
