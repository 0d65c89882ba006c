#include "export/map_writers.h"
#include "export/step_file.h"

#include <pcl/core/box_sides.h>
#include <pcl/core/build_config.h>
#include <pcl/core/cylinder_facets.h>
#include <pcl/core/output_file.h>
#include <pcl/core/polygon_triangles.h>
#include <pcl/texture/map_ifc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
namespace {

/** \brief An identifier of 128 bits that depends on a name only, in the 22 digits of IFC. */
std::string
guidOf(const std::string& name)
{
  constexpr char digits[] =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  constexpr std::uint64_t prime = 1099511628211U;
  std::string guid;
  std::uint64_t hash = 14695981039346656037U; // FNV-1a
  for (const char c : "acmap " + name)
    hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  for (int digit = 0; digit < 22; ++digit) {
    hash = (hash ^ static_cast<std::uint64_t>(digit)) * prime;
    guid += digits[digit == 0 ? hash >> 32 & 3 : hash >> 32 & 63];
  }
  return guid;
}

/** \brief Triangles of surfaces in the frame of the model. */
struct ModelShape {
  std::vector<std::vector<double>> points;
  std::vector<std::vector<std::size_t>> triangles; ///< corners from 1 on
  bool is_closed = false;
};

/** \brief Writes a map as instances. */
class IfcModel {
public:
  IfcModel(const CompactMap& map, const FloorPlan& plan)
  : map_(map)
  , plan_(plan)
  , up_(plan.up)
  , floor_(plan.floor)
  {
    Eigen::Matrix3d to_z_up; // from a frame with y up
    to_z_up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    turn_ = to_z_up * turnToYUp(map);
    addProject();
    addBoxes();
    addCylinders();
    addRecesses();
    addPlanes();
    addOpenings();
    addSpaces();
    aggregate("storey", storey_, spaces_);
    if (!elements_.empty())
      file_.add("IFCRELCONTAINEDINSPATIALSTRUCTURE",
                guidOf("contents"),
                nullptr,
                nullptr,
                nullptr,
                elements_,
                storey_);
  }

