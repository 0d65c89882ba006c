#include "byte_source.h"
#include "point_cloud_readers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace pcl::acmap {

namespace {

constexpr std::uint64_t max_points = std::numeric_limits<std::int32_t>::max();

[[noreturn]] void
refusePoints(std::uint64_t points, const std::string& size, const ByteSource& source)
{
  source.fail("header claims " + std::to_string(points) + " points of " + size + ", " +
              std::to_string(source.remaining()) + " bytes follow");
}

void
requireCountable(std::uint64_t points, const ByteSource& source)
{
  if (points > max_points)
    source.fail("holds " + std::to_string(points) + " points; an index counts " +
                std::to_string(max_points) + " at most");
}

} // namespace

void
requirePointsFit(std::uint64_t points, std::uint64_t bytes, const ByteSource& source)
{
  if (bytes == 0 || points > source.remaining() / bytes)
    refusePoints(points, std::to_string(bytes) + " bytes", source);
  requireCountable(points, source);
}

void
requireTextPointsFit(std::uint64_t points,
                     std::uint64_t values,
                     const ByteSource& source)
{
  // A value takes at least a character and a separator; the last separator may be
  // missing.
  if (points > (source.remaining() + 1) / (2 * values))
    refusePoints(points, std::to_string(values) + " values", source);
  requireCountable(points, source);
}

void
shapeCloud(PCLPointCloud2& cloud,
           const FieldLayout& layout,
           std::uint64_t width,
           std::uint64_t height)
{
  cloud.fields = layout.fields;
  cloud.width = static_cast<uindex_t>(width);
  cloud.height = static_cast<uindex_t>(height);
  cloud.point_step = static_cast<uindex_t>(layout.point_step);
  // Overflows for a row of more than 4 GB, as in PCL; it is not used for unorganized
  // clouds.
  cloud.row_step = static_cast<uindex_t>(width * layout.point_step);
  cloud.data.resize(static_cast<std::size_t>(width * height * layout.point_step));
}

void
inspectCoordinates(PointCloudFile& file, bool narrowed)
{
  const PointView points = file.points();
  bool dense = true;
  float largest = 0.0F;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    const bool finite = point.allFinite();
    dense = dense && finite;
    if (finite)
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  file.cloud.is_dense = dense ? 1 : 0;
  constexpr float millimetre_lost = 1e4F;
  if (!narrowed || largest < millimetre_lost)
    return;
  const float step =
      std::nextafter(largest, std::numeric_limits<float>::max()) - largest;
  std::ostringstream remark;
  remark << "coordinates reach " << largest << " m; float32 rounds them to " << step
         << " m: subtract an offset first";
  file.remarks.push_back(remark.str());
}

} // namespace pcl::acmap
