#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/surface/dewall_triangulation.h>

#include <cstring>
#include <limits>
#include <string>

namespace pcl {

void
DeWallParameters::setAcceptanceRule(DeWallRule rule)
{
  if (rule != DeWallRule::Paper && rule != DeWallRule::Dense &&
      rule != DeWallRule::Strict)
    acmap::refuseArgument(
        "acceptance rule", static_cast<int>(rule), "Paper, Dense or Strict");
  rule_ = rule;
}

void
DeWallParameters::setMaximumEdgeLength(double length)
{
  acmap::requireInRange("maximum edge length", length, 0.0, 1e9, "m (0 = automatic)");
  maximum_edge_length_ = length;
}

void
DeWallParameters::setLeafSize(int points)
{
  acmap::requireInRange("leaf size",
                        points,
                        0,
                        std::numeric_limits<int>::max(),
                        "points (0 = automatic)");
  leaf_size_ = points;
}

void
DeWallParameters::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

acmap::DeWallSettings
DeWallParameters::kernelSettings() const
{
  acmap::DeWallSettings settings;
  settings.rule = rule_;
  settings.maximum_edge_length = maximum_edge_length_;
  settings.up = up_;
  settings.compute_wall_depth = compute_wall_depth_;
  settings.leaf_size = leaf_size_;
  settings.threads = threads_;
  settings.memory_limit = memory_limit_;
  return settings;
}

namespace {

/** \brief Normals of the rows of a cloud. Where their fields are not side by side, they are
 * copied. */
class RowNormals {
public:
  explicit RowNormals(const CloudRows& rows)
  : view_(acmap::normalsOf(rows))
  {
    if (view_.size() > 0)
      return;
    const PCLPointCloud2& layout = rows.layout();
    std::array<std::size_t, 3> offsets{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PCLPointField* const field = acmap::findField(
          layout, acmap::normal_field_names[axis], PCLPointField::FLOAT32);
      if (!field)
        return;
      offsets[axis] = field->offset;
    }
    copy_.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::memcpy(&copy_[i][axis],
                    rows.data() + i * layout.point_step + offsets[axis],
                    sizeof(float));
    view_ = acmap::PointView(copy_.data(), sizeof copy_[0], copy_.size());
  }

  const acmap::PointView&
  view() const
  {
    return view_;
  }

private:
  LargeVector<std::array<float, 3>> copy_;
  acmap::PointView view_;
};

} // namespace

void
DeWallTriangulation<PCLPointCloud2>::setSensorOrigin(const Eigen::Vector3f& origin)
{
  acmap::requireViewpoints({origin});
  sensor_origin_ = origin;
}

void
DeWallTriangulation<PCLPointCloud2>::reconstruct(TriangleMesh& mesh)
{
  const acmap::PointView view = acmap::requirePoints(rows_);
  const RowNormals normals(rows_);
  acmap::DeWallSettings settings = kernelSettings();
  settings.sensor_origin = sensor_origin_.cast<double>();
  settings.normals = normals.view();
  settings.is_single_view =
      rows_.layout().height > 1 &&
      acmap::isSingleView(view, rows_.layout().width, settings.sensor_origin);
  DeWallReport report;
  TriangleMesh result =
      acmap::triangulateDeWall(view, settings, acmap::Progress(progress_), report);
  mesh = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl
