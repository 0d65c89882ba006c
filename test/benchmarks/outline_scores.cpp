#include "outline_scores.h"

#include "bench.h"
#include "simulated_clouds.h"

#include <pcl/core/impl/polyline_corners.h>
#include <pcl/pipeline/plane_mapping.h>

#include <array>
#include <cstring>
#include <map>

namespace pcl::acmap::bench {

namespace {

// Corners that are meant to be on a cell's border may be off it by rounding.
constexpr double rounding = 1e-6; // cells

int
firstCell(double metres)
{
  return static_cast<int>(std::floor(metres / raster_cell + rounding));
}

int
endCell(double metres)
{
  return static_cast<int>(std::ceil(metres / raster_cell - rounding));
}

} // namespace

PlaneFrame
makePlaneFrame(const Eigen::Vector4d& coefficients)
{
  const Eigen::Vector3d normal = coefficients.head<3>();
  PlaneFrame frame;
  frame.origin = -coefficients[3] * normal;
  const Eigen::Vector3d axis =
      Eigen::Vector3d::Unit(std::abs(normal.x()) < 0.8 ? 0 : 2);
  frame.u = (axis - axis.dot(normal) * normal).normalized();
  frame.v = normal.cross(frame.u);
  return frame;
}

CellSet::CellSet(const Eigen::AlignedBox2d& box)
{
  if (box.isEmpty())
    return;
  first_i_ = firstCell(box.min().x());
  end_i_ = std::max(first_i_, endCell(box.max().x()));
  first_j_ = firstCell(box.min().y());
  end_j_ = std::max(first_j_, endCell(box.max().y()));
  cells_.assign(static_cast<std::size_t>(end_i_ - first_i_) *
                    static_cast<std::size_t>(end_j_ - first_j_),
                0);
}

bool
CellSet::hasPlace(const Eigen::Vector2d& place) const
{
  return has(static_cast<int>(std::floor(place.x() / raster_cell)),
             static_cast<int>(std::floor(place.y() / raster_cell)));
}

void
CellSet::addInside(const std::vector<FlatLoop>& loops)
{
  std::vector<std::vector<double>> crossings(
      static_cast<std::size_t>(end_i_ - first_i_)); // of the line through centres of i
  for (const FlatLoop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Eigen::Vector2d a = loop[k] / raster_cell;
      Eigen::Vector2d b = loop[(k + 1) % loop.size()] / raster_cell;
      if (a.x() > b.x())
        std::swap(a, b);
      const int first = std::max(first_i_, static_cast<int>(std::ceil(a.x() - 0.5)));
      for (int i = first; i < end_i_ && i + 0.5 < b.x(); ++i)
        crossings[static_cast<std::size_t>(i - first_i_)].push_back(
            a.y() + (i + 0.5 - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    }
  for (int i = first_i_; i < end_i_; ++i) {
    std::vector<double>& of_line = crossings[static_cast<std::size_t>(i - first_i_)];
    std::sort(of_line.begin(), of_line.end());
    for (std::size_t k = 0; k + 1 < of_line.size(); k += 2) {
      const int first =
          std::max(first_j_, static_cast<int>(std::ceil(of_line[k] - 0.5)));
      for (int j = first; j < end_j_ && j + 0.5 < of_line[k + 1]; ++j)
        add(i, j);
    }
  }
}

bool
CellSet::hasNear(int i, int j, int reach) const
{
  for (int di = -reach; di <= reach; ++di)
    for (int dj = -reach; dj <= reach; ++dj)
      if (di * di + dj * dj <= reach * reach && has(i + di, j + dj))
        return true;
  return false;
}

bool
CellSet::hasAllNear(int i, int j, int reach) const
{
  for (int di = -reach; di <= reach; ++di)
    for (int dj = -reach; dj <= reach; ++dj)
      if (di * di + dj * dj <= reach * reach && !has(i + di, j + dj))
        return false;
  return true;
}

double
CellSet::area() const
{
  return raster_cell * raster_cell *
         static_cast<double>(std::count(cells_.begin(), cells_.end(), 1));
}

Eigen::AlignedBox2d
boxOf(const std::vector<FlatLoop>& loops)
{
  Eigen::AlignedBox2d box;
  for (const FlatLoop& loop : loops)
    for (const Eigen::Vector2d& place : loop)
      box.extend(place);
  return box;
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using PointBits = std::array<std::uint32_t, 3>;
using EdgeBits = std::array<PointBits, 2>;

PointBits
bitsOf(const Eigen::Vector3f& point)
{
  PointBits bits;
  std::memcpy(bits.data(), point.data(), sizeof bits);
  return bits;
}

EdgeBits
bitsOf(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  EdgeBits bits{bitsOf(a), bitsOf(b)};
  std::sort(bits.begin(), bits.end());
  return bits;
}

/** \brief All loops of a polygon, the outer one first. */
std::vector<std::vector<Eigen::Vector3f>>
loopsOf(const PlanePolygon& polygon)
{
  std::vector<std::vector<Eigen::Vector3f>> loops{polygon.outer};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  return loops;
}

template <typename Visitor>
void
forEachEdge(const PlanePatch& plane, const Visitor& visit)
{
  for (const PlanePolygon& polygon : plane.polygons)
    for (const std::vector<Eigen::Vector3f>& loop : loopsOf(polygon))
      for (std::size_t k = 0; k < loop.size(); ++k)
        visit(loop[k], loop[(k + 1) % loop.size()]);
}

double
signedArea(const FlatLoop& loop)
{
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d& a = loop[k];
    const Eigen::Vector2d& b = loop[(k + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/** \brief Signed distance of a point from the line through a segment. */
double
sideOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point)
{
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d off = point - a;
  return along.x() * off.y() - along.y() * off.x();
}

/** \brief Do segments cross in their interiors? Those that touch do not. */
bool
cross(const Eigen::Vector2d& a,
      const Eigen::Vector2d& b,
      const Eigen::Vector2d& c,
      const Eigen::Vector2d& d)
{
  constexpr double touch = 1e-5; // metres, more than coordinates are rounded by
  const auto areOpposite = [](double s, double t) {
    return (s > touch && t < -touch) || (s < -touch && t > touch);
  };
  return areOpposite(sideOf(a, b, c), sideOf(a, b, d)) &&
         areOpposite(sideOf(c, d, a), sideOf(c, d, b));
}

bool
crossesItself(const std::vector<FlatLoop>& polygon)
{
  std::vector<std::array<Eigen::Vector2d, 2>> edges;
  for (const FlatLoop& loop : polygon)
    for (std::size_t k = 0; k < loop.size(); ++k)
      edges.push_back({loop[k], loop[(k + 1) % loop.size()]});
  for (std::size_t a = 0; a < edges.size(); ++a)
    for (std::size_t b = a + 1; b < edges.size(); ++b)
      if (cross(edges[a][0], edges[a][1], edges[b][0], edges[b][1]))
        return true;
  return false;
}

} // namespace

double
OutlineEdge::distance(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d along = to - from;
  const double length = along.squaredNorm();
  const double part =
      length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - from - part * along).norm();
}

bool
PlaneOutline::contains(const Eigen::Vector3d& point) const
{
  const Eigen::Vector2d place = frame.flat(point);
  for (const std::vector<FlatLoop>& polygon : polygons) {
    bool is_inside = false;
    for (const FlatLoop& loop : polygon)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Eigen::Vector2d& a = loop[k];
        const Eigen::Vector2d& b = loop[(k + 1) % loop.size()];
        if ((a.x() > place.x()) != (b.x() > place.x()) &&
            a.y() + (place.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) > place.y())
          is_inside = !is_inside;
      }
    if (is_inside)
      return true;
  }
  return false;
}

double
PlaneOutline::distanceWithin(const Eigen::Vector3d& point) const
{
  if (contains(point))
    return 0;
  const Eigen::Vector2d place = frame.flat(point);
  double minimum = infinite;
  for (const std::vector<FlatLoop>& polygon : polygons)
    for (const FlatLoop& loop : polygon)
      for (std::size_t k = 0; k < loop.size(); ++k)
        minimum = std::min(
            minimum,
            std::sqrt(squaredDistance(place, loop[k], loop[(k + 1) % loop.size()])));
  return minimum;
}

double
PlaneOutline::distanceToEdges(const Eigen::Vector3d& point) const
{
  double minimum = infinite;
  for (const OutlineEdge& edge : edges)
    minimum = std::min(minimum, edge.distance(point));
  return minimum;
}

double
PlaneOutline::distanceToSurface(const Eigen::Vector3d& point) const
{
  if (contains(point))
    return std::abs(coefficients.head<3>().dot(point) + coefficients[3]);
  return distanceToEdges(point);
}

std::vector<PlaneOutline>
makeOutlines(const std::vector<PlanePatch>& planes, const Eigen::Isometry3d& T_out_map)
{
  std::map<EdgeBits, std::vector<std::size_t>> users;
  for (std::size_t p = 0; p < planes.size(); ++p)
    forEachEdge(planes[p], [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      std::vector<std::size_t>& of_edge = users[bitsOf(a, b)];
      if (of_edge.empty() || of_edge.back() != p)
        of_edge.push_back(p);
    });
  std::vector<PlaneOutline> outlines(planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlaneOutline& outline = outlines[p];
    const Eigen::Vector3d normal =
        T_out_map.linear() * planes[p].coefficients.head<3>();
    outline.coefficients << normal,
        planes[p].coefficients[3] - normal.dot(T_out_map.translation());
    outline.frame = makePlaneFrame(outline.coefficients);
    forEachEdge(planes[p], [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      OutlineEdge& edge = outline.edges.emplace_back();
      edge.from = T_out_map * a.cast<double>();
      edge.to = T_out_map * b.cast<double>();
      outline.box.extend(edge.from);
      for (const std::size_t user : users[bitsOf(a, b)])
        if (user != p)
          edge.partners.push_back(user);
    });
    for (const PlanePolygon& polygon : planes[p].polygons) {
      std::vector<FlatLoop>& loops = outline.polygons.emplace_back();
      for (const std::vector<Eigen::Vector3f>& loop : loopsOf(polygon)) {
        FlatLoop& flat = loops.emplace_back();
        for (const Eigen::Vector3f& place : loop)
          flat.push_back(outline.frame.flat(T_out_map * place.cast<double>()));
      }
    }
  }
  return outlines;
}

OutlineCounts
countOutlines(const std::vector<PlaneOutline>& outlines)
{
  constexpr double sliver = 0.01; // square metres
  OutlineCounts counts;
  counts.planes = outlines.size();
  std::vector<double> vertices;
  for (const PlaneOutline& outline : outlines) {
    vertices.push_back(static_cast<double>(outline.edges.size()));
    counts.vertices_mean += vertices.back() / static_cast<double>(outlines.size());
    for (const std::vector<FlatLoop>& polygon : outline.polygons) {
      ++counts.polygons;
      counts.holes += polygon.size() - 1;
      counts.crossed += crossesItself(polygon);
      counts.area += std::abs(signedArea(polygon.front()));
      for (std::size_t hole = 1; hole < polygon.size(); ++hole) {
        const double area = std::abs(signedArea(polygon[hole]));
        counts.area -= area;
        counts.slivers += area < sliver;
      }
    }
  }
  counts.vertices_median = median(vertices);
  return counts;
}

namespace {

constexpr double cell_area = raster_cell * raster_cell;
constexpr int deep = 5; // cells

/** \brief Polygons of an outline, projected onto a face. */
std::vector<std::vector<FlatLoop>>
projected(const PlaneOutline& outline, const VisibleFace& face)
{
  std::vector<std::vector<FlatLoop>> polygons = outline.polygons;
  for (std::vector<FlatLoop>& polygon : polygons)
    for (FlatLoop& loop : polygon)
      for (Eigen::Vector2d& place : loop)
        place = face.frame.flat(outline.frame.lifted(place));
  return polygons;
}

CellSet
rasterOf(const std::vector<std::vector<FlatLoop>>& polygons)
{
  Eigen::AlignedBox2d box;
  for (const std::vector<FlatLoop>& polygon : polygons)
    box.extend(boxOf(polygon));
  CellSet cells(box);
  for (const std::vector<FlatLoop>& polygon : polygons)
    cells.addInside(polygon);
  return cells;
}

bool
isNear(const PlaneOutline& outline, const VisibleFace& face)
{
  constexpr double max_angle = 5 * degree;
  constexpr double max_offset = 0.03; // metres, mean of the corners
  if (outline.coefficients.head<3>().dot(face.coefficients.head<3>()) <
      std::cos(max_angle))
    return false;
  double sum = 0;
  for (const OutlineEdge& edge : outline.edges)
    sum += std::abs(face.coefficients.head<3>().dot(edge.from) + face.coefficients[3]);
  return sum <= max_offset * static_cast<double>(outline.edges.size());
}

std::int32_t
findFace(const PlaneOutline& outline, const VisibleTruth& truth)
{
  std::int32_t best = -1;
  double maximum = 0;
  for (std::size_t f = 0; f < truth.faces.size(); ++f) {
    const VisibleFace& face = truth.faces[f];
    if (outline.edges.empty() || !isNear(outline, face))
      continue;
    const CellSet cells = rasterOf(projected(outline, face));
    double on_face = 0;
    cells.forEach([&](int i, int j) { on_face += cell_area * face.all.has(i, j); });
    if (on_face > maximum && 2 * on_face >= cells.area()) {
      maximum = on_face;
      best = static_cast<std::int32_t>(f);
    }
  }
  return best;
}

void
scoreArea(const VisibleFace& face, const CellSet& inside, OutlineScores& scores)
{
  face.seen.forEach([&](int i, int j) {
    scores.seen += cell_area;
    scores.joined += cell_area;
    if (inside.has(i, j)) {
      scores.common += cell_area;
      return;
    }
    scores.missing += cell_area;
    if (face.seen.hasAllNear(i, j, deep))
      scores.missing_inside += cell_area;
  });
  inside.forEach([&](int i, int j) {
    if (face.seen.has(i, j))
      return;
    scores.joined += cell_area;
    if (face.all.has(i, j)) {
      scores.unseen += cell_area;
      return;
    }
    scores.nothing += cell_area;
    if (!face.all.hasNear(i, j, deep))
      scores.nothing_inside += cell_area;
  });
}

/** \brief Edges that planes of one face share with planes of another. */
std::vector<OutlineEdge>
sharedEdges(const std::vector<PlaneOutline>& outlines,
            const std::vector<std::int32_t>& face_of_plane,
            std::size_t face_a,
            std::size_t face_b)
{
  std::vector<OutlineEdge> shared;
  for (std::size_t p = 0; p < outlines.size(); ++p)
    if (face_of_plane[p] == static_cast<std::int32_t>(face_a))
      for (const OutlineEdge& edge : outlines[p].edges)
        if (std::any_of(
                edge.partners.begin(), edge.partners.end(), [&](std::size_t other) {
                  return face_of_plane[other] == static_cast<std::int32_t>(face_b);
                }))
          shared.push_back(edge);
  return shared;
}

void
scoreCreases(const std::vector<PlaneOutline>& outlines,
             const VisibleTruth& truth,
             OutlineScores& scores)
{
  constexpr double near = 0.01, far = 0.5; // metres
  std::vector<std::vector<const PlaneOutline*>> planes(truth.faces.size());
  for (std::size_t p = 0; p < outlines.size(); ++p)
    if (scores.face_of_plane[p] >= 0)
      planes[static_cast<std::size_t>(scores.face_of_plane[p])].push_back(&outlines[p]);
  std::array<std::size_t, 2> faces{};
  std::vector<OutlineEdge> shared; // of these faces
  const auto distanceTo = [&](std::size_t face, const Eigen::Vector3d& place) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const PlaneOutline* plane : planes[face])
      minimum = std::min(minimum, plane->distanceWithin(place));
    return minimum;
  };
  for (const CreaseSample& sample : truth.creases) {
    scores.creases += raster_cell;
    const double distance = std::max(distanceTo(sample.faces[0], sample.place),
                                     distanceTo(sample.faces[1], sample.place));
    if (distance > far)
      continue;
    scores.found += raster_cell;
    scores.gaps += distance > near ? raster_cell : 0;
    if (faces != sample.faces) {
      faces = sample.faces;
      shared = sharedEdges(outlines, scores.face_of_plane, faces[0], faces[1]);
    }
    if (std::any_of(shared.begin(), shared.end(), [&](const OutlineEdge& edge) {
          return edge.distance(sample.place) <= near;
        }))
      scores.shared += raster_cell;
  }
}

double
distanceToVertices(const std::vector<PlaneOutline>& outlines,
                   const Eigen::Vector3d& corner)
{
  double minimum = 0.5; // metres
  for (const PlaneOutline& outline : outlines)
    for (const OutlineEdge& edge : outline.edges)
      minimum = std::min(minimum, (edge.from - corner).norm());
  return minimum;
}

} // namespace

OutlineScores
scoreOutlines(const std::vector<PlaneOutline>& outlines, const VisibleTruth& truth)
{
  OutlineScores scores;
  for (const PlaneOutline& outline : outlines) {
    scores.face_of_plane.push_back(findFace(outline, truth));
    if (scores.face_of_plane.back() < 0)
      scores.unmatched_area += countOutlines({outline}).area;
  }
  for (std::size_t f = 0; f < truth.faces.size(); ++f) {
    std::vector<std::vector<FlatLoop>> polygons;
    for (std::size_t p = 0; p < outlines.size(); ++p)
      if (scores.face_of_plane[p] == static_cast<std::int32_t>(f))
        for (std::vector<FlatLoop>& polygon : projected(outlines[p], truth.faces[f]))
          polygons.push_back(std::move(polygon));
    if (!polygons.empty())
      scoreArea(truth.faces[f], rasterOf(polygons), scores);
  }
  scoreCreases(outlines, truth, scores);
  for (const Eigen::Vector3d& corner : truth.corners)
    scores.corners.push_back(distanceToVertices(outlines, corner));
  return scores;
}

JudgedMap
findJudgedMap(const std::shared_ptr<const PointCloudFile>& cloud,
              const std::vector<Eigen::Vector3f>& viewpoints)
{
  PlaneMapping mapping;
  mapping.setInputCloud(cloud);
  mapping.setViewpoints(viewpoints);
  double begin = 0, seconds = 0; // wall time would tell of the machine's other load
  bool is_outlining = false;
  mapping.setProgressCallback([&](double, const std::string& step) {
    if (is_outlining)
      seconds += processSeconds() - begin;
    is_outlining = step == "outlines";
    begin = processSeconds();
    return true;
  });
  MappedPlanes found;
  mapping.compute(found);
  return {std::move(found.planes), seconds};
}

JudgedMap
findJudgedMap(const SimulatedScene& scene)
{
  const SimulatedCloud all = makeSceneCloud(scene);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(all.merged);
  return findJudgedMap(file, all.sensorOrigins());
}

} // namespace pcl::acmap::bench
