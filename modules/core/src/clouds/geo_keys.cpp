#include "clouds/coordinate_units.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace pcl::acmap {

namespace {

/** \brief The keys that tell units, by the numbers of the specification of GeoTIFF. */
enum GeoKey : std::uint16_t {
  ModelType = 1024,
  ProjectedSystem = 3072,
  ProjectedUnit = 3076,
  ProjectedUnitSize = 3077,
  VerticalUnit = 4099
};

std::uint16_t
shortAt(std::string_view bytes, std::size_t index)
{
  std::uint16_t value = 0;
  std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
  return value;
}

/** Metres in a unit of length by its number; none for others, as that of the user. */
std::optional<double>
metresOfCode(std::uint16_t code)
{
  static constexpr std::pair<std::uint16_t, double> units[] = {
      {9001, 1},
      {9002, 0.3048},
      {9003, 1200.0 / 3937}, // foot of the US survey
      {9005, 0.3047972654},  // Clarke's foot
      {9036, 1000}};
  for (const auto& [known, metres] : units)
    if (code == known)
      return metres;
  return std::nullopt;
}

} // namespace

CoordinateUnits
unitsOfGeoKeys(std::string_view directory, std::string_view numbers)
{
  constexpr std::size_t shorts = 4; // of an entry: key, tag, count, value
  constexpr std::uint16_t number_tag = 34736, geographic = 2, of_user = 32767;
  CoordinateUnits units;
  std::optional<double> size;
  for (std::size_t entry = 1;
       (entry + 1) * shorts * sizeof(std::uint16_t) <= directory.size();
       ++entry) {
    const auto at = [&](std::size_t i) {
      return shortAt(directory, entry * shorts + i);
    };
    const std::uint16_t value = at(3);
    switch (at(0)) {
    case ModelType:
      units.are_degrees = value == geographic;
      break;
    case ProjectedSystem:
      if (value != of_user)
        units.system = value;
      break;
    case ProjectedUnit:
      units.across = metresOfCode(value);
      break;
    case VerticalUnit:
      units.up = metresOfCode(value);
      break;
    case ProjectedUnitSize:
      if (double metres = 0;
          at(1) == number_tag && (value + 1U) * sizeof metres <= numbers.size()) {
        std::memcpy(&metres, numbers.data() + value * sizeof metres, sizeof metres);
        size = metres;
      }
      break;
    default:
      break;
    }
  }
  if (!units.across)
    units.across = size;
  if (units.across)
    units.system.reset();
  return units;
}

} // namespace pcl::acmap
