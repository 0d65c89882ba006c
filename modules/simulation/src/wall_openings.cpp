#include <pcl/core/exceptions.h>
#include <pcl/simulation/scene_geometry.h>

#include <pcl/core/impl/arguments.h>

namespace pcl {

namespace {

constexpr double thinnest = 1e-3; // metres

/** \brief Frame of a wall for rectangles: u along its foot, v up, w behind it. */
class WallFrame {
public:
  explicit WallFrame(const SimulatedRectangle& wall)
  : corner_(wall.corner)
  , u_(wall.edge_u.normalized())
  , v_(wall.edge_v.normalized())
  , w_(-wall.normal())
  {}

  Eigen::Vector3d
  along(double u, double v, double w) const
  {
    return u * u_ + v * v_ + w * w_;
  }

  /** \param[in] at position of the corner; positions and edges are coordinates along u
   * v w */
  SimulatedRectangle
  rectangle(const Eigen::Vector3d& at,
            const Eigen::Vector3d& edge_u,
            const Eigen::Vector3d& edge_v) const
  {
    return {corner_ + along(at.x(), at.y(), at.z()),
            along(edge_u.x(), edge_u.y(), edge_u.z()),
            along(edge_v.x(), edge_v.y(), edge_v.z())};
  }

private:
  Eigen::Vector3d corner_;
  Eigen::Vector3d u_, v_, w_;
};

void
requireInside(const std::string& name,
              const WallOpenings& openings,
              double length,
              double height)
{
  using acmap::requireInRange;
  const std::string of = name + ": openings' ";
  requireInRange(of + "width", openings.width, thinnest, length, "m");
  requireInRange(of + "height", openings.height, thinnest, height - thinnest, "m");
  requireInRange(of + "depth", openings.depth, thinnest, length, "m");
  double free_from = 0.0;
  for (const double at : openings.at) {
    requireInRange(of + "at",
                   at,
                   free_from + thinnest,
                   length - openings.width - thinnest,
                   "m, after the one before");
    free_from = at + openings.width;
  }
}

} // namespace

const SimulatedSurface&
SceneGeometry::findFloor(const std::string& name) const
{
  for (const SimulatedSurface& surface : surfaces_)
    if (surface.name == name && surface.plane >= 0)
      return surface;
  throw acmap::BadArgument("openings: there is no rectangle '" + name +
                           "' before them for their floor");
}

void
SceneGeometry::addWall(const std::string& name,
                       const std::string& plane,
                       const SimulatedRectangle& wall,
                       const SurfaceLook& look,
                       const WallOpenings& openings)
{
  const double length = wall.edge_u.norm();
  const double height = wall.edge_v.norm();
  requireInside(name, openings, length, height);
  const WallFrame frame(wall);
  const SimulatedSurface floor = findFloor(openings.floor);
  const std::string floor_plane = planes_[std::size_t(floor.plane)].name;
  const double width = openings.width, top = openings.height, depth = openings.depth;
  SceneGeometry extended(*this); // add all pieces or none
  double from = 0.0;
  const auto add_pier = [&](double to) {
    extended.addRectangle(
        name,
        plane,
        frame.rectangle({from, 0, 0}, {to - from, 0, 0}, {0, height, 0}),
        look);
  };
  std::size_t number = 0;
  for (const double at : openings.at) {
    const std::string each = openings.name + " " + std::to_string(++number);
    const auto add_reveal = [&](const std::string& its_plane,
                                const SimulatedRectangle& rectangle) {
      extended.addRectangle(each + " reveal", its_plane, rectangle, openings.reveal);
    };
    add_pier(at);
    extended.addRectangle(
        name,
        plane,
        frame.rectangle({at, top, 0}, {width, 0, 0}, {0, height - top, 0}),
        look);
    extended.addRectangle(each,
                          openings.name,
                          frame.rectangle({at, 0, depth}, {width, 0, 0}, {0, top, 0}),
                          openings.panel);
    add_reveal(each + " near side",
               frame.rectangle({at, 0, 0}, {0, 0, depth}, {0, top, 0}));
    add_reveal(each + " far side",
               frame.rectangle({at + width, 0, 0}, {0, top, 0}, {0, 0, depth}));
    add_reveal(openings.name + " heads",
               frame.rectangle({at, top, 0}, {0, 0, depth}, {width, 0, 0}));
    extended.addRectangle(each + " floor",
                          floor_plane,
                          frame.rectangle({at, 0, 0}, {width, 0, 0}, {0, 0, depth}),
                          floor.look);
    from = at + width;
  }
  add_pier(length);
  *this = std::move(extended);
}

} // namespace pcl
