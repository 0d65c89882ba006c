#include "byte_source.h"
#include "coordinate_shift.h"
#include "e57_pages.h"
#include "e57_points.h"
#include "point_cloud_readers.h"

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/** \brief A scan: where its points are in the file, and its pose. */
struct E57Scan {
  std::vector<E57Field> fields;
  std::uint64_t section = 0; ///< logical offset
  std::uint64_t points = 0;
  Eigen::Isometry3d T_map_scan = Eigen::Isometry3d::Identity();
  std::array<double, 6> color_limits{}; ///< least and most of red, green, blue

  std::size_t
  fieldOf(const char* name) const
  {
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name == name)
        return i;
    return none;
  }
};

/** \brief The number of an element; one without text is 0. */
double
numberIn(const pugi::xml_node& parent, const char* name)
{
  return parent.child(name).text().as_double(0);
}

/** \throws InputFileException for a pose that is none */
Eigen::Isometry3d
poseIn(const pugi::xml_node& scan, const ByteSource& source)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const pugi::xml_node node = scan.child("pose");
  if (const pugi::xml_node rotation = node.child("rotation")) {
    const Eigen::Quaterniond q(numberIn(rotation, "w"),
                               numberIn(rotation, "x"),
                               numberIn(rotation, "y"),
                               numberIn(rotation, "z"));
    if (!(q.norm() > 0.5 && q.norm() < 2))
      source.fail("a scan has a pose whose rotation is no unit quaternion");
    pose.linear() = q.normalized().toRotationMatrix();
  }
  const pugi::xml_node translation = node.child("translation");
  pose.translation() << numberIn(translation, "x"), numberIn(translation, "y"),
      numberIn(translation, "z");
  if (!pose.translation().allFinite())
    source.fail("a scan has a pose that is no number");
  return pose;
}

std::array<double, 6>
colorLimitsOf(const pugi::xml_node& node, const E57Scan& scan)
{
  std::array<double, 6> limits{};
  const pugi::xml_node given = node.child("colorLimits");
  const char* const names[] = {"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t field = scan.fieldOf(names[c]);
    if (given) {
      limits[2 * c] = numberIn(given, (names[c] + std::string("Minimum")).c_str());
      limits[2 * c + 1] = numberIn(given, (names[c] + std::string("Maximum")).c_str());
    }
    else if (field != none) {
      limits[2 * c] = scan.fields[field].least;
      limits[2 * c + 1] = scan.fields[field].most;
    }
  }
  return limits;
}

E57Scan
scanIn(const pugi::xml_node& node, const ByteSource& source)
{
  E57Scan scan;
  const pugi::xml_node points = node.child("points");
  scan.points = points.attribute("recordCount").as_ullong(0);
  scan.section = E57Pages::logical(points.attribute("fileOffset").as_ullong(0), source);
  scan.fields = e57FieldsIn(points.child("prototype"), source);
  scan.T_map_scan = poseIn(node, source);
  scan.color_limits = colorLimitsOf(node, scan);
  return scan;
}

/** \brief Coordinates of a scan's records, cartesian or spherical. */
class PlaceOfRecord {
public:
  /** \throws InputFileException for points without coordinates */
  PlaceOfRecord(const E57Scan& scan, const ByteSource& source)
  {
    const char* const cartesian[] = {"cartesianX", "cartesianY", "cartesianZ"};
    const char* const spherical[] = {
        "sphericalRange", "sphericalAzimuth", "sphericalElevation"};
    is_spherical_ = scan.fieldOf(cartesian[0]) == none;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      fields_[axis] = scan.fieldOf(is_spherical_ ? spherical[axis] : cartesian[axis]);
      if (fields_[axis] == none)
        source.fail("a scan has points without coordinates");
    }
    invalid_ =
        scan.fieldOf(is_spherical_ ? "sphericalInvalidState" : "cartesianInvalidState");
  }

  Eigen::Vector3d
  operator()(const std::vector<double>& record) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (invalid_ != none && record[invalid_] != 0)
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
  std::size_t invalid_ = none;
  bool is_spherical_ = false;
};

/** \brief The points of all scans, in the frame of the file. */
struct E57Cloud {
  std::vector<float> coordinates, intensities;
  std::vector<std::uint32_t> colors;
  std::vector<std::int32_t> views;
  std::vector<std::uint32_t> rows, columns;
  bool has_color = false, has_intensity = false;
};

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

/** \brief Adds the points of a scan. */
void
addScan(const E57Scan& scan,
        std::int32_t view,
        E57Pages& pages,
        const ByteSource& source,
        std::optional<Eigen::Vector3d>& shift,
        E57Cloud& cloud)
{
  const PlaceOfRecord place_of(scan, source);
  const std::size_t intensity = scan.fieldOf("intensity"),
                    row = scan.fieldOf("rowIndex"),
                    column = scan.fieldOf("columnIndex");
  const std::array<std::size_t, 3> color = {
      scan.fieldOf("colorRed"), scan.fieldOf("colorGreen"), scan.fieldOf("colorBlue")};
  const bool has_color = std::count(color.begin(), color.end(), none) == 0;
  const bool has_grid = row != none && column != none;
  cloud.has_color |= has_color;
  cloud.has_intensity |= intensity != none;
  E57Points points(scan.fields, scan.section, scan.points, pages, source);
  for (std::uint64_t i = 0; i < scan.points; ++i) {
    const std::vector<double>& record = points.next();
    const Eigen::Vector3d place = scan.T_map_scan * place_of(record);
    if (!shift && place.allFinite())
      shift = coordinateShift(place);
    const Eigen::Vector3d near = place - shift.value_or(Eigen::Vector3d::Zero());
    for (const double coordinate : near)
      cloud.coordinates.push_back(static_cast<float>(coordinate));
    cloud.intensities.push_back(
        intensity == none ? 0 : static_cast<float>(record[intensity]));
    cloud.colors.push_back(has_color ? packedColor(record, color, scan.color_limits)
                                     : 0);
    cloud.views.push_back(view);
    if (has_grid) {
      cloud.rows.push_back(
          static_cast<std::uint32_t>(std::clamp(record[row], 0.0, 1e9)));
      cloud.columns.push_back(
          static_cast<std::uint32_t>(std::clamp(record[column], 0.0, 1e9)));
    }
  }
}

