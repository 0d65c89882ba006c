#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/core/exceptions.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/texture/map_ifc.h>

#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace pcl::acmap::test {
namespace {

/** The instances of a STEP file by their types. */
class StepInstances {
public:
  explicit StepInstances(const std::string& path)
  {
    std::istringstream lines(contentOf(path));
    const std::regex instance("#([0-9]+)=([A-Z0-9]+)\\((.*)\\);"),
        reference("#([0-9]+)");
    bool is_data = false;
    for (std::string line; std::getline(lines, line);) {
      if (line == "DATA;" || line == "ENDSEC;")
        is_data = line == "DATA;";
      else if (is_data)
        add(line, instance, reference);
    }
  }

  std::size_t
  count(const std::string& type) const
  {
    const auto found = values_.find(type);
    return found == values_.end() ? 0 : found->second.size();
  }

  const std::vector<std::string>&
  of(const std::string& type) const
  {
    return values_.at(type);
  }

  std::set<std::string> identifiers; ///< of 22 digits
  std::size_t doubled = 0;           ///< identifiers that are there twice

private:
  void
  add(const std::string& line, const std::regex& instance, const std::regex& reference)
  {
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(line, parts, instance)) << line;
    const std::string values = parts[3];
    for (std::sregex_iterator it(values.begin(), values.end(), reference), end;
         it != end;
         ++it)
      EXPECT_LT(std::stoul((*it)[1]), std::stoul(parts[1])) << line;
    EXPECT_EQ(std::stoul(parts[1]), ++last_);
    values_[parts[2]].push_back(values);
    static const std::regex identifier("^'([0-3][0-9A-Za-z_$]{21})'");
    std::smatch found;
    if (std::regex_search(values, found, identifier))
      doubled += identifiers.insert(found[1]).second ? 0 : 1;
  }

  std::map<std::string, std::vector<std::string>> values_;
  std::size_t last_ = 0;
};

TEST(MapIfc, HasTheElementsOfARoom)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("map.ifc");
  CompactMap map = makeTexturedMap();
  map.up = -Eigen::Vector3d::UnitY();
  setRooms(makeFloorPlan(map), map);
  saveMapIfc(path, map, makeFloorPlan(map));
  const StepInstances found(path);
  std::size_t walls = 0, floors = 0, ceilings = 0;
  for (const PlanePatch& plane : map.planes) {
    const double level = -plane.coefficients[1];
    walls += std::abs(level) < 0.2;
    floors += level > 0.98;
    ceilings += level < -0.98;
  }
  EXPECT_EQ(found.count("IFCWALL"), walls);
  EXPECT_EQ(found.count("IFCSLAB"), floors);
  EXPECT_EQ(found.count("IFCCOVERING"), ceilings);
  EXPECT_EQ(found.count("IFCSPACE"), map.rooms.size());
  EXPECT_EQ(found.count("IFCEXTRUDEDAREASOLID"), map.rooms.size());
  EXPECT_EQ(found.count("IFCTRIANGULATEDFACESET"), map.planes.size());
  EXPECT_EQ(found.count("IFCPROPERTYSET"), map.planes.size());
  EXPECT_EQ(found.count("IFCPROJECT"), 1U);
  EXPECT_EQ(found.doubled, 0U);
  EXPECT_GE(found.identifiers.size(), 4 + map.planes.size());
  const std::string text = contentOf(path);
  saveMapIfc(path, map, makeFloorPlan(map));
  EXPECT_EQ(contentOf(path), text);
}

TEST(MapIfc, BoxesColumnsDoorsAndOpeningsAreElements)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("map.ifc");
  CompactMap map = makeTexturedMap();
  map.up = -Eigen::Vector3d::UnitY();
  map.boxes.resize(1);
  map.boxes[0].size = {1, 2, 3};
  map.cylinders.resize(3);
  for (CylinderPatch& cylinder : map.cylinders) {
    cylinder.axis_direction = Eigen::Vector3d::UnitY();
    cylinder.radius = 0.3;
    cylinder.low = 0;
    cylinder.high = 2;
    cylinder.arc = 6;
  }
  map.cylinders[1].is_hollow = true;
  map.cylinders[2].axis_direction = Eigen::Vector3d::UnitX();
  map.cylinders[2].axis_u = Eigen::Vector3d::UnitY();
  map.cylinders[2].axis_v = Eigen::Vector3d::UnitZ();
  std::int32_t wall = 0;
  while (std::abs(map.planes[static_cast<std::size_t>(wall)].coefficients[1]) > 0.2)
    ++wall;
  map.openings.resize(2);
  map.openings[0].to = Eigen::Vector3d::UnitX();
  map.openings[0].planes[0] = wall;
  saveMapIfc(path, map, makeFloorPlan(map));
  const StepInstances found(path);
  EXPECT_EQ(found.count("IFCCOLUMN"), 1U);
  EXPECT_EQ(found.count("IFCBUILDINGELEMENTPROXY"), 1U + 2U);
  EXPECT_EQ(found.count("IFCOPENINGELEMENT"), 1U) << "the other one has no wall";
  EXPECT_EQ(found.count("IFCRELVOIDSELEMENT"), 1U);
  EXPECT_EQ(found.doubled, 0U);
  RecessPatch door;
  door.leaf = wall;
  door.reaches_floor = true;
  door.size = {0.9, 2.1, 0.1};
  map.recesses = {door};
  saveMapIfc(path, map, makeFloorPlan(map));
  const StepInstances with_door(path);
  ASSERT_EQ(with_door.count("IFCDOOR"), 1U);
  EXPECT_THAT(with_door.of("IFCDOOR")[0], testing::HasSubstr(",2.1,0.9,.DOOR."));
  EXPECT_EQ(with_door.count("IFCWALL"), found.count("IFCWALL") - 1);
}

TEST(MapIfc, AnEmptyMapIsAnEmptyBuilding)
{
  const TemporaryFolder folder;
  saveMapIfc(folder.path("map.ifc"), {}, {});
  EXPECT_EQ(StepInstances(folder.path("map.ifc")).count("IFCBUILDINGSTOREY"), 1U);
  EXPECT_THROW(saveMapIfc(folder.path("none/map.ifc"), {}, {}), OutputFileException);
}

} // namespace
} // namespace pcl::acmap::test
