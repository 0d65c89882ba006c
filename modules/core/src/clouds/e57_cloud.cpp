#include "clouds/e57_cloud.h"

#include "clouds/coordinate_shift.h"
#include "files/byte_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace pcl::acmap {

namespace {

/** \brief Coordinates of a scan's records, cartesian or spherical. */
class PlaceOfRecord {
public:
  /** \throws InputFileException for points without coordinates */
  PlaceOfRecord(const E57Scan& scan, const ByteSource& source)
  {
    const char* const cartesian[] = {"cartesianX", "cartesianY", "cartesianZ"};
    const char* const spherical[] = {
        "sphericalRange", "sphericalAzimuth", "sphericalElevation"};
    is_spherical_ = scan.fieldOf(cartesian[0]) == E57Scan::none;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      fields_[axis] = scan.fieldOf(is_spherical_ ? spherical[axis] : cartesian[axis]);
      if (fields_[axis] == E57Scan::none)
        source.fail("a scan has points without coordinates");
    }
    invalid_ =
        scan.fieldOf(is_spherical_ ? "sphericalInvalidState" : "cartesianInvalidState");
  }

  Eigen::Vector3d
  operator()(const std::vector<double>& record) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (invalid_ != E57Scan::none && record[invalid_] != 0)
      return Eigen::Vector3d::Constant(nan);
    const Eigen::Vector3d p(record[fields_[0]], record[fields_[1]], record[fields_[2]]);
    if (!is_spherical_)
      return p;
    return p[0] * Eigen::Vector3d(std::cos(p[2]) * std::cos(p[1]),
                                  std::cos(p[2]) * std::sin(p[1]),
                                  std::sin(p[2]));
  }

private:
  std::array<std::size_t, 3> fields_{};
  std::size_t invalid_ = E57Scan::none;
  bool is_spherical_ = false;
};

/** \brief Which values the points of scans have, in one cloud. */
struct E57Shape {
  bool has_intensity = false, has_color = false, has_views = false;
  bool has_grid = false; ///< rows and columns of a single scan
  std::uint64_t points = 0;
};

std::array<std::size_t, 3>
colorFieldsOf(const E57Scan& scan)
{
  return {
      scan.fieldOf("colorRed"), scan.fieldOf("colorGreen"), scan.fieldOf("colorBlue")};
}

bool
hasColor(const E57Scan& scan)
{
  const auto fields = colorFieldsOf(scan);
  return std::count(fields.begin(), fields.end(), E57Scan::none) == 0;
}

E57Shape
shapeOf(const std::vector<E57Scan>& scans)
{
  E57Shape shape;
  for (const E57Scan& scan : scans) {
    shape.has_intensity |= scan.fieldOf("intensity") != E57Scan::none;
    shape.has_color |= hasColor(scan);
    shape.points += scan.points;
  }
  shape.has_views = scans.size() > 1;
  const E57Scan& first = scans.front();
  shape.has_grid = first.points == shape.points &&
                   first.fieldOf("rowIndex") != E57Scan::none &&
                   first.fieldOf("columnIndex") != E57Scan::none;
  return shape;
}

std::uint32_t
packedColor(const std::vector<double>& record,
            const std::array<std::size_t, 3>& fields,
            const std::array<double, 6>& limits)
{
  std::uint32_t packed = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double width = limits[2 * c + 1] - limits[2 * c];
    const double share = width > 0 ? (record[fields[c]] - limits[2 * c]) / width : 0;
    packed = packed << 8 |
             static_cast<std::uint32_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  }
  return packed;
}

std::vector<SourceField>
fieldsOf(const E57Shape& shape)
{
  std::vector<SourceField> fields;
  for (const char* name : {"x", "y", "z"})
    fields.push_back({name, PCLPointField::FLOAT32, 1, 0});
  if (shape.has_intensity)
    fields.push_back({"intensity", PCLPointField::FLOAT32, 1, 0});
  if (shape.has_color)
    fields.push_back({"rgb", PCLPointField::FLOAT32, 1, 0});
  if (shape.has_views)
    fields.push_back({"view", PCLPointField::INT32, 1, 0});
  return fields;
}

/** \brief Row and column of a point. */
struct GridPlace {
  std::uint32_t row, column;
};

/** \brief Makes points of the records of scans, packed as \ref fieldsOf. */
class E57Cloud {
public:
  /** \param[in] shift to be subtracted from coordinates */
  E57Cloud(const E57Shape& shape, const Eigen::Vector3d& shift)
  : shape_(shape)
  , shift_(shift)
  {
    if (shape.has_grid)
      places_.reserve(shape.points);
  }

  /** \brief Adds the points of a scan, one block after the other.
   * \param[in] T_frame_scan of the frame of the cloud, without its shift
   * \param[in] step bytes of a point
   * \param[in,out] data vector of bytes */
  template <typename Bytes>
  void
  add(const E57Scan& scan,
      std::int32_t view,
      const Eigen::Isometry3d& T_frame_scan,
      ScanReader& reader,
      std::size_t step,
      Bytes& data);

  /** \brief Where the points are in the grid of their scan, if it has one. */
  const LargeVector<GridPlace>&
  places() const
  {
    return places_;
  }

private:
  const E57Shape& shape_;
  Eigen::Vector3d shift_;
  LargeVector<GridPlace> places_;
};

template <typename Bytes>
void
E57Cloud::add(const E57Scan& scan,
              std::int32_t view,
              const Eigen::Isometry3d& T_frame_scan,
              ScanReader& reader,
              std::size_t step,
              Bytes& data)
{
  const PlaceOfRecord place_of(scan, reader.source());
  const std::size_t intensity = scan.fieldOf("intensity"),
                    row = scan.fieldOf("rowIndex"),
                    column = scan.fieldOf("columnIndex");
  const std::array<std::size_t, 3> color = colorFieldsOf(scan);
  const bool has_color = hasColor(scan);
  const std::unique_ptr<ScanPoints> points = reader.open(scan);
  const auto store = [&](std::uint8_t* to) {
    const auto put = [&](const auto& value) {
      std::memcpy(to, &value, sizeof value);
      to += sizeof value;
    };
    const std::vector<double>& record = points->next();
    const Eigen::Vector3d place = T_frame_scan * place_of(record) - shift_;
    for (const double coordinate : place)
      put(static_cast<float>(coordinate));
    if (shape_.has_intensity)
      put(intensity == E57Scan::none ? 0.0F : static_cast<float>(record[intensity]));
    if (shape_.has_color)
      put(has_color ? packedColor(record, color, scan.color_limits) : 0U);
    if (shape_.has_views)
      put(view);
    if (shape_.has_grid)
      places_.push_back(
          {static_cast<std::uint32_t>(std::clamp(record[row], 0.0, 1e9)),
           static_cast<std::uint32_t>(std::clamp(record[column], 0.0, 1e9))});
  };
  appendBlocks(static_cast<std::size_t>(scan.points),
               step,
               ByteSource::maximum_line / step,
               data,
               [&](std::size_t count, std::uint8_t* block) {
                 for (std::size_t i = 0; i < count; ++i)
                   store(block + i * step);
               });
}

/** \brief A grid in which each point has a cell. */
struct E57Grid {
  std::size_t width = 0, height = 0; ///< 0 if there is none
};

/** \brief The grid of a cloud; none if the file has none, or one that is mostly empty, or
 * two points in a cell. */
E57Grid
gridOf(const LargeVector<GridPlace>& places)
{
  constexpr std::uint64_t largest_share = 4; // cells of the grid for a point
  E57Grid grid;
  for (const GridPlace& place : places) {
    grid.width = std::max(grid.width, place.column + std::size_t{1});
    grid.height = std::max(grid.height, place.row + std::size_t{1});
  }
  if (grid.width < 2 || grid.height < 2 ||
      grid.width > largest_share * places.size() / grid.height)
    return {};
  std::vector<bool, SystemAllocator<bool>> is_taken(grid.width * grid.height);
  for (const GridPlace& place : places) {
    const std::size_t cell = place.row * grid.width + place.column;
    if (is_taken[cell]) // several echoes of one beam
      return {};
    is_taken[cell] = true;
  }
  return grid;
}

/** \brief Puts points into the cells of their grid. Empty cells have NaN as coordinates. */
template <typename Bytes>
void
organize(const LargeVector<GridPlace>& places,
         const E57Grid& grid,
         std::size_t step,
         Bytes& data)
{
  const std::array<float, 3> nowhere = {std::numeric_limits<float>::quiet_NaN(),
                                        std::numeric_limits<float>::quiet_NaN(),
                                        std::numeric_limits<float>::quiet_NaN()};
  Bytes cells;
  assignLarge(cells, grid.width * grid.height * step, 0);
  for (std::size_t cell = 0; cell < cells.size(); cell += step)
    std::memcpy(&cells[cell], nowhere.data(), sizeof nowhere);
  for (std::size_t i = 0; i < places.size(); ++i)
    std::memcpy(&cells[(places[i].row * grid.width + places[i].column) * step],
                &data[i * step],
                step);
  data.swap(cells);
}

} // namespace

Eigen::Vector3d
shiftOf(const E57Scan& scan,
        const Eigen::Isometry3d& T_frame_scan,
        const CloudStatement& stated,
        ScanReader& reader)
{
  const PlaceOfRecord place_of(scan, reader.source());
  const std::unique_ptr<ScanPoints> points = reader.open(scan);
  CoordinateSample sample;
  for (std::uint64_t i = 0; i < scan.points && sample.size() < CoordinateSample::enough;
       ++i)
    if (const Eigen::Vector3d place = place_of(points->next()); !place.isZero(0))
      sample.add(T_frame_scan * place);
  return sample.shift(stated);
}

void
readScans(const std::vector<E57Scan>& scans,
          const std::vector<Eigen::Isometry3d>& T_frame_scan,
          const Eigen::Vector3d& shift,
          ScanReader& reader,
          LargeVector<std::uint8_t>* rows,
          PCLPointCloud2& cloud,
          CoordinateCheck& check)
{
  const E57Shape shape = shapeOf(scans);
  requireCountable(shape.points, reader.source());
  const FieldLayout layout = planLayout(fieldsOf(shape), reader.source());
  const std::size_t step = layout.point_step;
  E57Cloud points(shape, shift);
  intoRows(rows, cloud, [&](auto& data) {
    reserveLarge(data, shape.points * step);
    for (std::size_t i = 0; i < scans.size(); ++i)
      points.add(
          scans[i], static_cast<std::int32_t>(i), T_frame_scan[i], reader, step, data);
    const E57Grid grid = gridOf(points.places());
    if (grid.width > 0) {
      organize(points.places(), grid, step, data);
      describeCloud(cloud, layout, grid.width, grid.height);
    }
    else
      describeCloud(cloud, layout, shape.points, 1);
    check.add(data.data(), step, data.size() / step);
  });
}

} // namespace pcl::acmap