/** \brief Where each point is in a grid of rows and columns; empty if the file has none, or
 * one that is mostly empty. \param[out] width of the grid */
std::vector<std::size_t>
gridOf(const E57Cloud& cloud, std::size_t& width, std::size_t& height)
{
  constexpr std::uint64_t largest_share = 4; // cells of the grid for a point
  const std::size_t count = cloud.views.size();
  if (count == 0 || cloud.rows.size() != count || cloud.views.back() > 0)
    return {};
  width =
      *std::max_element(cloud.columns.begin(), cloud.columns.end()) + std::size_t{1};
  height = *std::max_element(cloud.rows.begin(), cloud.rows.end()) + std::size_t{1};
  if (width < 2 || height < 2 || width > largest_share * count / height)
    return {};
  std::vector<std::size_t> cells(count);
  std::vector<bool> is_taken(width * height);
  for (std::size_t i = 0; i < count; ++i) {
    cells[i] = cloud.rows[i] * width + cloud.columns[i];
    if (is_taken[cells[i]]) // several echoes of one beam
      return {};
    is_taken[cells[i]] = true;
  }
  return cells;
}

std::vector<SourceField>
fieldsOf(const E57Cloud& cloud, bool has_views)
{
  std::vector<SourceField> fields;
  for (const char* name : {"x", "y", "z"})
    fields.push_back({name, PCLPointField::FLOAT32, 1, 0});
  if (cloud.has_intensity)
    fields.push_back({"intensity", PCLPointField::FLOAT32, 1, 0});
  if (cloud.has_color)
    fields.push_back({"rgb", PCLPointField::FLOAT32, 1, 0});
  if (has_views)
    fields.push_back({"view", PCLPointField::INT32, 1, 0});
  return fields;
}

/** \brief Makes the cloud of a file. */
void
storePoints(const E57Cloud& cloud,
            bool has_views,
            const ByteSource& source,
            PCLPointCloud2& stored)
{
  const FieldLayout layout = planLayout(fieldsOf(cloud, has_views), source);
  std::size_t width = cloud.views.size(), height = 1;
  const std::vector<std::size_t> cells = gridOf(cloud, width, height);
  if (cells.empty()) {
    width = cloud.views.size();
    height = 1;
  }
  shapeCloud(stored, layout, width, height);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  if (!cells.empty())
    for (std::size_t cell = 0; cell < width * height; ++cell)
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::memcpy(&stored.data[cell * stored.point_step + axis * sizeof nan],
                    &nan,
                    sizeof nan);
  for (std::size_t i = 0; i < cloud.views.size(); ++i) {
    std::uint8_t* to = &stored.data[(cells.empty() ? i : cells[i]) * stored.point_step];
    const auto put = [&](const auto& value) {
      std::memcpy(to, &value, sizeof value);
      to += sizeof value;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(cloud.coordinates[3 * i + axis]);
    if (cloud.has_intensity)
      put(cloud.intensities[i]);
    if (cloud.has_color)
      put(cloud.colors[i]);
    if (has_views)
      put(cloud.views[i]);
  }
}

std::vector<E57Scan>
scansIn(const std::string& xml, const ByteSource& source)
{
  pugi::xml_document document;
  if (const auto result = document.load_buffer(xml.data(), xml.size()); !result)
    source.fail("its XML is malformed: " + std::string(result.description()));
  std::vector<E57Scan> scans;
  for (const pugi::xml_node& node :
       document.child("e57Root").child("data3D").children("vectorChild"))
    scans.push_back(scanIn(node, source));
  if (scans.empty())
    source.fail("has no scan");
  return scans;
}

} // namespace

PointCloudFile
readE57(ByteSource& source)
{
  constexpr std::uint64_t max_expansion = 450; // memory for a byte, as of a packed PCD
  constexpr std::uint64_t point_bytes = 24;
  const std::uint64_t bytes = source.remaining();
  E57Pages pages(source);
  const std::vector<E57Scan> scans = scansIn(pages.xml(), source);
  std::uint64_t points = 0;
  for (const E57Scan& scan : scans) {
    if (scan.points > max_expansion * bytes / point_bytes - points)
      source.fail("claims more points than its bytes can have");
    points += scan.points;
  }
  E57Cloud cloud;
  std::optional<Eigen::Vector3d> shift;
  for (std::size_t i = 0; i < scans.size(); ++i)
    addScan(scans[i], static_cast<std::int32_t>(i), pages, source, shift, cloud);
  PointCloudFile file;
  storePoints(cloud, scans.size() > 1, source, file.cloud);
  setShift(shift.value_or(Eigen::Vector3d::Zero()), file);
  for (const E57Scan& scan : scans)
    file.viewpoints.push_back(
        (scan.T_map_scan.translation() - file.shift).cast<float>());
  file.sensor_origin = file.viewpoints.front();
  if (points == 0)
    file.remarks.emplace_back("its scans have no points");
  CoordinateCheck check(true);
  check.add(file);
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
