#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/disjoint_sets.h>
#include <pcl/pipeline/detail_mesh.h>

#include <Eigen/Geometry>

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {

namespace {

using Triangle = TriangleMesh::Triangle;
using Triangles = std::vector<Triangle>;

/** \brief Bytes of a vertex and of a triangle in map.glb. */
constexpr std::size_t vertex_bytes = 20, short_triangle_bytes = 6, triangle_bytes = 12;

std::size_t
bytesOf(std::size_t vertices, std::size_t triangles)
{
  const bool is_short = vertices < std::numeric_limits<std::uint16_t>::max();
  return vertices * vertex_bytes +
         triangles * (is_short ? short_triangle_bytes : triangle_bytes);
}

class DetailMaker {
public:
  explicit DetailMaker(const MappedPlanes& found)
  : found_(found)
  , points_(acmap::requirePoints(found.vertices))
  , color_(acmap::findColor(found.vertices.layout()))
  , labels_(found.vertex_labels)
  {}

  MapDetails
  make(std::size_t max_bytes)
  {
    leaveOutNoise();
    takeTriangles();
    dropSmallPieces();
    if (corners_.empty())
      return {};
    // half of the triangles have a vertex of their own in a large mesh
    const std::size_t enough = max_bytes / (vertex_bytes / 2 + short_triangle_bytes);
    simplify(0, static_cast<float>(found_.spacing / 2));
    if (corners_.size() / 3 > enough)
      simplify(3 * enough, std::numeric_limits<float>::max());
    return details(max_bytes);
  }

private:
  bool
  isOnSurface(std::int32_t vertex) const
  {
    const auto i = static_cast<std::size_t>(vertex);
    return labels_[i] >= 0 ||
           (!found_.vertex_cylinders.empty() && found_.vertex_cylinders[i] >= 0);
  }

  /** \brief Is a vertex within three times the noise of a plane, or a spacing? */
  bool
  isNear(std::int32_t vertex, std::int32_t plane) const
  {
    const PlanePatch& patch = found_.planes[static_cast<std::size_t>(plane)];
    const Eigen::Vector3d place =
        points_[static_cast<std::size_t>(vertex)].cast<double>();
    return std::abs(patch.coefficients.dot(place.homogeneous())) <=
           std::max(3 * patch.rms, found_.spacing);
  }

  /** \brief Gives a plane to the vertices beside it that only noise keeps off it. */
  void
  leaveOutNoise()
  {
    constexpr int max_sweeps = 8;
    bool has_changed = true;
    for (int sweep = 0; sweep < max_sweeps && has_changed; ++sweep) {
      has_changed = false;
      for (const Triangle& triangle : found_.mesh.triangles)
        for (std::size_t c = 0; c < triangle.size(); ++c) {
          std::int32_t& label = labels_[static_cast<std::size_t>(triangle[c])];
          const std::int32_t beside =
              labels_[static_cast<std::size_t>(triangle[(c + 1) % 3])];
          if (label < 0 && beside >= 0 && isNear(triangle[c], beside)) {
            label = beside;
            has_changed = true;
          }
        }
    }
  }

  /** \brief Takes the triangles with a corner on no surface, with their vertices numbered
   * anew. */
  void
  takeTriangles()
  {
    std::vector<std::int32_t> numbers(points_.size(), -1);
    for (const Triangle& triangle : found_.mesh.triangles) {
      if (std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t corner) {
            return isOnSurface(corner);
          }))
        continue;
      for (const std::int32_t corner : triangle) {
        std::int32_t& number = numbers[static_cast<std::size_t>(corner)];
        if (number < 0) {
          number = static_cast<std::int32_t>(vertices_.size());
          vertices_.push_back(corner);
          places_.push_back(points_[static_cast<std::size_t>(corner)]);
        }
        corners_.push_back(static_cast<std::uint32_t>(number));
      }
    }
  }

  /** \brief The connected piece of each vertex. */
  acmap::DisjointSets<std::int32_t>
  pieces() const
  {
    acmap::DisjointSets<std::int32_t> sets(static_cast<std::int32_t>(places_.size()));
    for (std::size_t k = 0; k + 2 < corners_.size(); k += 3)
      for (const std::size_t other : {k + 1, k + 2})
        sets.unite(static_cast<std::int32_t>(corners_[k]),
                   static_cast<std::int32_t>(corners_[other]));
    return sets;
  }

  void
  dropSmallPieces()
  {
    constexpr float min_extent = 0.05F; // metres
    constexpr std::size_t min_triangles = 12;
    acmap::DisjointSets<std::int32_t> sets = pieces();
    std::vector<Eigen::AlignedBox3f> boxes(places_.size());
    std::vector<std::size_t> counts(places_.size());
    const auto pieceOf = [&](std::uint32_t vertex) {
      return static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(vertex)));
    };
    for (std::uint32_t i = 0; i < places_.size(); ++i)
      boxes[pieceOf(i)].extend(places_[i]);
    for (std::size_t k = 0; k < corners_.size(); k += 3)
      ++counts[pieceOf(corners_[k])];
    keepTriangles([&](std::size_t k) {
      const std::size_t piece = pieceOf(corners_[k]);
      return boxes[piece].diagonal().norm() >= min_extent &&
             counts[piece] >= min_triangles;
    });
  }

  /** \brief Keeps the triangles whose first corner's index fulfils a condition. */
  template <typename Condition>
  void
  keepTriangles(const Condition& condition)
  {
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k + 2 < corners_.size(); k += 3)
      if (condition(k))
        kept.insert(kept.end(),
                    corners_.begin() + static_cast<std::ptrdiff_t>(k),
                    corners_.begin() + static_cast<std::ptrdiff_t>(k + 3));
    corners_.swap(kept);
  }

  /** \param[in] count of the indices that are aimed at
   * \param[in] deviation that is allowed, metres */
  void
  simplify(std::size_t count, float deviation)
  {
    const float* const first = places_.front().data();
    constexpr std::size_t stride = sizeof(Eigen::Vector3f);
    const float scale = meshopt_simplifyScale(first, places_.size(), stride);
    std::vector<std::uint32_t> simpler(corners_.size());
    simpler.resize(meshopt_simplify(simpler.data(),
                                    corners_.data(),
                                    corners_.size(),
                                    first,
                                    places_.size(),
                                    stride,
                                    count,
                                    std::min(deviation / std::max(scale, 1e-6F), 1.0F),
                                    0,
                                    nullptr));
    corners_.swap(simpler);
  }

  /** \brief The pieces by decreasing number of triangles, as many as fit. */
  MapDetails
  details(std::size_t max_bytes)
  {
    acmap::DisjointSets<std::int32_t> sets = pieces();
    std::vector<std::vector<std::size_t>> triangles(places_.size()); // of each piece
    for (std::size_t k = 0; k < corners_.size(); k += 3)
      triangles[static_cast<std::size_t>(
                    sets.find(static_cast<std::int32_t>(corners_[k])))]
          .push_back(k);
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return triangles[a].size() > triangles[b].size();
    });
    MapDetails details;
    std::vector<std::int32_t> numbers(places_.size(), -1);
    for (const std::size_t piece : order) {
      const std::size_t vertices = details.vertices.size();
      const auto faces = details.mesh.triangles.size();
      for (const std::size_t k : triangles[piece])
        append(k, numbers, details);
      if (bytesOf(details.vertices.size(), details.mesh.triangles.size()) <= max_bytes)
        continue;
      details.vertices.resize(vertices);
      details.colors.resize(vertices);
      details.mesh.triangles.resize(faces);
      break;
    }
    return details;
  }

  void
  append(std::size_t k, std::vector<std::int32_t>& numbers, MapDetails& details) const
  {
    Triangle triangle{};
    for (std::size_t c = 0; c < triangle.size(); ++c) {
      const std::uint32_t vertex = corners_[k + c];
      if (numbers[vertex] < 0) {
        numbers[vertex] = static_cast<std::int32_t>(details.vertices.size());
        details.vertices.push_back(places_[vertex]);
        details.colors.push_back(colorOf(vertices_[vertex]));
      }
      triangle[c] = numbers[vertex];
    }
    details.mesh.triangles.push_back(triangle);
  }

  std::array<std::uint8_t, 3>
  colorOf(std::int32_t vertex) const
  {
    constexpr std::uint8_t grey = 160;
    if (!color_)
      return {grey, grey, grey};
    const std::uint8_t* const row =
        found_.vertices.data() +
        static_cast<std::size_t>(vertex) * found_.vertices.layout().point_step +
        color_->offset;
    return {row[2], row[1], row[0]};
  }

  const MappedPlanes& found_;
  acmap::PointView points_;
  const PCLPointField* color_;
  PointLabels labels_;                 ///< plane of each vertex
  std::vector<std::int32_t> vertices_; ///< of the mesh
  std::vector<Eigen::Vector3f> places_;
  std::vector<std::uint32_t> corners_; ///< three of each triangle
};

} // namespace

MapDetails
makeDetails(const MappedPlanes& found, std::size_t max_bytes)
{
  const std::size_t vertices = found.vertices ? found.vertices.size() : 0;
  if (max_bytes == 0 || found.mesh.triangles.empty() ||
      found.vertex_labels.size() != vertices)
    return {};
  return DetailMaker(found).make(max_bytes);
}

std::size_t
detailBytes(const MapDetails& details)
{
  return bytesOf(details.vertices.size(), details.mesh.triangles.size());
}

} // namespace pcl
