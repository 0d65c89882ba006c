#include <pcl/core/impl/nearest_points.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <vector>

namespace pcl::acmap {

struct NearestPoints::Tree {
  KdTreeFLANN<PointXYZ> flann;
  std::size_t points = 0;

  template <typename Points>
  static std::unique_ptr<Tree>
  of(const Points& points)
  {
    const PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
    cloud->is_dense = false;
    cloud->reserve(points.size());
    for (const auto& point : points)
      cloud->emplace_back(static_cast<float>(point.x()),
                          static_cast<float>(point.y()),
                          static_cast<float>(point.z()));
    const bool is_any =
        std::any_of(cloud->begin(), cloud->end(), [](const PointXYZ& point) {
          return point.getVector3fMap().allFinite();
        });
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
  if (!tree_ || count == 0 || !place.allFinite())
    return;
  std::vector<float> distances;
  tree_->flann.nearestKSearch(PointXYZ(place.x(), place.y(), place.z()),
                              static_cast<unsigned>(std::min(count, tree_->points)),
                              found,
                              distances);
}

} // namespace pcl::acmap
