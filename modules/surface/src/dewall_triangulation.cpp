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
  if (rule != DeWallRule::Guarded && rule != DeWallRule::Dense &&
      rule != DeWallRule::Strict)
    acmap::refuseArgument(
        "acceptance rule", static_cast<int>(rule), "Paper, Dense or Strict");
  settings_.rule = rule;
}

void
DeWallParameters::setMaximumEdgeLength(double length)
{
  acmap::requireInRange("maximum edge length", length, 0.0, 1e9, "m (0 = automatic)");
  settings_.maximum_edge_length = length;
}

void
DeWallParameters::setLeafSize(int points)
{
  acmap::requireInRange("leaf size",
                        points,
                        0,
                        std::numeric_limits<int>::max(),
                        "points (0 = automatic)");
  settings_.leaf_size = points;
}

void
DeWallParameters::setUpDirection(const Eigen::Vector3d& up)
{
  settings_.up = acmap::requiredDirection(up);
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
  is_sensor_stated_ = true;
}

void
DeWallTriangulation<PCLPointCloud2>::reconstruct(TriangleMesh& mesh)
{
  acmap::DeWallInput input;
  input.points = acmap::requirePoints(rows_);
  const RowNormals normals(rows_);
  input.sensor_origin = sensor_origin_.cast<double>();
  input.normals = normals.view();
  acmap::takeSensor(
      rows_.layout().height > 1 ? rows_.layout().width : 0, is_sensor_stated_, input);
  if (scan_) {
    input.scan = acmap::requirePoints(scan_);
    input.scan_edge = scan_edge_;
  }
  input.threads = threads_;
  DeWallReport report;
  TriangleMesh result =
      acmap::triangulateDeWall(input, settings(), acmap::Progress(progress_), report);
  mesh = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl
