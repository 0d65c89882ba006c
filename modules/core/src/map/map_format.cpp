#include "map/map_format.h"

#include "files/trajectory_text.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/impl/map_check.h>
#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

[[noreturn]] void
refuse(const std::string& what, std::size_t index, const std::string& fault)
{
  throw acmap::BadArgument(what + " " + std::to_string(index) + " of a map " + fault);
}

void
requirePlane(const PlanePatch& plane, std::size_t index)
{
  const auto require = [&](const std::string& name, const std::string& fault) {
    if (!fault.empty())
      refuse("plane", index, "is unsound: " + name + " " + fault);
  };
  const auto requireFinite = [&](const std::string& name, bool is_finite) {
    require(name, is_finite ? "" : "is not finite");
  };
  require("coefficients", faultOfCoefficients(plane.coefficients));
  requireFinite("center", plane.center.allFinite());
  requireFinite("an axis", plane.axis_u.allFinite() && plane.axis_v.allFinite());
  requireFinite("area", std::isfinite(plane.area));
  if (plane.support > std::size_t{std::numeric_limits<std::int64_t>::max()})
    require("support", "is above 2^63 - 1");
  const auto requirePolygon = [&](const std::string& name,
                                  const PlanePolygon& polygon) {
    require(name + "outer", faultOfLoop(polygon.outer));
    std::size_t points = polygon.outer.size();
    for (std::size_t k = 0; k < polygon.holes.size(); ++k) {
      require(name + "holes[" + std::to_string(k) + "]", faultOfLoop(polygon.holes[k]));
      points += polygon.holes[k].size();
    }
    if (!polygon.edges.empty() && polygon.edges.size() != points)
      require(name + "edges",
              "are " + std::to_string(polygon.edges.size()) + " for " +
                  std::to_string(points) + " points");
  };
  for (std::size_t i = 0; i < plane.polygons.size(); ++i)
    requirePolygon("polygons[" + std::to_string(i) + "].", plane.polygons[i]);
  for (std::size_t i = 0; i < plane.proposed.size(); ++i)
    requirePolygon("proposed[" + std::to_string(i) + "].", plane.proposed[i]);
}

void
requirePicture(const std::string& what,
               std::size_t index,
               const TexturePicture& picture)
{
  if (const std::string fault = faultOfPlace(picture); !fault.empty())
    refuse(what, index, fault);
  for (const std::string& name : {picture.image, picture.kinds_image})
    if (const std::string unsound = faultOfImageName(name); !unsound.empty())
      refuse(what, index, "has an image whose name " + unsound);
}

void
requireChart(const CompactMap& map, std::size_t index)
{
  const TextureChart& chart = map.charts[index];
  if (chart.plane >= map.planes.size())
    refuse("chart",
           index,
           "is of plane " + std::to_string(chart.plane) + " of " +
               std::to_string(map.planes.size()));
  const std::size_t polygons = map.planes[chart.plane].polygons.size();
  if (chart.polygon >= polygons)
    refuse("chart",
           index,
           "is of polygon " + std::to_string(chart.polygon) + " of " +
               std::to_string(polygons));
  if (const std::string fault = faultOfFrame(chart); !fault.empty())
    refuse("chart", index, fault);
  requirePicture("chart", index, chart);
}

/** Pictures of cylinders without texels are legal. */
void
requirePictureOfCylinder(const TexturePicture& picture, std::size_t index)
{
  const std::int64_t width = picture.colors.width, height = picture.colors.height;
  if (width < 0 || height < 0 || (width == 0) != (height == 0))
    refuse(
        "the picture of cylinder", index, "has " + sizeText(width, height) + " texels");
  requirePicture("the picture of cylinder", index, picture);
}

void
requireObservations(const CompactMap& map, std::size_t plane)
{
  const std::vector<std::int32_t>& numbers = map.observations[plane];
  const std::size_t poses = map.trajectory.poses.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0 || (i > 0 && numbers[i] <= numbers[i - 1]))
      refuse("plane", plane, "has observations that do not ascend from 0");
    if (poses > 0 && static_cast<std::size_t>(numbers[i]) >= poses)
      refuse("plane",
             plane,
             "was seen by observation " + std::to_string(numbers[i]) + " of " +
                 std::to_string(poses));
  }
}

/** Refuses a list with an index outside of [minimum, size). */
template <typename Indices>
void
requireIndices(const std::string& what,
               std::size_t index,
               const std::string& of,
               const Indices& indices,
               std::int32_t minimum,
               std::size_t size)
{
  for (const std::int32_t one : indices)
    if (one < minimum || (one >= 0 && static_cast<std::size_t>(one) >= size))
      refuse(what,
             index,
             "has " + of + " " + std::to_string(one) + " of " + std::to_string(size));
}

void
requireRooms(const CompactMap& map)
{
  for (std::size_t i = 0; i < map.rooms.size(); ++i) {
    const MapRoom& room = map.rooms[i];
    if (!room.center.allFinite() || !std::isfinite(room.area + room.seen_area))
      refuse("room", i, "is not finite");
    requireIndices("room", i, "plane", room.planes, 0, map.planes.size());
    requireIndices("room", i, "opening", room.openings, 0, map.openings.size());
  }
  for (std::size_t i = 0; i < map.openings.size(); ++i) {
    const MapOpening& opening = map.openings[i];
    if (!opening.from.allFinite() || !opening.to.allFinite())
      refuse("opening", i, "is not finite");
    requireIndices("opening", i, "plane", opening.planes, -1, map.planes.size());
    if (opening.planes[0] < 0)
      refuse("opening", i, "has no plane");
    requireIndices("opening", i, "room", opening.rooms, -1, map.rooms.size());
  }
}

/** Describes what is wrong with the template of a patch: all of its patches have the same
 * size, and new templates have the next number. */
template <typename Patch, typename SizeOf>
std::string
faultOfTemplate(const std::vector<Patch>& patches,
                std::size_t number,
                const SizeOf& sizeOf)
{
  const std::int32_t id = patches[number].template_id;
  std::int32_t templates = 0;
  for (std::size_t i = 0; i < number; ++i) {
    templates = std::max(templates, patches[i].template_id + 1);
    if (patches[i].template_id == id && sizeOf(patches[i]) != sizeOf(patches[number]))
      return "has another size than number " + std::to_string(i) + " of its template";
  }
  if (id < 0 || id > templates)
    return "has template " + std::to_string(id) + ", at most " +
           std::to_string(templates) + " is next";
  return "";
}

/** Lengths of maps, metres. */
constexpr double max_length = 1e9;

/** Are the columns a right-handed basis of unit vectors? */
bool
isBasis(const Eigen::Matrix3d& columns)
{
  constexpr double slack = 1e-6;
  return (columns.transpose() * columns - Eigen::Matrix3d::Identity())
                 .cwiseAbs()
                 .maxCoeff() <= slack &&
         columns.determinant() > 0;
}

/** Describes what is wrong with center, axes, size, covariance and bits of a box or a
 * recess. */
template <typename Patch>
std::string
faultOfBlock(const Patch& patch)
{
  if (!(patch.center.cwiseAbs().maxCoeff() <= max_length))
    return "has a center that is not finite, or above 1e9";
  if (!isBasis(patch.axes))
    return "has axes that are no right-handed basis of unit vectors";
  if (!(patch.size.minCoeff() > 0) || !(patch.size.maxCoeff() <= max_length))
    return "has a size that is not above 0 and at most 1e9";
  if (!patch.covariance.allFinite())
    return "has a covariance that is not finite";
  if (!std::isfinite(patch.saved_bits))
    return "has saved_bits that are not finite";
  return "";
}

bool
hasPlane(const CompactMap& map, std::int32_t plane)
{
  return plane >= 0 && static_cast<std::size_t>(plane) < map.planes.size();
}

} // namespace

