#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Edge of the cells in which outlines are compared, metres. */
inline constexpr double raster_cell = 0.01;

/** \brief Frame of a plane; u, v and the normal are a right-handed basis. */
struct PlaneFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(); ///< unit
  Eigen::Vector3d v = Eigen::Vector3d::UnitY(); ///< unit

  /** \brief Metres along u and v of the point's projection. */
  Eigen::Vector2d
  flat(const Eigen::Vector3d& point) const
  {
    return {(point - origin).dot(u), (point - origin).dot(v)};
  }

  Eigen::Vector3d
  lifted(const Eigen::Vector2d& place) const
  {
    return origin + place.x() * u + place.y() * v;
  }
};

/** \brief A frame of a plane a x + b y + c z + d = 0; u is the projection of the x axis,
 * or of the z axis for planes that face along x: level for floors and walls. */
PlaneFrame
makePlaneFrame(const Eigen::Vector4d& coefficients);

using FlatLoop = std::vector<Eigen::Vector2d>; ///< metres

/** \brief A set of cells of a plane. Cell (i, j) covers [i, i + 1] x [j, j + 1] cells
 * from the origin of the plane's frame; cells outside of the box are not in the set. */
class CellSet {
public:
  CellSet() = default;

  /** \param[in] box metres */
  explicit CellSet(const Eigen::AlignedBox2d& box);

  bool
  has(int i, int j) const
  {
    return i >= first_i_ && i < end_i_ && j >= first_j_ && j < end_j_ &&
           cells_[indexOf(i, j)] != 0;
  }

  /** \brief Is the cell around a place, in metres, in the set? */
  bool
  hasPlace(const Eigen::Vector2d& place) const;

  /** \brief Adds a cell of the box. */
  void
  add(int i, int j)
  {
    cells_[indexOf(i, j)] = 1;
  }

  /** \brief Adds the cells whose centres are inside of an odd number of the loops: the
   * interior of a polygon with holes. */
  void
  addInside(const std::vector<FlatLoop>& loops);

  /** \brief Is a cell within \a reach cells, measured between centres, in the set? */
  bool
  hasNear(int i, int j, int reach) const;

  /** \brief Are all cells within \a reach cells in the set? */
  bool
  hasAllNear(int i, int j, int reach) const;

  /** \brief Square metres. */
  double
  area() const;

  /** \brief Calls visit (i, j) for each cell of the set. */
  template <typename Visitor>
  void
  forEach(const Visitor& visit) const
  {
    for (int i = first_i_; i < end_i_; ++i)
      for (int j = first_j_; j < end_j_; ++j)
        if (cells_[indexOf(i, j)] != 0)
          visit(i, j);
  }

private:
  std::size_t
  indexOf(int i, int j) const
  {
    return static_cast<std::size_t>(i - first_i_) *
               static_cast<std::size_t>(end_j_ - first_j_) +
           static_cast<std::size_t>(j - first_j_);
  }

  int first_i_ = 0, end_i_ = 0, first_j_ = 0, end_j_ = 0;
  std::vector<std::uint8_t> cells_;
};

/** \brief Centre of a cell, metres. */
inline Eigen::Vector2d
cellCenter(int i, int j)
{
  return {raster_cell * (i + 0.5), raster_cell * (j + 0.5)};
}

Eigen::AlignedBox2d
boxOf(const std::vector<FlatLoop>& loops);

/** \brief An edge of an outline; metres. */
struct OutlineEdge {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /** \brief Other planes with an edge that has the same end points, bit by bit. */
  std::vector<std::size_t> partners;

  double
  distance(const Eigen::Vector3d& point) const;
};

/** \brief The polygons of a plane, in the frame that was asked for. */
struct PlaneOutline {
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
  Eigen::AlignedBox3d box;
  std::vector<OutlineEdge> edges;

  /** \brief Loops of each polygon, projected into \ref frame; the outer one first. */
  std::vector<std::vector<FlatLoop>> polygons;
  PlaneFrame frame;

  bool
  contains(const Eigen::Vector3d& point) const;

  /** \brief Distance within the plane from a point's projection to the polygons; 0
   * inside, infinite without polygons. */
  double
  distanceWithin(const Eigen::Vector3d& point) const;

  /** \brief Distance to the nearest edge; infinite without edges. */
  double
  distanceToEdges(const Eigen::Vector3d& point) const;