  std::string
  text() const
  {
    return "ISO-10303-21;\nHEADER;\n"
           "FILE_DESCRIPTION(('ViewDefinition [ReferenceView_V1.2]'),'2;1');\n"
           "FILE_NAME('map.ifc','1970-01-01T00:00:00',(''),(''),'acmap " ACMAP_VERSION
           "','acmap','');\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" +
           file_.text() + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

private:
  using References = std::vector<StepReference>;

  StepReference
  addPlacement(StepReference relative_to)
  {
    return file_.add("IFCLOCALPLACEMENT", relative_to, axes_);
  }

  /** \brief The place of the site, by the shift of the map in the grid of its input. */
  StepReference
  addSitePlacement()
  {
    if (map_.shift.isZero(0))
      return addPlacement({});
    const Eigen::Vector3d place = turn_ * map_.shift;
    const StepReference point = file_.add(
        "IFCCARTESIANPOINT", std::vector<double>{place.x(), place.y(), place.z()});
    return file_.add("IFCLOCALPLACEMENT",
                     StepReference(),
                     file_.add("IFCAXIS2PLACEMENT3D", point, nullptr, nullptr));
  }

  /** \brief Makes parts of a whole in the tree of project, site, building, storey. */
  void
  aggregate(const std::string& name, StepReference whole, const References& parts)
  {
    if (!parts.empty())
      file_.add("IFCRELAGGREGATES",
                guidOf("parts of " + name),
                nullptr,
                nullptr,
                nullptr,
                whole,
                parts);
  }

  void
  addProject()
  {
    const StepReference origin =
        file_.add("IFCCARTESIANPOINT", std::vector<double>{0, 0, 0});
    axes_ = file_.add("IFCAXIS2PLACEMENT3D", origin, nullptr, nullptr);
    context_ = file_.add("IFCGEOMETRICREPRESENTATIONCONTEXT",
                         nullptr,
                         "Model",
                         std::size_t{3},
                         1e-5,
                         axes_,
                         nullptr);
    References units;
    for (const auto& [kind, unit] : {std::pair("LENGTHUNIT", "METRE"),
                                     {"AREAUNIT", "SQUARE_METRE"},
                                     {"VOLUMEUNIT", "CUBIC_METRE"},
                                     {"PLANEANGLEUNIT", "RADIAN"}})
      units.push_back(file_.add(
          "IFCSIUNIT", StepDerived(), StepEnum{kind}, nullptr, StepEnum{unit}));
    const StepReference assignment = file_.add("IFCUNITASSIGNMENT", units);
    const StepReference project = file_.add("IFCPROJECT",
                                            guidOf("project"),
                                            nullptr,
                                            "Compact map",
                                            nullptr,
                                            nullptr,
                                            nullptr,
                                            nullptr,
                                            References{context_},
                                            assignment);
    const StepEnum whole{"ELEMENT"};
    const StepReference site_place = addSitePlacement();
    const StepReference site = file_.add("IFCSITE",
                                         guidOf("site"),
                                         nullptr,
                                         "Site",
                                         nullptr,
                                         nullptr,
                                         site_place,
                                         nullptr,
                                         nullptr,
                                         whole,
                                         nullptr,
                                         nullptr,
                                         nullptr,
                                         nullptr,
                                         nullptr);
    const StepReference building_place = addPlacement(site_place);
    const StepReference building = file_.add("IFCBUILDING",
                                             guidOf("building"),
                                             nullptr,
                                             "Building",
                                             nullptr,
                                             nullptr,
                                             building_place,
                                             nullptr,
                                             nullptr,
                                             whole,
                                             nullptr,
                                             nullptr,
                                             nullptr);
    place_ = addPlacement(building_place);
    storey_ = file_.add("IFCBUILDINGSTOREY",
                        guidOf("storey"),
                        nullptr,
                        "Storey",
                        nullptr,
                        nullptr,
                        place_,
                        nullptr,
                        nullptr,
                        whole,
                        nullptr);
    aggregate("project", project, {site});
    aggregate("site", site, {building});
    aggregate("building", building, {storey_});
  }

  void
  addTriangles(const PlanePatch& surface, ModelShape& shape) const
  {
    for (const PlanePolygon& polygon : surface.polygons) {
      const std::size_t first = shape.points.size() + 1;
      for (const Eigen::Vector3f& point : pointsOfPolygon(polygon)) {
        const Eigen::Vector3d place = turn_ * point.cast<double>();
        shape.points.push_back({place.x(), place.y(), place.z()});
      }
      for (const auto& triangle :
           trianglesOfPolygon(polygon, surface.coefficients.head<3>()))
        shape.triangles.push_back(
            {first + triangle[0], first + triangle[1], first + triangle[2]});
    }
  }

  StepReference
  addShape(const ModelShape& shape)
  {
    if (shape.triangles.empty())
      return {};
    const StepReference points = file_.add("IFCCARTESIANPOINTLIST3D", shape.points);
    const StepReference faces = file_.add("IFCTRIANGULATEDFACESET",
                                          points,
                                          nullptr,
                                          StepEnum{shape.is_closed ? "T" : "F"},
                                          shape.triangles,
                                          nullptr);
    const StepReference body = file_.add(
        "IFCSHAPEREPRESENTATION", context_, "Body", "Tessellation", References{faces});
    return file_.add("IFCPRODUCTDEFINITIONSHAPE", nullptr, nullptr, References{body});
  }

  /** \brief Adds a product of the storey.
   * \param[in] id from which its identifiers follow; its tag
   * \param[in] name that is shown; empty: the id
   * \param[in] more values after its representation and its tag */
  template <typename... Values>
  StepReference
  addProduct(const char* type,
             const std::string& id,
             const std::string& name,
             StepReference surface,
             const Values&... more)
  {
    return file_.add(type,
                     guidOf(id),
                     nullptr,
                     name.empty() ? id : name,
                     nullptr,
                     nullptr,
                     addPlacement(place_),
                     surface,
                     id,
                     more...);
  }

  /** \brief Adds an element that has a predefined type. */
  StepReference
  addElement(const char* type,
             const std::string& id,
             const std::string& name,
             const ModelShape& shape,
             const char* predefined = "NOTDEFINED")
  {
    elements_.push_back(
        addProduct(type, id, name, addShape(shape), StepEnum{predefined}));
    return elements_.back();
  }

  StepReference
  property(const char* name, const StepMeasure& value)
  {
    return file_.add("IFCPROPERTYSINGLEVALUE", name, nullptr, value, nullptr);
  }

  void
  addProperties(StepReference element, const std::string& name, References properties)
  {
    const StepReference set = file_.add("IFCPROPERTYSET",
                                        guidOf("properties of " + name),
                                        nullptr,
                                        "acmap_Plane",
                                        nullptr,
                                        properties);
    file_.add("IFCRELDEFINESBYPROPERTIES",
              guidOf("has properties " + name),
              nullptr,
              nullptr,
              nullptr,
              References{element},
              set);
  }

  void
  addPlaneProperties(StepReference element, const std::string& name, std::size_t id)
  {
    const PlanePatch& plane = map_.planes[id];
    std::vector<StepMeasure> covariance;
    for (Eigen::Index i = 0; i < 9; ++i)
      covariance.push_back({"IFCREAL", plane.covariance(i / 3, i % 3)});
    addProperties(element,
                  name,
                  {property("Area", {"IFCAREAMEASURE", plane.area}),
                   property("RootMeanSquare", {"IFCLENGTHMEASURE", plane.rms}),
                   property("Support", {"IFCREAL", static_cast<double>(plane.support)}),
                   file_.add("IFCPROPERTYLISTVALUE",
                             "CovarianceOfSlopesAndOffset",
                             nullptr,
                             covariance,
                             nullptr)});
  }

  void
  addBoxes()
  {
    for (std::size_t i = 0; i < map_.boxes.size(); ++i) {
      ModelShape shape;
      for (const BoxFace& face : map_.boxes[i].faces)
        if (face.kind == BoxFaceKind::Seen && has(face.plane)) {
          addTriangles(map_.planes[static_cast<std::size_t>(face.plane)], shape);
          used_.insert(face.plane);
        }
      for (const PlanePatch& side : freeSidesOf(map_.boxes[i]))
        addTriangles(side, shape);
      addElement("IFCBUILDINGELEMENTPROXY",
                 "Box " + std::to_string(i),
                 map_.boxes[i].name,
                 shape);
    }
  }

  void
  addCylinders()
  {
    for (std::size_t i = 0; i < map_.cylinders.size(); ++i) {
      const CylinderPatch& cylinder = map_.cylinders[i];
      ModelShape shape;
      for (const PlanePatch& facet : facetsOfCylinder(cylinder))
        addTriangles(facet, shape);
      const bool is_column = !cylinder.is_hollow &&
                             std::abs(cylinder.axis_direction.dot(up_)) > level_cosine;
      addElement(is_column ? "IFCCOLUMN" : "IFCBUILDINGELEMENTPROXY",
                 "Cylinder " + std::to_string(i),
                 cylinder.label.name,
                 shape);
    }
  }

  void
  addRecesses()
  {
    for (std::size_t i = 0; i < map_.recesses.size(); ++i) {
      const RecessPatch& recess = map_.recesses[i];
      if (!recess.reaches_floor || !has(recess.leaf) ||
          !used_.insert(recess.leaf).second)
        continue;
      const std::string name = "Door " + std::to_string(i);
      ModelShape shape;
      addTriangles(map_.planes[static_cast<std::size_t>(recess.leaf)], shape);
      elements_.push_back(addProduct("IFCDOOR",
                                     name,
                                     recess.name,
                                     addShape(shape),
                                     recess.size[1],
                                     recess.size[0],
                                     StepEnum{"DOOR"},
                                     StepEnum{"NOTDEFINED"},
                                     nullptr));
      addPlaneProperties(elements_.back(), name, static_cast<std::size_t>(recess.leaf));
    }
  }

  bool
  has(std::int32_t plane) const
  {
    return plane >= 0 && static_cast<std::size_t>(plane) < map_.planes.size();
  }

  double
  levelOf(const PlanePatch& plane) const
  {
    return plane.coefficients.head<3>().dot(up_);
  }

  void
  addPlanes()
  {
    walls_.resize(map_.planes.size());
    for (std::size_t id = 0; id < map_.planes.size(); ++id) {
      if (used_.count(static_cast<std::int32_t>(id)) > 0)
        continue;
      const PlanePatch& plane = map_.planes[id];
      const std::string name = "Plane " + std::to_string(id);
      ModelShape shape;
      addTriangles(plane, shape);
      const auto [type, predefined] = elementOf(plane);
      const StepReference element =
          addElement(type, name, plane.label.name, shape, predefined);
      if (std::string_view(type) == "IFCWALL")
        walls_[id] = element;
      addPlaneProperties(element, name, id);
    }
  }

  /** \brief Type and predefined type of the element that a plane is: by its role, or by its
   * direction if it is not named. */
  std::pair<const char*, const char*>
  elementOf(const PlanePatch& plane) const
  {
    constexpr double floor_range = 0.3; // metres
    const double level = levelOf(plane);
    SurfaceRole role = plane.label.role;
    if (plane.label.name.empty())
      role = std::abs(level) < upright_cosine ? SurfaceRole::Wall
             : level > level_cosine &&
                     std::abs(plane.center.dot(up_) - floor_) <= floor_range
                 ? SurfaceRole::Floor
             : level < -level_cosine ? SurfaceRole::Ceiling
                                     : SurfaceRole::Other;
    switch (role) {
    case SurfaceRole::Wall:
      return {"IFCWALL", "NOTDEFINED"};
    case SurfaceRole::Floor:
      return {"IFCSLAB", "FLOOR"};
    case SurfaceRole::Ceiling:
      return {"IFCCOVERING", "CEILING"};
    case SurfaceRole::Furniture:
      return {"IFCFURNITURE", "NOTDEFINED"};
    case SurfaceRole::DoorLeaf:
    case SurfaceRole::Other:
      break;
    }
    return {"IFCBUILDINGELEMENTPROXY", "NOTDEFINED"};
  }

  /** \brief A box around an opening, through its wall. */
  ModelShape
  openingShape(const MapOpening& opening) const
  {
    constexpr double half_depth = 0.1, usual_height = 2; // metres
    const double top =
        std::isfinite(opening.top) ? opening.top : opening.bottom + usual_height;
    const Eigen::Vector3d aside =
        half_depth * (opening.to - opening.from).cross(up_).normalized();
    ModelShape shape;
    shape.is_closed = true;
    const Eigen::Vector3d corners[] = {opening.from - aside,
                                       opening.to - aside,
                                       opening.to + aside,
                                       opening.from + aside};
    for (const double height : {opening.bottom, top})
      for (const Eigen::Vector3d& place : corners) {
        const Eigen::Vector3d p = turn_ * (place + height * up_);
        shape.points.push_back({p.x(), p.y(), p.z()});
      }
    shape.triangles = {{1, 3, 2},
                       {1, 4, 3},
                       {5, 6, 7},
                       {5, 7, 8},
                       {1, 2, 6},
                       {1, 6, 5},
                       {2, 3, 7},
                       {2, 7, 6},
                       {3, 4, 8},
                       {3, 8, 7},
                       {4, 1, 5},
                       {4, 5, 8}};
    return shape;
  }

  void
  addOpenings()
  {
    for (std::size_t i = 0; i < map_.openings.size(); ++i) {
      const MapOpening& opening = map_.openings[i];
      const std::int32_t wall = opening.planes[0];
      if (!has(wall) || walls_[static_cast<std::size_t>(wall)].number == 0)
        continue;
      const std::string name = "Opening " + std::to_string(i);
      const StepReference element = addProduct("IFCOPENINGELEMENT",
                                               name,
                                               opening.label.name,
                                               addShape(openingShape(opening)),
                                               StepEnum{"OPENING"});
      file_.add("IFCRELVOIDSELEMENT",
                guidOf("voids " + name),
                nullptr,
                nullptr,
                nullptr,
                walls_[static_cast<std::size_t>(wall)],
                element);
    }
  }

  /** \brief Height of a room above its floor: that of the highest point of its planes that face
   * down. */
  double
  heightOf(const MapRoom& room) const
  {
    constexpr double usual = 2.5; // metres
    double height = 0;
    for (const std::int32_t id : room.planes) {
      if (!has(id) ||
          levelOf(map_.planes[static_cast<std::size_t>(id)]) > -upright_cosine)
        continue;
      for (const PlanePolygon& polygon :
           map_.planes[static_cast<std::size_t>(id)].polygons)
        for (const Eigen::Vector3f& corner : polygon.outer)
          height = std::max(height, corner.cast<double>().dot(up_) - floor_);
    }
    return height > 0 ? height : usual;
  }

  /** \brief The outline of a room, extruded from the floor to the ceiling; none if the plan
   * does not have the room. */
  StepReference
  addSpaceShape(std::size_t i)
  {
    if (i >= plan_.rooms.size() || plan_.rooms[i].outline.size() < 3)
      return {};
    References corners;
    for (const Eigen::Vector2d& corner : plan_.rooms[i].outline) {
      const Eigen::Vector3d place =
          turn_ * (corner.x() * plan_.x_axis + corner.y() * plan_.y_axis);
      corners.push_back(
          file_.add("IFCCARTESIANPOINT", std::vector<double>{place.x(), place.y()}));
    }
    corners.push_back(corners.front());
    const StepReference border = file_.add("IFCPOLYLINE", corners);
    const StepReference profile =
        file_.add("IFCARBITRARYCLOSEDPROFILEDEF", StepEnum{"AREA"}, nullptr, border);
    const StepReference origin = file_.add(
        "IFCCARTESIANPOINT", std::vector<double>{0, 0, (turn_ * (floor_ * up_)).z()});
    const StepReference place =
        file_.add("IFCAXIS2PLACEMENT3D", origin, nullptr, nullptr);
    const StepReference upwards =
        file_.add("IFCDIRECTION", std::vector<double>{0, 0, 1});
    const StepReference solid = file_.add(
        "IFCEXTRUDEDAREASOLID", profile, place, upwards, heightOf(map_.rooms[i]));
    const StepReference body = file_.add(
        "IFCSHAPEREPRESENTATION", context_, "Body", "SweptSolid", References{solid});
    return file_.add("IFCPRODUCTDEFINITIONSHAPE", nullptr, nullptr, References{body});
  }

  void
  addSpaces()
  {
    for (std::size_t i = 0; i < map_.rooms.size(); ++i) {
      const std::string name = "Room " + std::to_string(i + 1);
      spaces_.push_back(addProduct("IFCSPACE",
                                   name,
                                   map_.rooms[i].label.name,
                                   addSpaceShape(i),
                                   StepEnum{"ELEMENT"},
                                   StepEnum{"INTERNAL"},
                                   nullptr));
      const StepReference area = file_.add("IFCQUANTITYAREA",
                                           "NetFloorArea",
                                           nullptr,
                                           nullptr,
                                           map_.rooms[i].area,
                                           nullptr);
      const StepReference quantities = file_.add("IFCELEMENTQUANTITY",
                                                 guidOf("quantities of " + name),
                                                 nullptr,
                                                 "Qto_SpaceBaseQuantities",
                                                 nullptr,
                                                 nullptr,
                                                 References{area});
      file_.add("IFCRELDEFINESBYPROPERTIES",
                guidOf("has quantities " + name),
                nullptr,
                nullptr,
                nullptr,
                References{spaces_.back()},
                quantities);
    }
  }

  const CompactMap& map_;
  const FloorPlan& plan_;
  Eigen::Vector3d up_;
  double floor_;         ///< height along up_
  Eigen::Matrix3d turn_; ///< from the map to a frame with z up
  StepFile file_;
  StepReference axes_, context_, place_, storey_;
  References elements_, spaces_;
  References walls_;            ///< for each plane
  std::set<std::int32_t> used_; ///< planes that are parts of other elements
};

} // namespace
} // namespace acmap

void
saveMapIfc(const std::string& path, const CompactMap& map, const FloorPlan& plan)
{
  const std::string text = acmap::IfcModel(map, plan).text();
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
