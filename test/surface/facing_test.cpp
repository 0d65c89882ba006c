#include "dewall_runs.h"

#include <pcl/core/random.h>
#include <pcl/surface/dewall_triangulation.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using NormalCloud = PointCloud<PointNormal>;

NormalCloud
withNormals(const Cloud& cloud, const std::vector<Eigen::Vector3d>& normals)
{
  NormalCloud result;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    PointNormal point;
    point.getVector3fMap() = cloud[i].getVector3fMap();
    point.getNormalVector3fMap() = normals[i].cast<float>();
    result.push_back(point);
  }
  result.sensor_origin_ = cloud.sensor_origin_;
  return result;
}

template <typename PointT>
Triangles
meshOf(const PointCloud<PointT>& cloud, const DeWallRun& run)
{
  DeWallTriangulation<PointT> dewall;
  dewall.setAcceptanceRule(run.rule);
  dewall.setMaximumEdgeLength(run.length);
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  return mesh.triangles;
}

/** Fraction of the triangles whose front is on the side of their normals. */
double
shareAsNormals(const NormalCloud& cloud, const Triangles& mesh)
{
  std::size_t as_normals = 0;
  for (const Triangle& t : mesh) {
    std::array<Eigen::Vector3f, 3> p;
    Eigen::Vector3f side = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const PointNormal& corner = cloud[static_cast<std::size_t>(t[k])];
      p[k] = corner.getVector3fMap();
      if (corner.getNormalVector3fMap().allFinite())
        side += corner.getNormalVector3fMap();
    }
    as_normals += (p[1] - p[0]).cross(p[2] - p[0]).dot(side) > 0;
  }
  return static_cast<double>(as_normals) / static_cast<double>(mesh.size());
}

/** A sheet folded by 60 degrees, with noise of a fifth of the spacing. */
struct FoldedSheet {
  SheetCloud sheet = makeFoldedPlane({50, 50, 0.02, 0.25, 0.2, 7}, M_PI / 3);
  std::vector<Eigen::Vector3d> normals;

  FoldedSheet()
  {
    for (const PointXYZ& point : sheet.cloud)
      normals.push_back(point.x > 0 ? Eigen::Vector3d(-std::sin(M_PI / 3), 0, 0.5)
                                    : Eigen::Vector3d(0, 0, 1));
  }
};

class FacingByNormals : public testing::TestWithParam<DeWallRule> {};

TEST_P(FacingByNormals, orientsAFoldedSheet)
{
  const DeWallRun run{GetParam(), 0.06};
  FoldedSheet folded;
  for (const double side : {1.0, -1.0}) {
    std::vector<Eigen::Vector3d> normals = folded.normals;
    for (Eigen::Vector3d& normal : normals)
      normal *= side;
    // the sensor is on the opposite side, but the normals take precedence
    folded.sheet.cloud.sensor_origin_ =
        Eigen::Vector4f(0, 0, static_cast<float>(-5 * side), 1);
    const NormalCloud cloud = withNormals(folded.sheet.cloud, normals);
    const Triangles mesh = meshOf(cloud, run);
    EXPECT_GT(mesh.size(), 3000U);
    EXPECT_GT(shareAsNormals(cloud, mesh), 0.99) << "side " << side;
  }
}

TEST_P(FacingByNormals, ignoresNormalsThatSayNothing)
{
  const DeWallRun run{GetParam(), 0.06};
  const FoldedSheet folded;
  const Triangles without = meshOf(folded.sheet.cloud, run);
  Random random(9);
  std::vector<Eigen::Vector3d> random_signs, null, invalid, long_ones;
  for (const Eigen::Vector3d& normal : folded.normals) {
    random_signs.push_back(random.uniform() < 0.5 ? normal : Eigen::Vector3d(-normal));
    null.emplace_back(0, 0, 0);
    invalid.emplace_back(NAN, NAN, NAN);
    long_ones.push_back(-5 * normal);
  }
  for (const auto& normals : {random_signs, null, invalid, long_ones})
    EXPECT_EQ(meshOf(withNormals(folded.sheet.cloud, normals), run), without);
}

