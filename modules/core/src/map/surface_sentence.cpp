#include <pcl/core/exceptions.h>
#include <pcl/core/surface_sentence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pcl {

namespace {

std::string
withDigits(double value, int digits)
{
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string
areaText(double area)
{
  return std::isfinite(area) ? ", " + withDigits(area, area < 1 ? 2 : 1) + " m²" : "";
}

/** \brief "7.1 × 4.0 m", with as many digits for both; the first alone if the other one is not
 * known. */
std::string
sizeText(const Eigen::Vector2d& size, int digits)
{
  if (!std::isfinite(size.x()))
    return "";
  return withDigits(size.x(), digits) +
         (std::isfinite(size.y()) ? " × " + withDigits(size.y(), digits) : "") + " m";
}

std::string
noiseText(double rms)
{
  return std::isfinite(rms) ? ", noise " + withDigits(1000 * rms, 1) + " mm" : "";
}

const char*
kindOf(const MapOpening& opening)
{
  return acmap::opening_kind_names[static_cast<std::size_t>(opening.kind)];
}

/** \brief "2 doors", "1 window". */
std::string
countText(const CompactMap& map, const MapRoom& room, OpeningKind kind)
{
  const auto count = std::count_if(
      room.openings.begin(), room.openings.end(), [&](std::int32_t opening) {
        return map.openings[static_cast<std::size_t>(opening)].kind == kind;
      });
  if (count == 0)
    return "";
  return ", " + std::to_string(count) + " " +
         acmap::opening_kind_names[static_cast<std::size_t>(kind)] +
         (count > 1 ? "s" : "");
}

std::string
nameOf(const SurfaceLabel& label, const char* kind, std::size_t number)
{
  return label.name.empty() ? kind + (" " + std::to_string(number)) : label.name;
}

void
requireIndex(const char* what, std::size_t index, std::size_t size)
{
  if (index >= size)
    throw acmap::BadArgument("a map of " + std::to_string(size) + " " + what +
                             "s has no " + what + " " + std::to_string(index));
}

} // namespace

std::string
describePlane(const CompactMap& map, std::size_t plane)
{
  requireIndex("plane", plane, map.planes.size());
  const PlanePatch& patch = map.planes[plane];
  std::string text = nameOf(patch.label, "Plane", plane) + areaText(patch.area);
  constexpr double small = 1; // metres, below which sides are told in centimetres
  if (patch.label.size.allFinite())
    text +=
        ", " + sizeText(patch.label.size, patch.label.size.minCoeff() < small ? 2 : 1);
  const auto number = static_cast<std::int32_t>(plane);
  for (const MapOpening& opening : map.openings)
    if (opening.planes[0] == number || opening.planes[1] == number)
      text +=
          std::string(", ") + kindOf(opening) + " " +
          sizeText({(opening.to - opening.from).norm(), opening.top - opening.bottom},
                   2);
  for (const RecessPatch& recess : map.recesses)
    if (recess.wall == number)
      text += (recess.reaches_floor ? ", closed door " : ", recess ") +
              sizeText(recess.size.head<2>(), 2);
  return text + noiseText(patch.rms);
}

std::string
describeRoom(const CompactMap& map, std::size_t room)
{
  requireIndex("room", room, map.rooms.size());
  const MapRoom& one = map.rooms[room];
  const std::string size = sizeText(one.label.size, 1);
  return nameOf(one.label, "Room", room) + areaText(one.area) +
         (size.empty() ? "" : ", " + size) + countText(map, one, OpeningKind::Door) +
         countText(map, one, OpeningKind::Window);
}

std::string
describeCylinder(const CompactMap& map, std::size_t cylinder)
{
  requireIndex("cylinder", cylinder, map.cylinders.size());
  const CylinderPatch& patch = map.cylinders[cylinder];
  return nameOf(patch.label, "Cylinder", cylinder) + ", diameter " +
         withDigits(2 * patch.radius, 2) + " m, " +
         withDigits(patch.high - patch.low, 2) + " m long" + noiseText(patch.rms);
}

} // namespace pcl
