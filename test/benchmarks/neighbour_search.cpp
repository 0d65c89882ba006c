#include "dewall/ball_visit.h"
#include "figure_clouds.h"
#include "markdown_row.h"
#include "timing.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

// Search trees beside each other: FLANN's, which PCL has, nanoflann's, and that of
// DeWallTriangulation. Each finds the nearest 16 points of every point, one thread.

namespace pcl::acmap::bench {
namespace {

constexpr int neighbours = 16; // the point itself included

struct TimedSearch {
  double build = 0, search = 0; ///< CPU microseconds per point
  double sum = 0;               ///< of all squared distances, to compare the results
};

/** \brief Runs the steps of a tree. \return times per point */
template <typename Build, typename Search>
TimedSearch
timed(std::size_t points, const Build& build, const Search& search)
{
  TimedSearch result;
  const double micro = 1e6 / static_cast<double>(points);
  result.build = micro * measureThread(build);
  result.search = micro * measureThread([&] {
                    for (std::size_t i = 0; i < points; ++i)
                      result.sum += search(i);
                  });
  return result;
}

TimedSearch
byFlann(const test::Cloud& cloud)
{
  KdTreeFLANN<PointXYZ> tree(false);
  Indices found;
  std::vector<float> squared;
  return timed(
      cloud.size(),
      [&] { tree.setInputCloud(cloud.makeShared()); },
      [&](std::size_t i) {
        tree.nearestKSearch(cloud[i], neighbours, found, squared);
        double sum = 0;
        for (const float distance : squared)
          sum += distance;
        return sum;
      });
}

/** \brief A cloud as nanoflann reads it. */
struct Adaptor {
  const test::Cloud& cloud;

  std::size_t
  kdtree_get_point_count() const
  {
    return cloud.size();
  }

  float
  kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return cloud[i].data[axis];
  }

  template <typename Box>
  bool
  kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

TimedSearch
byNanoflann(const test::Cloud& cloud)
{
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Adaptor>,
                                          Adaptor,
                                          3,
                                          std::uint32_t>;
  const Adaptor adaptor{cloud};
  std::unique_ptr<Tree> tree;
  std::uint32_t found[neighbours];
  float squared[neighbours];
  return timed(
      cloud.size(),
      [&] {
        tree = std::make_unique<Tree>(
            3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(12));
      },
      [&](std::size_t i) {
        const std::size_t count =
            tree->knnSearch(cloud[i].data, neighbours, found, squared);
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k)
          sum += squared[k];
        return sum;
      });
}

/** \brief Sum of the squared distances of the nearest points, the point itself included. */
double
nearestOf(const dewall::PointTree& tree, std::int32_t i)
{
  const Eigen::Vector3d centre = tree.position(i);
  float nearest[neighbours];
  int count = 0;
  double radius = std::numeric_limits<double>::max();
  dewall::visitBall(
      tree, i, centre, radius, [&](std::int32_t, std::int32_t first, std::int32_t end) {
        for (std::int32_t k = first; k < end; ++k) {
          const auto squared =
              static_cast<float>((tree.position(k) - centre).squaredNorm());
          if (count == neighbours && squared >= nearest[count - 1])
            continue;
          int place = count < neighbours ? count++ : count - 1;
          for (; place > 0 && nearest[place - 1] > squared; --place)
            nearest[place] = nearest[place - 1];
          nearest[place] = squared;
          if (count == neighbours)
            radius = std::sqrt(static_cast<double>(nearest[count - 1]));
        }
      });
  double sum = 0;
  for (int k = 0; k < count; ++k)
    sum += nearest[k];
  return sum;
}

TimedSearch
byOurs(const test::Cloud& cloud)
{
  std::unique_ptr<dewall::PointTree> tree;
  return timed(
      cloud.size(),
      [&] {
        dewall::SourcePoints points;
        for (std::size_t i = 0; i < cloud.size(); ++i)
          points.push_back(
              {{cloud[i].x, cloud[i].y, cloud[i].z}, static_cast<std::int32_t>(i)});
        tree = std::make_unique<dewall::PointTree>(std::move(points));
      },
      [&](std::size_t i) { return nearestOf(*tree, static_cast<std::int32_t>(i)); });
}

/** \brief The cloud without repeated positions. */
test::Cloud
distinct(test::Cloud cloud)
{
  const auto key = [](const PointXYZ& p) { return std::tie(p.x, p.y, p.z); };
  std::sort(cloud.begin(), cloud.end(), [&](const PointXYZ& a, const PointXYZ& b) {
    return key(a) < key(b);
  });
  cloud.erase(std::unique(cloud.begin(),
                          cloud.end(),
                          [&](const PointXYZ& a, const PointXYZ& b) {
                            return key(a) == key(b);
                          }),
              cloud.end());
  return cloud;
}

bool
print(const FigureCloud& figure)
{
  const test::Cloud cloud = distinct(figure.cloud);
  const TimedSearch flann = byFlann(cloud), nano = byNanoflann(cloud),
                    ours = byOurs(cloud);
  MarkdownRow row;
  row.text(figure.name).count(cloud.size());
  for (const TimedSearch& tree : {flann, nano, ours})
    row.number(tree.build, 2).number(tree.search, 2);
  row.text(timesOf(flann.build + flann.search, ours.build + ours.search)).print();
  const bool are_same = std::abs(flann.sum - ours.sum) < 1e-3 * flann.sum &&
                        std::abs(nano.sum - ours.sum) < 1e-3 * nano.sum;
  if (!are_same)
    std::printf("the trees do not agree: %g, %g, %g\n", flann.sum, nano.sum, ours.sum);
  return are_same;
}

} // namespace
} // namespace pcl::acmap::bench

int
main()
{
  using namespace pcl::acmap::bench;
  printHead({"cloud",
             "points",
             "FLANN build, us a point",
             "search of 16",
             "nanoflann build",
             "search",
             "ours build",
             "search",
             "FLANN : ours"});
  bool are_same = true;
  for (const FigureCloud& figure : singleViews())
    are_same = print(figure) && are_same;
  return are_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