TEST_P(FacingByNormals, toleratesThatAFewAreMissing)
{
  const DeWallRun run{GetParam(), 0.06};
  FoldedSheet folded;
  folded.sheet.cloud.sensor_origin_ = Eigen::Vector4f(0, 0, -5, 1);
  for (std::size_t i = 0; i < folded.normals.size(); i += 5)
    folded.normals[i] = Eigen::Vector3d(NAN, NAN, NAN);
  const NormalCloud cloud = withNormals(folded.sheet.cloud, folded.normals);
  EXPECT_GT(shareAsNormals(cloud, meshOf(cloud, run)), 0.99);
}

/** Two faces, 12 cm apart, with a spacing of 10 cm and open borders; each point has the
 * normal of its face. */
NormalCloud
makeBoard(double jitter, double noise)
{
  NormalCloud board;
  const SheetSampling sampling{40, 40, 0.1, jitter, noise, 11};
  for (const double side : {1.0, -1.0}) {
    SheetSampling face = sampling;
    face.seed += side > 0;
    for (const PointXYZ& place : makeJitteredPlane(face).cloud) {
      PointNormal point;
      point.getVector3fMap() = place.getVector3fMap() +
                               Eigen::Vector3f(0, 0, static_cast<float>(0.06 * side));
      point.getNormalVector3fMap() = Eigen::Vector3f(0, 0, static_cast<float>(side));
      board.push_back(point);
    }
  }
  return board;
}

/** Classification of the triangles of a board. */
struct BoardFaces {
  std::size_t wrong = 0; ///< on one face, but with the wrong orientation
  std::size_t deep = 0;  ///< connect both faces, away from the border
};

BoardFaces
facesOf(const NormalCloud& board, const Triangles& mesh)
{
  BoardFaces faces;
  for (const Triangle& t : mesh) {
    std::array<PointNormal, 3> p;
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = board[static_cast<std::size_t>(t[k])];
      is_inside &= std::max(std::abs(p[k].x), std::abs(p[k].y)) < 1.8F;
    }
    if (p[0].normal_z != p[1].normal_z || p[0].normal_z != p[2].normal_z) {
      faces.deep += is_inside;
      continue;
    }
    const Eigen::Vector3f a = p[0].getVector3fMap();
    const Eigen::Vector3f normal =
        (p[1].getVector3fMap() - a).cross(p[2].getVector3fMap() - a);
    faces.wrong += normal.z() * p[0].normal_z < 0;
  }
  return faces;
}

TEST_P(FacingByNormals, keepsTheFacesOfABoardApart)
{
  for (const double jitter : {0.0, 0.2}) {
    const NormalCloud board = makeBoard(jitter, jitter / 10);
    for (const double length : {0.16, 0.2, 0.0}) {
      const Triangles mesh = meshOf(board, {GetParam(), length});
      const auto what = testing::Message()
                        << "jitter " << jitter << ", edges to " << length;
      EXPECT_GT(mesh.size(), 5900U) << what;
      const BoardFaces faces = facesOf(board, mesh);
      EXPECT_EQ(faces.wrong, 0U) << what;
      EXPECT_LE(faces.deep, jitter > 0 ? 12U : 0U) << what;
      // triangles that close the border are perpendicular to both normals
      EXPECT_GT(shareAsNormals(board, mesh), jitter > 0 ? 0.975 : 0.9999) << what;
    }
  }
}

TEST_P(FacingByNormals, isTheSameForEveryNumberOfThreads)
{
  const NormalCloud board = makeBoard(0.2, 0.02);
  DeWallTriangulation<PointNormal> dewall;
  dewall.setAcceptanceRule(GetParam());
  dewall.setMaximumEdgeLength(0.2);
  dewall.setInputCloud(board.makeShared());
  const Triangles wanted = meshOf(board, {GetParam(), 0.2});
  for (const unsigned threads : {1U, 2U, 8U}) {
    dewall.setNumberOfThreads(threads);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    EXPECT_EQ(mesh.triangles, wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules,
                         FacingByNormals,
                         testing::Values(DeWallRule::Guarded, DeWallRule::Dense));

} // namespace
} // namespace pcl::acmap::test
