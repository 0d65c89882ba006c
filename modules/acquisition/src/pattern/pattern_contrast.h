#pragma once

#include <pcl/core/image_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Grey levels of a pattern at every fourth pixel of every fourth row. */
class PatternSamples {
public:
  static constexpr int step = 4; ///< px

  explicit PatternSamples(const RgbImage& pattern)
  : columns_(pattern.width / step)
  , rows_(pattern.height / step)
  {
    levels_.reserve(static_cast<std::size_t>(columns_) *
                    static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        levels_.push_back(levelAt(pattern, column, row));
  }

  /** \brief Calls visit (pair, difference) for all pairs of samples in a row or column
   * that are at most \a reach samples apart, always in the same order. */
  template <typename Visit>
  void
  forPairs(int reach, const Visit& visit) const
  {
    std::size_t pair = 0;
    const auto visitPair = [&](std::size_t at, std::size_t other) {
      visit(pair++, levels_[at] - levels_[other]);
    };
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const std::size_t at = indexOf(column, row);
        for (int i = 1; i <= std::min(reach, columns_ - 1 - column); ++i)
          visitPair(at, indexOf(column + i, row));
        for (int i = 1; i <= std::min(reach, rows_ - 1 - row); ++i)
          visitPair(at, indexOf(column, row + i));
      }
  }

private:
  static std::uint8_t
  levelAt(const RgbImage& pattern, int column, int row)
  {
    const auto pixel = static_cast<std::size_t>(step * row + step / 2) *
                           static_cast<std::size_t>(pattern.width) +
                       static_cast<std::size_t>(step * column + step / 2);
    const std::uint8_t* const color = &pattern.values[3 * pixel];
    return static_cast<std::uint8_t>((77 * color[0] + 150 * color[1] + 29 * color[2]) /
                                     256);
  }

  std::size_t
  indexOf(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_, rows_;
  std::vector<std::uint8_t> levels_;
};

} // namespace pcl::acmap
