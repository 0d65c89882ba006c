#include "bench.h"
#include "bench_data.h"
#include "dewall/ball_visit.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <nanoflann.hpp>

#include <memory>
#include <numeric>
#include <tuple>

// Search trees beside each other: FLANN's, which PCL has, nanoflann's, and that of
// DeWallTriangulation. Each finds the nearest 16 points of every point, one thread.

namespace pcl::acmap::bench {
namespace {

constexpr int neighbours = 16; // the point itself included

struct TimedSearch {
  double build = 0, search = 0; ///< CPU microseconds per point
  double sum = 0;               ///< of all squared distances, to compare the results
};

/** \brief Runs the steps of a tree.
 * \param[in] search gives the sum of the squared distances of a point's neighbours */
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
        return std::accumulate(squared.begin(), squared.end(), 0.0);
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
  using Metric = nanoflann::L2_Simple_Adaptor<float, Adaptor>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Adaptor, 3, std::uint32_t>;
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
        const auto count = tree->knnSearch(cloud[i].data, neighbours, found, squared);
        return std::accumulate(squared, squared + count, 0.0);
      });
}

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
  return std::accumulate(nearest, nearest + count, 0.0);
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
  const auto isLess = [&](auto& a, auto& b) { return key(a) < key(b); };
  const auto isSame = [&](auto& a, auto& b) { return key(a) == key(b); };
  std::sort(cloud.begin(), cloud.end(), isLess);
  cloud.erase(std::unique(cloud.begin(), cloud.end(), isSame), cloud.end());
  return cloud;
}

const Section search_section("search", [] {
  printHead("cloud | points | FLANN build, us a point | search of 16 | nanoflann build "
            "| search | ours build | search | FLANN : ours");
  for (const FigureCloud& view : singleViews()) {
    const test::Cloud cloud = distinct(view.cloud);
    const TimedSearch flann = byFlann(cloud), nano = byNanoflann(cloud),
                      ours = byOurs(cloud);
    Row row;
    row << view.name << cloud.size();
    for (const TimedSearch& tree : {flann, nano, ours}) {
      row << figure(tree.build, 2) << figure(tree.search, 2);
      if (!(std::abs(tree.sum - flann.sum) < 1e-3 * flann.sum))
        std::cerr << "the trees do not agree: " << tree.sum << ", " << flann.sum
                  << '\n';
    }
    row << timesOf(flann.build + flann.search, ours.build + ours.search);
  }
});

} // namespace
} // namespace pcl::acmap::bench
