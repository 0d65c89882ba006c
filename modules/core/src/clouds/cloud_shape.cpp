#include "clouds/coordinate_shift.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/large_memory.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::uint64_t max_points = std::numeric_limits<std::int32_t>::max();

[[noreturn]] void
refusePoints(std::uint64_t points, const std::string& size, const ByteSource& source)
{
  source.fail("header claims " + std::to_string(points) + " points of " + size + ", " +
              std::to_string(source.remaining()) + " bytes follow");
}

/** \brief Whether no coordinate of a block is infinite or NaN, without a branch per
 * value: only then all bits of the exponent are set, and adding its least one carries
 * into the bit of the sign. */
bool
areFinite(const std::uint8_t* coordinates, std::size_t step, std::size_t count)
{
  constexpr std::uint32_t magnitude = 0x7fffffff;
  constexpr std::uint32_t exponent_one = 0x00800000;
  const auto carry = [](const std::uint8_t* coordinate) {
    std::uint32_t bits;
    std::memcpy(&bits, coordinate, sizeof bits);
    return (bits & magnitude) + exponent_one;
  };
  std::uint32_t carried = 0;
  for (std::size_t i = 0; i < count; ++i, coordinates += step)
    carried |= carry(coordinates) | carry(coordinates + sizeof(float)) |
               carry(coordinates + 2 * sizeof(float));
  return carried <= magnitude;
}

/** \brief Largest magnitude of a coordinate of the finite points.
 * \param[in] zero a place that does not count */
float
largestOf(const PointView& points, const Eigen::Vector3f& zero)
{
  float largest = 0.0F;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3f point = points[i];
        point.allFinite() && !isAt(point, zero))
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
  return largest;
}

} // namespace

void
requireCountable(std::uint64_t points, const ByteSource& source)
{
  if (points > max_points)
    source.fail("holds " + std::to_string(points) + " points; an index counts " +
                std::to_string(max_points) + " at most");
}

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
describeCloud(PCLPointCloud2& cloud,
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
}

void
shapeCloud(PCLPointCloud2& cloud,
           const FieldLayout& layout,
           std::uint64_t width,
           std::uint64_t height)
{
  describeCloud(cloud, layout, width, height);
  const auto bytes = static_cast<std::size_t>(width * height * layout.point_step);
  reserveLarge(cloud.data, bytes);
  cloud.data.resize(bytes);
}

void
CoordinateCheck::add(const std::uint8_t* coordinates,
                     std::size_t step,
                     std::size_t count)
{
  dense_ = dense_ && areFinite(coordinates, step, count);
  if (narrowed_)
    largest_ =
        std::max(largest_, largestOf(PointView(coordinates, step, count), zero_));
}

void
CoordinateCheck::add(const PointCloudFile& file)
{
  const std::size_t count = file.points().size();
  const PCLPointField* const x = findField(file.cloud, "x");
  if (count > 0)
    add(&file.cloud.data[x->offset], file.cloud.point_step, count);
}

void
CoordinateCheck::finish(PointCloudFile& file) const
{
  file.cloud.is_dense = dense_ ? 1 : 0;
  constexpr float millimetre_lost = 1e4F;
  const float largest = largest_ * scale_;
  if (!narrowed_ || largest < millimetre_lost)
    return;
  const float step =
      std::nextafter(largest, std::numeric_limits<float>::max()) - largest;
  std::ostringstream remark;
  remark << "coordinates reach " << largest << " m; float32 rounds them to " << step
         << " m: --shift subtracts another offset first";
  file.remarks.push_back(remark.str());
}

void
shiftPlaces(const std::vector<double>& places,
            const CloudStatement& stated,
            bool is_rounded,
            PointCloudFile& file)
{
  const std::size_t count = places.size() / 3,
                    stride = count / CoordinateSample::enough + 1;
  const auto place = [&](std::size_t i) {
    return Eigen::Vector3d(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
  };
  CoordinateSample sample;
  for (std::size_t i = 0; i < count; i += stride)
    sample.add(place(i));
  const Eigen::Vector3d shift = sample.shift(stated);
  if (shift.isZero(0))
    return;
  const std::size_t x = findField(file.cloud, "x")->offset;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d near = place(i) - shift;
    const Eigen::Vector3f point(
        narrowed(near.x()), narrowed(near.y()), narrowed(near.z()));
    std::memcpy(
        &file.cloud.data[i * file.cloud.point_step + x], point.data(), sizeof point);
  }
  setShift(shift, stated, file);
  if (is_rounded)
    remarkLostDigits(shift, stated, file);
}

Eigen::Vector3d
RecordBlocks::findShift(ByteSource& source,
                        const FieldLayout& layout,
                        bool swap_bytes,
                        std::uint64_t count,
                        const CloudStatement& stated)
{
  constexpr std::uint64_t places = 64, together = CoordinateSample::enough / places;
  const std::size_t step = layout.source_step;
  const std::uint64_t begin = source.size() - source.remaining();
  CoordinateSample sample;
  std::vector<std::uint8_t> records;
  for (std::uint64_t at = 0; at < count; at += std::max(count / places, together)) {
    const auto now = static_cast<std::size_t>(std::min(together, count - at));
    records.resize(now * step);
    source.moveTo(begin + at * step);
    source.read(records.data(), records.size());
    if (swap_bytes)
      swapRecords(layout, records.data(), now);
    for (std::size_t i = 0; i < now; ++i)
      sample.add(layout.placeIn(&records[i * step]));
  }
  source.moveTo(begin);
  return sample.shift(stated);
}

// Blocks fit into the cache, and are long enough to bypass the buffer of the source.
RecordBlocks::RecordBlocks(ByteSource& source,
                           const FieldLayout& layout,
                           bool swap_bytes)
: source_(source)
, layout_(layout)
, swap_bytes_(swap_bytes)
, block_(ByteSource::maximum_line / std::max<std::size_t>(layout.source_step, 1) + 1)
, moves_(layout.moves())
{}

void
RecordBlocks::read(std::size_t count, std::uint8_t* points, CoordinateCheck& check)
{
  const std::size_t step = layout_.source_step;
  const bool copies = layout_.same && !swap_bytes_;
  if (!copies)
    records_.resize(count * step);
  std::uint8_t* const records = copies ? points : records_.data();
  source_.read(records, count * step);
  if (swap_bytes_)
    swapRecords(layout_, records, count);
  if (!copies)
    moveRecords(moves_, records, step, points, layout_.point_step, count);
  const auto x = std::find_if(layout_.fields.begin(),
                              layout_.fields.end(),
                              [](const auto& field) { return field.name == "x"; });
  check.add(points + x->offset, layout_.point_step, count);
}

} // namespace pcl::acmap
