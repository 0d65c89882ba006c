#include "bench.h"
#include "mesh_checker.h"
#include "mesh_peers.h"
#include "meshes.h"
#include "scene_truth.h"

namespace pcl::acmap::bench {
namespace {

void
printErrors(const std::string& cloud,
            const std::string& name,
            const NormalErrors& errors,
            double median_reach = no_reach,
            double p95_reach = no_reach)
{
  Row row;
  row << cloud << name;
  addErrors(errors, row, median_reach, p95_reach);
}

/** \return the edge length of a voxel */
double
printOurErrors(const SimulatedCloud& cloud, const SceneTruth& truth)
{
  const VotedMesh voted = meshAndVote(cloud);
  const double voxel = voted.report.voxel_size;
  const test::Points places = placesInScene(cloud, voted.consolidation);
  const auto errorsOf = [&](const test::Points& normals) {
    return measureNormals(truth, places, normals, voxel);
  };
  printErrors(cloud.name,
              "NormalVectorVoting",
              errorsOf(votedNormalsInScene(cloud, voted)),
              0.5,
              5);
  printErrors(cloud.name,
              "VoxelConsolidation",
              errorsOf(normalsInScene(cloud, voted.consolidation)));
  return voxel;
}

const Section normals_section("normals", [] {
  printHead("cloud | normals | away from creases, median ° | p95 ° | backs % | all, "
            "median ° | p95 ° | backs %");
  const SceneTruth truth(corridor().scene());
  const SimulatedCloud view = makeViewCloud(corridor().scene(), 0);
  const double voxel = printOurErrors(view, truth);
  for (const PeerNormals& peer : peerNormals(view))
    printErrors(
        view.name, peer.name, measureNormals(truth, peer.places, peer.normals, voxel));
  printOurErrors(makeRandomPart(corridor().whole(), 1000000, 1), truth);
  printOurErrors(corridor().whole(), truth);
});

/** \param[in] peer CPU seconds per point of the compared method, or \ref no_reach */
void
printTime(const SimulatedCloud& cloud,
          const std::string& name,
          std::size_t vertices,
          double seconds,
          double peer = no_reach)
{
  constexpr double min_ratio = 20;
  const double each = seconds / static_cast<double>(cloud.size());
  Row row;
  row << cloud.name << cloud.size() << name << figure(1e6 * each, 4)
      << figure(1e6 * seconds / static_cast<double>(vertices), 2);
  if (std::isnan(peer))
    row << "";
  else
    row << atLeast(peer / each, min_ratio, 1);
}

/** Median times of each step over several rounds. */
void
printTimes(const SimulatedCloud& cloud, std::size_t rounds, double peer)
{
  std::vector<double> consolidation, mesh, votes, curvatures;
  std::size_t vertices = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    const VotedMesh voted = meshAndVote(cloud);
    consolidation.push_back(voted.seconds.consolidation);
    mesh.push_back(voted.seconds.mesh);
    votes.push_back(voted.seconds.votes);
    VotingSettings settings;
    settings.compute_curvatures = true;
    curvatures.push_back(measureThread([&] { voteAgain(voted, settings); }));
    vertices = voted.votes.normals.size();
  }
  printTime(cloud, "consolidation", vertices, median(consolidation));
  printTime(cloud, "mesh", vertices, median(mesh));
  printTime(cloud, "votes", vertices, median(votes));
  printTime(cloud, "votes and curvatures", vertices, median(curvatures));
  printTime(cloud,
            "consolidation, mesh and votes",
            vertices,
            median(consolidation) + median(mesh) + median(votes),
            peer);
}

const Section time_section("time", [] {
  constexpr std::size_t rounds = 5, few_rounds = 3;
  printHead("cloud | points | what | CPU us a point | CPU us a vertex | times as fast "
            "as radius 10 cm on view 0");
  const SimulatedCloud view = makeViewCloud(corridor().scene(), 0);
  const std::vector<PeerNormals> peers = peerNormals(view);
  for (const PeerNormals& peer : peers)
    printTime(view, peer.name, view.size(), peer.seconds);
  const double each = peers.back().seconds / static_cast<double>(view.size());
  printTimes(view, rounds, each);
  printTimes(makeRandomPart(corridor().whole(), 1000000, 1), rounds, each);
  printTimes(corridor().whole(), few_rounds, each);
});

/** \brief A short piece of an edge where two rectangles of a scene meet at an angle. */
struct EdgePiece {
  Eigen::Vector3d place; ///< its centre, scene frame
  double length = 0;     ///< metres, about a centimetre
  std::size_t first = 0; ///< index in the truth's surfaces
  std::size_t second = 0;
};

constexpr double touching = 1e-6; // metres

bool
meetAtAnAngle(const TruthSurface& a, const TruthSurface& b)
{
  constexpr double parallel_cosine = 0.9;
  return a.plane != b.plane && std::abs(a.normal.dot(b.normal)) < parallel_cosine;
}

bool
isOnBorder(const TruthSurface& surface, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d place = surface.coordinates(point);
  return std::min({std::abs(place[0]),
                   std::abs(place[1]),
                   std::abs(place[0] - surface.size[0]),
                   std::abs(place[1] - surface.size[1])}) < touching;
}

/** The four edges of a rectangle, split into pieces. */
std::vector<EdgePiece>
borderOf(const SimulatedRectangle& rectangle)
{
  constexpr double step = 0.01;
  const Eigen::Vector3d &u = rectangle.edge_u, &v = rectangle.edge_v;
  const Eigen::Vector3d &corner = rectangle.corner, beyond_u = corner + u,
                        beyond_v = corner + v;
  std::vector<EdgePiece> pieces;
  for (const auto& [begin, edge] : {std::pair(corner, u),
                                    std::pair(corner, v),
                                    std::pair(beyond_v, u),
                                    std::pair(beyond_u, v)}) {
    const int count = std::max(1, static_cast<int>(edge.norm() / step));
    for (int k = 0; k < count; ++k)
      pieces.push_back({begin + (k + 0.5) / count * edge, edge.norm() / count, 0, 0});
  }
  return pieces;
}

double
areaSeen(const TruthSurface& surface, const Eigen::Vector3d& middle, double reach)
{
  std::size_t cells = 0;
  surface.visitCells(surface.coordinates(middle), reach, [&](int i, int j) {
    cells += surface.visible[surface.cellIndex(i, j)];
  });
  return static_cast<double>(cells) * surface.cellArea();
}

/** \brief All edges of rectangles that touch another rectangle; each one is included
 * once. */
std::vector<EdgePiece>
edgePieces(const SceneTruth& truth)
{
  const std::vector<TruthSurface>& surfaces = truth.surfaces();
  std::vector<EdgePiece> pieces;
  for (std::size_t a = 0; a < surfaces.size(); ++a)
    for (EdgePiece& piece : borderOf(surfaces[a].rectangle))
      for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const TruthSurface& other = surfaces[b];
        // if two borders coincide, only the first one counts
        if (!meetAtAnAngle(surfaces[a], other) ||
            other.distance(piece.place) > touching ||
            (b < a && isOnBorder(other, piece.place)))
          continue;
        piece.first = a;
        piece.second = b;
        pieces.push_back(piece);
      }
  return pieces;
}

