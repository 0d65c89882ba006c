#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/image_file.h>
#include <pcl/core/report.h>

#include <cstdint>

namespace pcl {

/** \brief Statistics of the last pattern. \ingroup acquisition */
struct RandomLinePatternReport : Report {
  int lines = 0;   ///< lines drawn, including hidden ones and ones outside the image
  int redraws = 0; ///< patterns that were rejected because of their side lobes
  double coverage = 0; ///< fraction of the pixels that are lit

  /** \brief Highest side lobe, ignoring the worst 1 % of the rows. This value decides
   * about rejection. */
  double row_side_lobe = 0;
  double column_side_lobe = 0;
  double worst_row_side_lobe = 0; ///< maximum over all rows that were examined
  double worst_column_side_lobe = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RandomLinePatternReport& report, Visitor&& visit)
{
  visit({"lines"}, report.lines);
  visit({"coverage"}, report.coverage);
  visit({"redraws"}, report.redraws);
  visit({"row_side_lobe"}, report.row_side_lobe);
  visit({"column_side_lobe"}, report.column_side_lobe);
  visit({"worst_row_side_lobe"}, report.worst_row_side_lobe);
  visit({"worst_column_side_lobe"}, report.worst_column_side_lobe);
}

/** \brief Generates patterns of random lines. A projector shows them on walls without
 * texture, so that stereo matching finds features there. Section II-A of "Active Stereo
 * Based Compact Mapping": N patterns of L lines of random orientation, intensity and
 * colour.
 *
 * The paper does not specify the distributions. Here the lines are uniformly
 * distributed (Cauchy, Crofton): all parts of the pattern of equal size are hit with
 * equal probability, in every direction. The angle phi from the rows is uniform in [0,
 * pi), the signed distance rho from the centre is uniform in [-D/2, D/2], where D is
 * the diagonal. Widths are integer numbers of pixels, uniform between the bounds;
 * intensities are uniform in 64..255 on black. Later lines cover earlier ones. There is
 * no blending of pixels.
 *
 * A pattern that is similar to itself at a shift of a few pixels causes wrong matches.
 * Therefore a side lobe is measured along rows and columns: the maximum correlation
 * coefficient of a row with itself, over the shifts within the disparity range that are
 * beyond the main lobe. A pattern with 0.5 or more in over 1 % of its rows or columns
 * (256 of each are examined: in four or more) is rejected and drawn again, at most 16
 * times; if all are rejected, the best of them is used, and the report contains a
 * remark. The 1 % tolerance is needed for lines parallel to the rows, which leave no
 * contrast in them; the other patterns compensate for this.
 *
 * The same settings and index give identical bytes on every machine. Painting takes
 * time O(lines * diagonal * line width); the side lobe test takes time proportional to
 * the length of 512 rows times the disparity range; both together take 10 ms.
 * \code
 * pcl::RandomLinePattern pattern;
 * pattern.setSize (1024, 768);
 * const pcl::RgbImage first = pattern.generate (0);
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT RandomLinePattern {
public:
  /** \brief Sets the size of the pattern, which should be that of the projector
   * (default 1024 x 768).
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

  /** \brief Sets L, the number of lines of a pattern (default 200, as in the paper).
   * \throws BadArgumentException unless within [1, 10000] lines */
  void
  setNumberOfLines(int lines);

  int
  getNumberOfLines() const
  {
    return lines_;
  }

  /** \brief Sets the minimum and maximum line width (default 2 and 6 px). The minimum
   * should be two pixels of the projector per pixel of the camera.
   * \throws BadArgumentException unless 1 <= least <= most <= 64 px */
  void
  setLineWidths(int minimum, int maximum);

  int
  getLeastLineWidth() const
  {
    return min_line_width_;
  }

  int
  getMostLineWidth() const
  {
    return max_line_width_;
  }

  /** \brief Sets whether each colour channel has its own intensity (default true, as in
   * the paper); otherwise lines are grey. */
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

  /** \brief Sets the minimum angle between a line and the rows, in radians (default 0).
   * Lines parallel to the rows carry no information for a horizontal pair of cameras;
   * 15 degrees (0.26) are recommended for rigs without a vertical pair. If the angle is
   * above 0, only rows are tested for side lobes.
   * \throws BadArgumentException unless within [0, 1.5] rad */
  void
  setMinimumAngle(double radians);

  double
  getMinimumAngle() const
  {
    return minimum_angle_;
  }

  /** \brief Sets the disparity range of the matching, in pixels of the projector
   * (default 64); side lobes are searched within it. At most half of a row or column is
   * examined.
   * \throws BadArgumentException unless within [4, 1024] px */
  void
  setDisparityRange(int pixels);

  int
  getDisparityRange() const
  {
    return disparity_range_;
  }

  /** \brief Sets the seed of the random numbers (default 1). */
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

  /** \brief Generates a pattern.
   * \param[in] index of the pattern; the result does not depend on earlier calls
   * \return a pattern of the size that was set */
  RgbImage
  generate(std::uint32_t index);

  /** \brief Statistics, run time and remarks of the last pattern. */
  const RandomLinePatternReport&
  getReport() const
  {
    return report_;
  }

private:
  int width_ = 1024;
  int height_ = 768;
  int lines_ = 200;
  int min_line_width_ = 2;
  int max_line_width_ = 6;
  bool colored_ = true;
  double minimum_angle_ = 0;
  int disparity_range_ = 64;
  std::uint64_t seed_ = 1;
  RandomLinePatternReport report_;
};

} // namespace pcl
