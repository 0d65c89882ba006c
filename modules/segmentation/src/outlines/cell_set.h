#pragma once

#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::acmap::outlines {

/** A set of cells of a grid, one bit per cell. Cells outside the grid are not members. */
class CellSet {
public:
  using Word = std::uint64_t;

  CellSet() = default;
  CellSet(int width, int height);

  int
  width() const
  {
    return width_;
  }

  int
  height() const
  {
    return height_;
  }

  bool
  isInside(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }

  bool
  has(int x, int y) const
  {
    return isInside(x, y) && (row(y)[x >> 6] >> (x & 63) & 1) != 0;
  }

  /** Is the cell that contains a place a member? */
  bool
  has(const Eigen::Vector2d& place) const
  {
    return has(static_cast<int>(std::floor(place.x())),
               static_cast<int>(std::floor(place.y())));
  }

  /** Are the four cells \a reach cells along the axes from a place members? */
  bool
  hasAround(const Eigen::Vector2d& place, int reach) const
  {
    const int x = static_cast<int>(std::floor(place.x()));
    const int y = static_cast<int>(std::floor(place.y()));
    return has(x - reach, y) && has(x + reach, y) && has(x, y - reach) &&
           has(x, y + reach);
  }

  void
  add(int x, int y)
  {
    if (isInside(x, y))
      row(y)[x >> 6] |= Word{1} << (x & 63);
  }

  /** Adds the cells [from, to) of a row; they are clipped to the grid. */
  void
  addRun(int y, int from, int to);

  void
  remove(int x, int y)
  {
    if (isInside(x, y))
      row(y)[x >> 6] &= ~(Word{1} << (x & 63));
  }

  Word*
  row(int y)
  {
    return words_.data() + static_cast<std::size_t>(y) * words_a_row_;
  }

  const Word*
  row(int y) const
  {
    return words_.data() + static_cast<std::size_t>(y) * words_a_row_;
  }

  std::size_t
  wordsOfRow() const
  {
    return words_a_row_;
  }

  CellSet&
  operator|=(const CellSet& other);

  CellSet&
  operator&=(const CellSet& other);

  /** Removes the cells of another set. */
  CellSet&
  operator-=(const CellSet& other);

  CellSet
  complement() const;

  /** Adds all cells whose centres are within \a radius cells of a member. */
  CellSet
  dilated(double radius) const;

  /** Keeps the cells all of whose neighbours within \a radius cells are members. */
  CellSet
  eroded(double radius) const
  {
    return complement().dilated(radius).complement();
  }

private:
  void
  trim();

  int width_ = 0, height_ = 0;
  std::size_t words_a_row_ = 0;
  LargeVector<Word> words_; // coplanar walls of a long building span all of it
};

/** Members of one row that are side by side: [from, to). */
struct CellRun {
  int y, from, to;
};

/** Connected parts of a set, each as its runs in the order of rows.
 * \param[in] is_diagonal are cells that share only a corner connected? */
std::vector<std::vector<CellRun>>
partsOf(const CellSet& cells, bool is_diagonal);

/** Number of cells of a part. */
std::int64_t
sizeOf(const std::vector<CellRun>& part);

/** A closed boundary as corners of cells one cell apart; corner (x, y) is that of the
 * cell (x, y) that is nearest to the origin. */
using CellLoop = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** Boundaries with the members on their left. Members that share only a corner are not
 * connected. */
std::vector<CellLoop>
boundariesOf(const CellSet& cells);

} // namespace pcl::acmap::outlines