/** \brief Was enough of both sides observed for a mesh to show the edge? The minimum is
 * a quarter of a voxel's face, within a voxel of the piece.
 * \param[in] voxel metres */
bool
isSeen(const SceneTruth& truth, const EdgePiece& piece, double voxel)
{
  constexpr double min_part = 0.25;
  return std::min(areaSeen(truth.surfaces()[piece.first], piece.place, voxel),
                  areaSeen(truth.surfaces()[piece.second], piece.place, voxel)) >
         min_part * voxel * voxel;
}

using test::Points;
using test::ReferenceTree;

Points
placesOf(const std::vector<EdgePiece>& pieces)
{
  Points places;
  for (const EdgePiece& piece : pieces)
    places.push_back(piece.place);
  return places;
}

double
countNear(const Points& points, const ReferenceTree& others, double reach)
{
  return static_cast<double>(
      std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& point) {
        return others.findWithin(point, reach) >= 0;
      }));
}

/** \param[in] is_crease is a vertex a crease or a corner?
 * \param[in] target of precision and recall */
void
printScores(const SceneTruth& truth,
            const Points& vertices,
            const std::vector<bool>& is_crease,
            const ConsolidationReport& report,
            double target,
            Row& row)
{
  const double voxel = report.voxel_size, reach = voxel + 2 * report.sigma;
  const std::vector<EdgePiece> pieces = edgePieces(truth);
  std::vector<EdgePiece> seen;
  for (const EdgePiece& piece : pieces)
    if (isSeen(truth, piece, voxel))
      seen.push_back(piece);
  Points creases;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (is_crease[v])
      creases.push_back(vertices[v]);
  const ReferenceTree crease_tree(creases), edge_tree(placesOf(pieces)),
      seen_tree(placesOf(seen));
  double length = 0, reached = 0;
  for (const EdgePiece& piece : seen) {
    length += piece.length;
    if (crease_tree.findWithin(piece.place, reach) >= 0)
      reached += piece.length;
  }
  const double right = countNear(creases, edge_tree, reach);
  const double near_edges = countNear(vertices, seen_tree, voxel / 2);
  row << creases.size()
      << atLeast(right / static_cast<double>(creases.size()), target, 3)
      << figure(length, 1) << atLeast(reached / length, target, 3)
      << figure(near_edges, 0)
      << figure(countNear(creases, seen_tree, voxel / 2) / near_edges, 3);
}

void
printCreases(const SimulatedCloud& cloud, const SceneTruth& truth)
{
  const VotedMesh voted = meshAndVote(cloud);
  VotingSettings settings;
  const auto print = [&](const std::string& name, double target) {
    Row row;
    row << cloud.name << name << figure(centi * voted.report.voxel_size, 1)
        << voted.votes.normals.size();
    printScores(truth,
                placesInScene(cloud, voted.consolidation),
                creasesOf(voteAgain(voted, settings)),
                voted.report,
                target,
                row);
  };
  print("12 (default)", 0.9);
  settings.crease_weight = 2; // Page's
  print("2", no_reach);
}

const Section creases_section("creases", [] {
  printHead("cloud | crease weight | voxel, cm | vertices | creases and corners | "
            "precision | true edges seen, m | recall | vertices within half a voxel of "
            "them | recall of these");
  printCreases(makeViewCloud(corridor().scene(), 0), corridor().truthOfView(0));
  printCreases(makeRandomPart(corridor().whole(), 1000000, 1), corridor().wholeTruth());
  printCreases(corridor().whole(), corridor().wholeTruth());
});

} // namespace
} // namespace pcl::acmap::bench
