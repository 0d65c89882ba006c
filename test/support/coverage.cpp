#include "coverage.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Counts, for each sample point of a rectangle, the triangles above it. */
class Raster {
public:
  Raster(const Eigen::Vector2d& minimum, const Eigen::Vector2d& maximum, double step)
  : minimum_(minimum)
  , step_(step)
  , columns_(std::max(0, static_cast<int>((maximum.x() - minimum.x()) / step)))
  , rows_(std::max(0, static_cast<int>((maximum.y() - minimum.y()) / step)))
  , counts_(static_cast<std::size_t>(columns_) * rows_, 0)
  {}

  void
  add(const std::array<Eigen::Vector2d, 3>& corners)
  {
    const Eigen::Vector2d low =
        (corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - minimum_) / step_;
    const Eigen::Vector2d high =
        (corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) - minimum_) / step_;
    const int last_row = std::min(rows_ - 1, static_cast<int>(std::floor(high.y())));
    const int last_column =
        std::min(columns_ - 1, static_cast<int>(std::floor(high.x())));
    for (int row = std::max(0, static_cast<int>(low.y()) - 1); row <= last_row; ++row)
      for (int column = std::max(0, static_cast<int>(low.x()) - 1);
           column <= last_column;
           ++column)
        if (contains(corners, sample(column, row)))
          ++counts_[static_cast<std::size_t>(row) * columns_ + column];
  }

  Coverage
  coverage() const
  {
    const auto share = [&](auto predicate) {
      return 100.0 *
             static_cast<double>(
                 std::count_if(counts_.begin(), counts_.end(), predicate)) /
             static_cast<double>(std::max<std::size_t>(1, counts_.size()));
    };
    return {share([](int count) { return count == 0; }),
            share([](int count) { return count > 1; })};
  }

private:
  /** Sample position off the centre of its cell, so that no edge of a regular mesh
   * passes through samples. */
  Eigen::Vector2d
  sample(int column, int row) const
  {
    return minimum_ + step_ * Eigen::Vector2d(column + 0.5137, row + 0.4791);
  }

  static bool
  contains(const std::array<Eigen::Vector2d, 3>& corners, const Eigen::Vector2d& p)
  {
    int turns = 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d edge = corners[(i + 1) % 3] - corners[i];
      const Eigen::Vector2d arm = p - corners[i];
      turns += edge.x() * arm.y() > edge.y() * arm.x() ? 1 : -1;
    }
    return turns == 3 || turns == -3;
  }

  Eigen::Vector2d minimum_;
  double step_;
  int columns_;
  int rows_;
  std::vector<int> counts_;
};

} // namespace

Coverage
measureCoverage(const SheetCloud& sheet,
                const Triangles& mesh,
                double margin,
                double resolution)
{
  const Eigen::Vector2d rim = Eigen::Vector2d::Constant(margin * sheet.spacing);
  Raster raster(sheet.minimum + rim, sheet.maximum - rim, sheet.spacing / resolution);
  for (const Triangle& face : mesh)
    raster.add({sheet.parameters[face[0]],
                sheet.parameters[face[1]],
                sheet.parameters[face[2]]});
  return raster.coverage();
}

} // namespace pcl::acmap::test