std::string
faultOfCoefficients(const Eigen::Vector4d& coefficients)
{
  constexpr double slack = 1e-6;
  if (!coefficients.allFinite())
    return "are not finite";
  if (!(std::abs(coefficients.head<3>().norm() - 1) <= slack))
    return "have a normal whose length is not 1";
  return "";
}

std::string
faultOfCylinder(const CompactMap& map, std::size_t number)
{
  const CylinderPatch& cylinder = map.cylinders[number];
  constexpr double slack = 1e-6;
  const auto isLength = [](double value) { return std::abs(value) <= max_length; };
  Eigen::Matrix3d basis;
  basis << cylinder.axis_u, cylinder.axis_v, cylinder.axis_direction;
  if (!(cylinder.axis_point.cwiseAbs().maxCoeff() <= max_length))
    return "has an axis_point that is not finite, or above 1e9";
  if (!isBasis(basis))
    return "has axes that are no right-handed basis of unit vectors";
  if (!(cylinder.radius > 0) || !isLength(cylinder.radius))
    return "has a radius that is not above 0 and at most 1e9";
  if (!isLength(cylinder.low) || !isLength(cylinder.high) ||
      !(cylinder.low <= cylinder.high))
    return "has an extent that does not ascend within -1e9 and 1e9";
  if (!(cylinder.arc > 0 && cylinder.arc <= 2 * M_PI + slack))
    return "has an arc that is not above 0 and at most 2 pi";
  if (!(cylinder.area >= 0) || !std::isfinite(cylinder.area))
    return "has an area that is negative or not finite";
  if (!std::isfinite(cylinder.saved_bits))
    return "has saved_bits that are not finite";
  if (cylinder.support > std::size_t{std::numeric_limits<std::int64_t>::max()})
    return "has a support above 2^63 - 1";
  return faultOfTemplate(
      map.cylinders, number, [](const CylinderPatch& one) { return one.radius; });
}

std::string
faultOfBox(const CompactMap& map, std::size_t number)
{
  const BoxPatch& box = map.boxes[number];
  if (std::string fault = faultOfBlock(box); !fault.empty())
    return fault;
  for (const BoxFace& face : box.faces)
    if (face.kind == BoxFaceKind::Free ? face.plane != -1 : !hasPlane(map, face.plane))
      return "has a face of plane " + std::to_string(face.plane) + " of " +
             std::to_string(map.planes.size());
  const auto slanted =
      std::count_if(box.faces.begin(), box.faces.end(), [](const BoxFace& face) {
        return face.kind == BoxFaceKind::Slanted;
      });
  if (slanted > 1)
    return "has more than one slanted face";
  if (slanted == 0 ? !box.slant.isZero(0) : !faultOfCoefficients(box.slant).empty())
    return "has a slant that is not the plane of a slanted face";
  return faultOfTemplate(
      map.boxes, number, [](const BoxPatch& one) { return one.size; });
}

std::string
faultOfRecess(const CompactMap& map, std::size_t number)
{
  const RecessPatch& recess = map.recesses[number];
  if (std::string fault = faultOfBlock(recess); !fault.empty())
    return fault;
  for (const std::int32_t plane : {recess.wall, recess.leaf})
    if (!hasPlane(map, plane))
      return "has plane " + std::to_string(plane) + " of " +
             std::to_string(map.planes.size());
  if (recess.wall == recess.leaf)
    return "has its leaf in the plane of its wall";
  return faultOfTemplate(
      map.recesses, number, [](const RecessPatch& one) { return one.size; });
}

std::string
faultOfLoop(const std::vector<Eigen::Vector3f>& loop)
{
  if (loop.size() < 3)
    return "has " + std::to_string(loop.size()) + " points, 3 are needed";
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!loop[i].allFinite())
      return "has point " + std::to_string(i) + ", which is not finite";
  return "";
}

std::string
faultOfExposure(double exposure)
{
  constexpr double maximum = 1000;
  const bool is_legal = exposure >= 1 / maximum && exposure <= maximum;
  return is_legal ? "" : "is not within 0.001 and 1000";
}

