#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace pcl {

/** \brief Appearance of a simulated surface. \ingroup simulation */
struct SurfaceLook {
  std::array<std::uint8_t, 3> color{128, 128, 128}; ///< red, green, blue

  /** \brief Standard deviation of the surface texture, in grey levels. A wall with a
   * value of 2 has nearly no texture: stereo matching fails on it. */
  double texture = 2.0;
};

/** \brief A rectangle in space, metres. Its front side is in the direction of edge_u x
 * edge_v; it is visible from both sides. \ingroup simulation */
struct SimulatedRectangle {
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  Eigen::Vector3d edge_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d edge_v = Eigen::Vector3d::UnitY();

  Eigen::Vector3d
  normal() const
  {
    return edge_u.cross(edge_v).normalized();
  }
};

/** \brief The curved side of a cylinder, metres. \ingroup simulation */
struct SimulatedCylinder {
  Eigen::Vector3d base = Eigen::Vector3d::Zero();  ///< a point on the axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY(); ///< from base to top
  double radius = 0.1;
};

/** \brief A disc, metres: the cap of a cylinder. \ingroup simulation */
struct SimulatedDisc {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY(); ///< unit length
  double radius = 0.1;
};

/** \brief A surface of a scene, in the scene's frame. \ingroup simulation */
struct SimulatedSurface {
  std::string name;
  std::variant<SimulatedRectangle, SimulatedCylinder, SimulatedDisc> shape;
  std::int32_t plane = -1; ///< index of its true plane, -1 for none
  SurfaceLook look;
};

/** \brief A true plane, which a mapping method should find. \ingroup simulation */
struct TruthPlane {
  std::string name;

  /** \brief Unit normal, towards the side from which the plane is seen, and offset:
   * a x + b y + c z + d = 0, metres. */
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();

  /** \brief The rectangles in the plane. */
  std::vector<SimulatedRectangle> rectangles;

  /** \brief Total area of its rectangles in square metres, including occluded parts. */
  ACMAP_EXPORT double
  area() const;
};

/** \brief Transforms a plane to another frame.
 * \param[in] plane in frame b
 * \param[in] T_a_b transformation from frame b to frame a \ingroup simulation */
ACMAP_EXPORT TruthPlane
transformPlane(const TruthPlane& plane, const Eigen::Isometry3d& T_a_b);

/** \brief Recesses of equal size in a wall, for example for doors that are set back.
 * They begin at the wall's edge_u (v = 0). \ingroup simulation */
struct WallOpenings {
  std::vector<double> at; ///< metres along edge_u to the near side of each, ascending
  double width = 0.9;     ///< metres along edge_u
  double height = 2.1;    ///< metres along edge_v
  double depth = 0.1;     ///< metres behind the wall
  std::string name;       ///< of the panels and of their common plane
  SurfaceLook panel;      ///< the back of the recess
  SurfaceLook reveal;     ///< its sides and its upper side
  std::string floor; ///< an earlier rectangle, which gives plane and look of the floor
};

/** \brief The faces of a box. \ingroup simulation */
struct BoxFaces {
  bool left = true;   ///< at the minimum x
  bool right = true;  ///< at the maximum x
  bool top = true;    ///< at the minimum y: y points down
  bool bottom = true; ///< at the maximum y
  bool front = true;  ///< at the minimum z
  bool back = true;   ///< at the maximum z
};

/** \brief The surfaces of a simulated building and its true planes.
 *
 * Scene frame: x right, y down, z forward as in the camera, metres. Surfaces and planes
 * are indexed from 0 in the order in which they were added. The planes of a scene are
 * practically exact: rectangles that deviate from their plane by more than a
 * micrometre, or whose normal is opposite, are rejected. \ingroup simulation */
class ACMAP_EXPORT SceneGeometry {
public:
  /** \param[in] name of the surface
   * \param[in] plane name of its true plane; a new name creates a new plane
   * \throws BadArgumentException when an edge is shorter than 1 mm, the edges are not
   * orthogonal, a value is not within 10 km, or the rectangle is not in its plane */
  void
  addRectangle(const std::string& name,
               const std::string& plane,
               const SimulatedRectangle& rectangle,
               const SurfaceLook& look);

  /** \brief Adds a rectangle with recesses. The wall's pieces share one plane, the
   * panels share a second one, and the upper sides of the recesses a third one; each
   * lateral side has a plane of its own.
   * \throws BadArgumentException as \ref addRectangle, and when openings overlap or
   * exceed the wall, or there is no such floor */
  void
  addWall(const std::string& name,
          const std::string& plane,
          const SimulatedRectangle& wall,
          const SurfaceLook& look,
          const WallOpenings& openings);

  /** \brief Adds an axis-aligned box, as rectangles whose normals point outwards. Each
   * face has a plane of its own, "<name> top" and so on.
   * \param[in] minimum corner with the minimum coordinates
   * \param[in] maximum opposite corner
   * \throws BadArgumentException as \ref addRectangle */
  void
  addBox(const std::string& name,
         const Eigen::Vector3d& minimum,
         const Eigen::Vector3d& maximum,
         const SurfaceLook& look,
         const BoxFaces& faces = {});

  /** \brief Adds a cylinder, with or without its two caps; none of them has a true
   * plane.
   * \throws BadArgumentException when radius or length are below 1 mm */
  void
  addCylinder(const std::string& name,
              const SimulatedCylinder& cylinder,
              const SurfaceLook& look,
              bool caps);

  /** \brief Adds all surfaces and planes of another scene.
   * \param[in] shift by which they are moved, metres
   * \param[in] suffix of their names */
  void
  addMoved(const SceneGeometry& other,
           const Eigen::Vector3d& shift,
           const std::string& suffix);

  const std::vector<SimulatedSurface>&
  surfaces() const
  {
    return surfaces_;
  }

  const std::vector<TruthPlane>&
  planes() const
  {
    return planes_;
  }

private:
  std::int32_t
  joinPlane(const std::string& plane, const SimulatedRectangle& rectangle);

  void
  addSurface(SimulatedSurface surface);

  const SimulatedSurface&
  findFloor(const std::string& name) const;

  std::vector<SimulatedSurface> surfaces_;
  std::vector<TruthPlane> planes_;
};

} // namespace pcl