  /** \brief Distance to the surface of the polygons. */
  double
  distanceToSurface(const Eigen::Vector3d& point) const;
};

/** \brief The outlines of all planes of a map.
 * \param[in] T_out_map metres; the bits of the end points are compared before they are
 * transformed */
std::vector<PlaneOutline>
makeOutlines(const std::vector<PlanePatch>& planes,
             const Eigen::Isometry3d& T_out_map = Eigen::Isometry3d::Identity());

/** \brief Counts of outlines. */
struct OutlineCounts {
  std::size_t planes = 0;
  double vertices_mean = 0; ///< of a plane
  double vertices_median = 0;
  std::size_t polygons = 0;
  std::size_t holes = 0;
  std::size_t slivers = 0; ///< holes below 1 dm2
  std::size_t crossed = 0; ///< polygons with edges that cross each other
  double area = 0;         ///< square metres, of the polygons
};

OutlineCounts
countOutlines(const std::vector<PlaneOutline>& outlines);

/** \brief A true plane with the part of it that the cameras saw. Several of a scene that
 * lie in one plane, such as the tops of two tables, are one face. */
struct VisibleFace {
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
  PlaneFrame frame;
  CellSet all;  ///< its rectangles
  CellSet seen; ///< of these, the cells whose centres a camera saw
};

/** \brief A centimetre of the common line of two faces, beside which both were seen. */
struct CreaseSample {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::array<std::size_t, 2> faces{};
};

/** \brief What the cameras of a scene saw of its planes, in the scene's frame: the
 * reference for outlines. A point is seen if it is in the image of a view, within the
 * sensor's reach, and nothing is in front of it. Curved surfaces only occlude. */
struct VisibleTruth {
  std::vector<VisibleFace> faces;

  /** \brief Creases, in steps of \ref raster_cell: both faces exist beside the line and
   * were seen at 2.5 and 3.5 cm from it, on one side or both. */
  std::vector<CreaseSample> creases;

  /** \brief Corners of the faces' boundaries, without duplicates; the surface was seen
   * on all sides at 2.5 cm where it exists. */
  std::vector<Eigen::Vector3d> corners;

  double
  seenArea() const;
};

VisibleTruth
findVisibleTruth(const SimulatedScene& scene);

/** \brief How outlines agree with the visible truth. Lengths in metres, areas in square
 * metres. */
struct OutlineScores {
  /** \brief Plane of the truth for each plane of the map, -1 for none: the face with
   * the largest part of its outline, if that is at least half of it, the normals are
   * within 5 degrees and the corners within 3 cm of the true plane on average. */
  std::vector<std::int32_t> face_of_plane;
  double unmatched_area = 0; ///< of planes without a face

  double creases = 0; ///< see VisibleTruth::creases
  /** \brief Of these, both faces have planes of the map whose outlines are within 0.5 m:
   * a face may consist of several parts. */
  double found = 0;
  double shared = 0; ///< of these, within 1 cm of an edge that both planes have
  double gaps = 0;   ///< of the found, an outline ends more than 1 cm away

  // of the faces that have planes of the map
  double seen = 0;
  double common = 0;         ///< seen and inside an outline
  double joined = 0;         ///< seen or inside an outline
  double missing = 0;        ///< seen, but outside of the outlines
  double missing_inside = 0; ///< of it, more than 5 cm from where nothing was seen
  double unseen = 0;         ///< inside an outline, on the face, but not seen
  double nothing = 0;        ///< inside an outline, where there is no surface
  double nothing_inside = 0; ///< of it, more than 5 cm from the face

  /** \brief Distances of the true corners from the nearest vertex, at most 0.5. */
  std::vector<double> corners;
};

/** \param[in] outlines in the frame of the truth */
OutlineScores
scoreOutlines(const std::vector<PlaneOutline>& outlines, const VisibleTruth& truth);

/** \brief A map whose outlines are judged. */
struct JudgedMap {
  std::vector<PlanePatch> planes;
  double seconds = 0; ///< CPU time of the outlines
};

/** \brief The planes of a cloud, with the defaults of PlaneMapping.
 * \param[in] viewpoints the sensor positions of its field `view` */
JudgedMap
findJudgedMap(const std::shared_ptr<const PointCloudFile>& cloud,
              const std::vector<Eigen::Vector3f>& viewpoints);

/** \brief The same for all views of a scene, with their true poses. */
JudgedMap
findJudgedMap(const SimulatedScene& scene);

} // namespace pcl::acmap::bench
