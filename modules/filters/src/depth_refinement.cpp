#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/filters/impl/depth_refinement.hpp>
#include <pcl/filters/impl/depth_refinement_kernel.h>

#include <cstring>
#include <limits>

namespace pcl {

namespace {

void
setPosition(PCLPointCloud2& cloud,
            std::size_t row,
            std::size_t offset,
            const Eigen::Vector3f& point)
{
  std::memcpy(
      &cloud.data[row * cloud.point_step + offset], point.data(), 3 * sizeof(float));
}

/** Removes the positions of all rows but those. */
void
keepOnly(const Indices& indices, PCLPointCloud2& cloud)
{
  std::vector<bool> is_chosen(acmap::rowsOf(cloud), false);
  for (const index_t index : indices)
    is_chosen[static_cast<std::size_t>(index)] = true;
  const Eigen::Vector3f none =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  const std::size_t offset = acmap::findField(cloud, "x")->offset;
  for (std::size_t row = 0; row < is_chosen.size(); ++row)
    if (!is_chosen[row])
      setPosition(cloud, row, offset, none);
}

void
setPoints(const acmap::RefinedDepth& refined, PCLPointCloud2& cloud)
{
  std::vector<acmap::FieldWish> wishes;
  for (const char* name : acmap::normal_field_names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  const std::uint32_t width = cloud.width, height = cloud.height;
  cloud = acmap::withFields(std::move(cloud), wishes);
  cloud.width = width;
  cloud.height = height;
  cloud.row_step = width * cloud.point_step;
  const std::size_t offset = acmap::findField(cloud, "x")->offset;
  for (std::size_t i = 0; i < refined.points.size(); ++i)
    setPosition(cloud, i, offset, refined.points[i]);
  for (std::size_t axis = 0; axis < acmap::normal_field_names.size(); ++axis) {
    const std::size_t normal =
        acmap::findField(cloud, acmap::normal_field_names[axis])->offset;
    for (std::size_t i = 0; i < refined.normals.size(); ++i)
      acmap::setValue(
          cloud, i, normal, refined.normals[i][static_cast<Eigen::Index>(axis)]);
  }
}

} // namespace

DepthRefinement<PCLPointCloud2>::DepthRefinement()
{
  filter_name_ = "DepthRefinement";
}

void
DepthRefinement<PCLPointCloud2>::setInputCloud(const PCLPointCloud2ConstPtr& cloud)
{
  acmap::requireGiven(cloud);
  Filter<PCLPointCloud2>::setInputCloud(cloud);
}

void
DepthRefinement<PCLPointCloud2>::setPlanes(const std::vector<PlanePatch>& patches,
                                           const PointLabels& labels)
{
  planes_ = acmap::depthPlanesOf(patches, labels);
}

void
DepthRefinement<PCLPointCloud2>::filter(PCLPointCloud2& output)
{
  applyFilter(output);
}

void
DepthRefinement<PCLPointCloud2>::applyFilter(PCLPointCloud2& output)
{
  const Indices* const wanted = fake_indices_ ? nullptr : indices_.get();
  acmap::requirePoints(input_, wanted);
  const std::size_t rows = acmap::rowsOf(*input_);
  if (rows > 0 && input_->height < 2)
    acmap::refuseUnorganized();
  if (!planes_.labels.empty() && planes_.labels.size() != rows)
    throw acmap::InitFailed("the planes have ",
                            planes_.labels.size(),
                            " labels, the cloud has ",
                            rows,
                            " points");
  const PCLPointCloud2::Ptr result(new PCLPointCloud2(*input_));
  if (wanted)
    keepOnly(*wanted, *result);
  const acmap::PointView points = acmap::requirePoints(result);
  DepthRefinementReport report;
  report.points = report.invalid_points = rows;
  if (const auto seen = acmap::measureDepthView(points, result->width))
    setPoints(acmap::refineDepth(seen->view,
                                 seen->noise,
                                 planes_.labels.empty() ? nullptr : &planes_,
                                 threads_,
                                 acmap::Progress(progress_),
                                 report),
              *result);
  else
    report.remarks.push_back(std::string("nothing was refined: ") +
                             acmap::no_depth_view);
  result->is_dense = 0;
  output = std::move(*result);
  report_ = std::move(report);
}

} // namespace pcl

PCL_INSTANTIATE(DepthRefinement, ACMAP_ALL_POINT_TYPES)
