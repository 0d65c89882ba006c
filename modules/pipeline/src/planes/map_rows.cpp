#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/pipeline/map_rows.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t row_bytes = 20; ///< of a row with colours

std::vector<FieldWish>
fieldsOf(bool colored)
{
  std::vector<FieldWish> fields = {{"x", PCLPointField::FLOAT32},
                                   {"y", PCLPointField::FLOAT32},
                                   {"z", PCLPointField::FLOAT32}};
  if (colored)
    fields.push_back({"rgb", PCLPointField::FLOAT32});
  fields.push_back({"view", PCLPointField::INT32});
  return fields;
}

/** \param[in] step bytes of a row
 * \return number of rows that were moved to the front of \a to, which may be \a from */
std::size_t
moveEveryNth(const std::uint8_t* from,
             std::size_t rows,
             std::size_t step,
             std::size_t n,
             std::uint8_t* to)
{
  std::size_t kept = 0;
  for (std::size_t row = 0; row < rows; row += n, ++kept)
    std::memmove(to + kept * step, from + row * step, step);
  return kept;
}

/** \param[in] before number of finite points before this view
 * \return the number of finite points before each chunk, and in the end before the next
 * view */
std::vector<std::size_t>
countFinite(const PointView& points, std::size_t before)
{
  std::vector<std::size_t> counts(
      (points.size() + parallel_chunk - 1) / parallel_chunk + 1);
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t& count = counts[begin / parallel_chunk + 1];
    for (std::size_t i = begin; i < end; ++i)
      count += points[i].allFinite() ? 1 : 0;
  });
  counts.front() = before;
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  return counts;
}

} // namespace

MapRows::MapRows(std::size_t points, bool colored, CostCallback cost)
: layout_(layoutWith(PCLPointCloud2(), fieldsOf(colored)))
, colored_(colored)
, cost_(std::move(cost))
, announced_(points * layout_.point_step)
{
  announce(announced_);
  rows_.reserve(announced_);
}

void
MapRows::announce(std::size_t bytes) const
{
  if (cost_ && bytes > 0)
    cost_("merging the observations", bytes, 0);
}

void
MapRows::reserve(std::size_t points)
{
  rows_.reserve(std::min(points, maximum_) * layout_.point_step);
}

void
MapRows::append(const PointCloudFile& observation,
                const Eigen::Isometry3d& T_map_camera,
                std::int32_t view)
{
  const PointView points = observation.points();
  const std::vector<std::size_t> befores = countFinite(points, seen_);
  grow(befores.back() - seen_);
  const PCLPointField* const color = colored_ ? findColor(observation.cloud) : nullptr;
  const auto write = [&](std::size_t i, const Eigen::Vector3f& point, std::size_t row) {
    const Eigen::Vector3f place = (T_map_camera * point.cast<double>()).cast<float>();
    std::uint8_t* const to = &rows_[row * layout_.point_step];
    std::memcpy(to, place.data(), 3 * sizeof(float));
    if (color)
      std::memcpy(
          to + 3 * sizeof(float),
          &observation.cloud.data[i * observation.cloud.point_step + color->offset],
          sizeof(std::uint32_t));
    std::memcpy(to + layout_.point_step - sizeof view, &view, sizeof view);
  };
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t before = befores[begin / parallel_chunk];
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f point = points[i];
      if (point.allFinite() && before++ % every_ == 0)
        write(i, point, (before - 1) / every_);
    }
  });
  dropAboveMaximum();
}

void
MapRows::appendRows(const std::vector<std::uint8_t>& rows, std::int32_t first_view)
{
  const std::size_t step = layout_.point_step, before = seen_;
  const std::size_t points = rows.size() / step;
  grow(points);
  for (std::size_t i = (every_ - before % every_) % every_; i < points; i += every_) {
    std::uint8_t* const to = &rows_[(before + i) / every_ * step];
    std::memcpy(to, &rows[i * step], step);
    std::int32_t view;
    std::memcpy(&view, to + step - sizeof view, sizeof view);
    view += first_view;
    std::memcpy(to + step - sizeof view, &view, sizeof view);
  }
  dropAboveMaximum();
}

/** Makes room for more finite points. */
void
MapRows::grow(std::size_t points)
{
  const std::size_t bytes = rows_.size() + points * layout_.point_step;
  if (bytes > announced_)
    announce(bytes);
  seen_ += points;
  rows_.resize((seen_ + every_ - 1) / every_ * layout_.point_step);
}

void
MapRows::dropAboveMaximum()
{
  while (size() > maximum_) {
    const std::size_t step = layout_.point_step;
    rows_.resize(moveEveryNth(rows_.data(), size(), step, 2, rows_.data()) * step);
    every_ *= 2;
  }
}

CloudRows
MapRows::finish()
{
  return CloudRows(std::move(layout_), std::move(rows_));
}

void
putMapRows(const CloudRows& cloud,
           std::size_t begin,
           std::size_t end,
           ByteParcel& parcel)
{
  const PointView points = requirePoints(cloud);
  const PCLPointField* const color = findColor(cloud.layout());
  const PCLPointField* const view =
      findField(cloud.layout(), "view", PCLPointField::INT32);
  std::vector<std::uint8_t> rows((end - begin) * row_bytes);
  std::uint8_t* to = rows.data();
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint8_t* const from = cloud.data() + i * cloud.layout().point_step;
    const Eigen::Vector3f point = points[i];
    std::memcpy(to, point.data(), 3 * sizeof(float));
    if (color)
      std::memcpy(to + 3 * sizeof(float), from + color->offset, sizeof(std::uint32_t));
    if (view)
      std::memcpy(to + 4 * sizeof(float), from + view->offset, sizeof(std::int32_t));
    to += row_bytes;
  }
  parcel.putAll(rows.data(), rows.size());
}

CloudRows
movedRows(const Eigen::Isometry3d& T_to_from, const CloudRows& rows)
{
  if (T_to_from.matrix().isIdentity(0))
    return rows;
  const PCLPointField* const x = findField(rows.layout(), "x");
  const PCLPointField* const normal_x = findField(rows.layout(), "normal_x");
  const PointView points = x ? requirePoints(rows) : PointView();
  const PointView normals = normalsOf(rows);
  const auto write = [](const Eigen::Vector3d& value, std::uint8_t* to) {
    const Eigen::Vector3f rounded = value.cast<float>();
    std::memcpy(to, rounded.data(), 3 * sizeof(float));
  };
  return rowsWith(rows, {}, [&](std::uint8_t* row, std::size_t i) {
    if (x)
      write(T_to_from * points[i].cast<double>(), row + x->offset);
    if (normals.size() > 0)
      write(T_to_from.linear() * normals[i].cast<double>(), row + normal_x->offset);
  });
}

PCLPointCloud2
everyNth(const CloudRows& cloud, std::size_t n)
{
  PCLPointCloud2 thinned = layoutWith(cloud.layout(), {});
  resizeRows(thinned, (cloud.size() + n - 1) / n);
  moveEveryNth(cloud.data(), cloud.size(), thinned.point_step, n, thinned.data.data());
  return thinned;
}

} // namespace pcl::acmap