std::string
faultOfUp(const Eigen::Vector3d& up)
{
  const bool is_legal = (up.array() == 0).all() || std::abs(up.norm() - 1) < 1e-3;
  return is_legal ? "" : "is not of length 1";
}

std::string
faultOfPlace(const TexturePicture& picture)
{
  constexpr std::int32_t max_halvings = 28; // of the longest side
  for (const std::optional<Eigen::Vector2i>& place :
       {picture.image_place, picture.kinds_place})
    if (place && (place->minCoeff() < 0 || place->maxCoeff() > maximum_texels))
      return "is at (" + std::to_string(place->x()) + ", " +
             std::to_string(place->y()) + ") of an image, 0 to 2^28 are legal";
  if (picture.halvings < 0 || picture.halvings > max_halvings)
    return "is halved " + std::to_string(picture.halvings) +
           " times, 0 to 28 are legal";
  return "";
}

std::string
faultOfTexels(std::int64_t texels)
{
  if (texels <= maximum_texels)
    return "";
  return "brings the map to " + std::to_string(texels) + " texels, 2^28 are legal";
}

std::string
faultOfImageName(const std::string& name)
{
  const bool is_ascii = std::all_of(
      name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return is_ascii ? "" : "has letters that are not ASCII";
}

void
requireConsistent(const CompactMap& map)
{
  if (const std::string fault = faultOfExposure(map.exposure); !fault.empty())
    throw acmap::BadArgument("exposure = " + std::to_string(map.exposure) +
                             " of a map " + fault);
  for (const Eigen::Vector3d& up : {map.up, map.assumed_up})
    if (const std::string fault = faultOfUp(up); !fault.empty())
      throw acmap::BadArgument("the up direction of a map " + fault);
  if (!map.shift.allFinite())
    throw acmap::BadArgument("the shift of a map is not finite");
  for (std::size_t i = 0; i < map.planes.size(); ++i)
    requirePlane(map.planes[i], i);
  for (std::size_t i = 0; i < map.cylinders.size(); ++i)
    if (const std::string fault = faultOfCylinder(map, i); !fault.empty())
      refuse("cylinder", i, fault);
  for (std::size_t i = 0; i < map.boxes.size(); ++i)
    if (const std::string fault = faultOfBox(map, i); !fault.empty())
      refuse("box", i, fault);
  for (std::size_t i = 0; i < map.recesses.size(); ++i)
    if (const std::string fault = faultOfRecess(map, i); !fault.empty())
      refuse("recess", i, fault);
  std::int64_t texels = 0;
  const auto addTexels =
      [&](const std::string& what, std::size_t index, const TexturePicture& picture) {
        texels += std::int64_t{picture.colors.width} * picture.colors.height;
        if (const std::string fault = faultOfTexels(texels); !fault.empty())
          refuse(what, index, fault);
      };
  for (std::size_t i = 0; i < map.charts.size(); ++i) {
    requireChart(map, i);
    addTexels("chart", i, map.charts[i]);
  }
  if (!map.cylinder_pictures.empty() &&
      map.cylinder_pictures.size() != map.cylinders.size())
    throw acmap::BadArgument(
        "a map of " + std::to_string(map.cylinders.size()) + " cylinders has " +
        std::to_string(map.cylinder_pictures.size()) + " pictures of them");
  for (std::size_t i = 0; i < map.cylinder_pictures.size(); ++i) {
    requirePictureOfCylinder(map.cylinder_pictures[i], i);
    addTexels("the picture of cylinder", i, map.cylinder_pictures[i]);
  }
  if (!map.observations.empty() && map.observations.size() != map.planes.size())
    throw acmap::BadArgument("a map of " + std::to_string(map.planes.size()) +
                             " planes has observations of " +
                             std::to_string(map.observations.size()));
  for (std::size_t i = 0; i < map.observations.size(); ++i)
    requireObservations(map, i);
  requireRooms(map);
  requireTrajectory(map.trajectory);
}

} // namespace pcl::acmap
