#include <pcl/core/impl/nearest_points.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

/** FLANN aborts where squares of distances are more than a float can be. */
constexpr float farthest = 1e18F; // metres

template <typename Point>
bool
isUsable(const Point& point)
{
  return (point.array().abs() <= farthest).all(); // false if it is not finite, too
}

} // namespace

struct NearestPoints::Tree {
  KdTreeFLANN<PointXYZ> flann;
  std::size_t points = 0;

  template <typename Points>
  static std::unique_ptr<Tree>
  of(const Points& points)
  {
    const PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
    cloud->is_dense = false; // PCL leaves out what is not finite
    cloud->reserve(points.size());
    bool is_any = false;
    for (const auto& point : points) {
      cloud->emplace_back();
      auto place = cloud->back().getVector3fMap();
      if (isUsable(point))
        place = point.template cast<float>();
      else
        place.setConstant(std::numeric_limits<float>::quiet_NaN());
      is_any = is_any || isUsable(point);
    }
    if (!is_any) // PCL's tree of nothing must not be asked
      return nullptr;
    auto tree = std::make_unique<Tree>();
    tree->flann.setInputCloud(cloud);
    tree->points = points.size();
    return tree;
  }
};

NearestPoints::NearestPoints(const LargeVector<Eigen::Vector3d>& points)
: tree_(Tree::of(points))
{}

NearestPoints::NearestPoints(const std::vector<Eigen::Vector3f>& points)
: tree_(Tree::of(points))
{}

NearestPoints::~NearestPoints() = default;
NearestPoints::NearestPoints(NearestPoints&&) noexcept = default;

void
NearestPoints::find(const Eigen::Vector3f& place,
                    std::size_t count,
                    Indices& found) const
{
  found.clear();
  if (!tree_ || count == 0 || !isUsable(place))
    return;
  std::vector<float> distances;
  tree_->flann.nearestKSearch(PointXYZ(place.x(), place.y(), place.z()),
                              static_cast<unsigned>(std::min(count, tree_->points)),
                              found,
                              distances);
}

} // namespace pcl::acmap
