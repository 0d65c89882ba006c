#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace pcl {

/** \brief What a simulated surface looks like. \ingroup simulation */
struct SurfaceLook {
  std::array<std::uint8_t, 3> color{128, 128, 128}; ///< red, green, blue

  /** \brief One standard deviation of the grain of the surface, grey levels. A wall of
   * 2 is nearly textureless: stereo finds nothing on it. */
  double texture = 2.0;
};

/** \brief A rectangle in space, metres; it looks to the side of edge_u x edge_v, and is
 * hit from both. \ingroup simulation */
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
  Eigen::Vector3d base = Eigen::Vector3d::Zero();  ///< on the axis
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
  std::int32_t plane = -1; ///< index of its truth plane, -1 for none
  SurfaceLook look;
};

/** \brief A plane of the truth: what a mapper should find. \ingroup simulation */
struct TruthPlane {
  std::string name;

  /** \brief Unit normal, towards the side the plane is seen from, and offset:
   * a x + b y + c z + d = 0, metres. */
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();

  /** \brief The rectangles that lie in it. */
  std::vector<SimulatedRectangle> rectangles;

  /** \brief Square metres of all its rectangles; what other surfaces hide counts. */
  ACMAP_EXPORT double
  area() const;
};

/** \brief The same plane in another frame.
 * \param[in] plane in frame b
 * \param[in] T_a_b the motion from frame b to frame a \ingroup simulation */
ACMAP_EXPORT TruthPlane
transformPlane(const TruthPlane& plane, const Eigen::Isometry3d& T_a_b);

/** \brief Recesses in a wall, all of one size: doors that lie back from it, say. They
 * begin at the wall's edge_u (v = 0). \ingroup simulation */
struct WallOpenings {
  std::vector<double> at; ///< metres along edge_u to the near side of each, rising
  double width = 0.9;     ///< metres along edge_u
  double height = 2.1;    ///< metres along edge_v
  double depth = 0.1;     ///< metres behind the wall
  std::string name;       ///< of the panels and of their common plane
  SurfaceLook panel;      ///< the back of the recess
  SurfaceLook reveal;     ///< its sides and its head
  std::string floor;      ///< an earlier rectangle: plane and look of the floor
};

/** \brief The faces of a box. \ingroup simulation */
struct BoxFaces {
  bool left = true;   ///< at the least x
  bool right = true;  ///< at the largest x
  bool top = true;    ///< at the least y: y points down
  bool bottom = true; ///< at the largest y
  bool front = true;  ///< at the least z
  bool back = true;   ///< at the largest z
};

/** \brief The surfaces of a simulated building and its true planes.
 *
 * Scene frame: x right, y down, z forward as in the camera, metres. Surfaces and planes
 * are counted from 0 in the order they were added; the planes of a scene are as good as
 * flat: rectangles that leave the plane they name by more than a micrometre, or look to
 * its other side, are refused. \ingroup simulation */
class ACMAP_EXPORT SceneGeometry {
public:
  /** \param[in] name of the surface
   * \param[in] plane its truth plane; a name that is new makes a new plane
   * \throws BadArgumentException when an edge is shorter than 1 mm, the edges are not at
   * right angles, a value is not within 10 km, or the rectangle is not in its plane */
  void
  addRectangle(const std::string& name,
               const std::string& plane,
               const SimulatedRectangle& rectangle,
               const SurfaceLook& look);

  /** \brief A rectangle with recesses; the wall's pieces share one plane, the panels
   * another; heads share one and sides have one each.
   * \throws BadArgumentException as \ref addRectangle, and when openings overlap or
   * reach over the wall, or the floor is none */
  void
  addWall(const std::string& name,
          const std::string& plane,
          const SimulatedRectangle& wall,
          const SurfaceLook& look,
          const WallOpenings& openings);

  /** \brief A box with its edges along the axes, as rectangles that look outwards; each
   * face has a plane of its own, "<name> top" and so on.
   * \param[in] least corner with the least coordinates
   * \param[in] most opposite corner
   * \throws BadArgumentException as \ref addRectangle */
  void
  addBox(const std::string& name,
         const Eigen::Vector3d& least,
         const Eigen::Vector3d& most,
         const SurfaceLook& look,
         const BoxFaces& faces = {});

  /** \brief A cylinder, with or without its two caps; none of them has a truth plane.
   * \throws BadArgumentException when radius or length are below 1 mm */
  void
  addCylinder(const std::string& name,
              const SimulatedCylinder& cylinder,
              const SurfaceLook& look,
              bool caps);

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
