#include "bad_clouds.h"
#include "face.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/segmentation/box_fitting.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/depth_plane_segmentation.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/segmentation/recess_fitting.h>
#include <pcl/surface/dewall_triangulation.h>

namespace pcl::acmap::test {

namespace {

template <typename Class, typename PointT>
Face<Class>
cloudFace(
    const std::string& name,
    const typename Face<Class>::Run& run,
    const typename Face<Class>::Change& good = [](Class&) {})
{
  const auto set = [](Class& object, const Cloud::Ptr& cloud) {
    object.setInputCloud(as<PointT>(cloud));
  };
  Face<Class> face(
      name,
      [=](Class& object) {
        set(object, goodView().makeShared());
        good(object);
        object.setNumberOfThreads(1);
      },
      run);
  face.give("cloud", badClouds(), set)
      .give(
          "indices",
          badIndices(goodView().size()),
          [](Class& object, const IndicesPtr& indices) { object.setIndices(indices); })
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); });
  return face;
}

template <typename Class>
void
setMesh(Class& object, const TriangleMesh& mesh)
{
  object.setTriangles(mesh);
}

/** A mesh of the good view. */
TriangleMesh
goodMesh()
{
  TriangleMesh mesh;
  for (int row = 0; row + 1 < 48; ++row)
    for (int column = 0; column + 1 < 64; ++column) {
      const int i = 64 * row + column;
      mesh.triangles.push_back({i, i + 64, i + 1});
      mesh.triangles.push_back({i + 1, i + 64, i + 65});
    }
  return mesh;
}

void
addVoting(std::vector<BadCase>& cases)
{
  using Class = NormalVectorVoting<PointXYZ>;
  auto face = cloudFace<Class, PointXYZ>(
      "NormalVectorVoting",
      [](Class& object) {
        PointCloud<Normal> normals;
        object.compute(normals);
        return given(normals.empty(), object.getReport());
      },
      [](Class& object) { object.setTriangles(goodMesh()); });
  face.give("mesh", badMeshes(goodView().size()), setMesh<Class>)
      .give("viewpoints",
            badViewpoints(),
            [](Class& object, const auto& places) { object.setViewpoints(places); })
      .number("radius", &VotingParameters::setRadiusSearch)
      .number("crease weight", &VotingParameters::setCreaseWeight)
      .number("corner weight", &VotingParameters::setCornerWeight)
      .addTo(cases);
}

void
addTriangulation(std::vector<BadCase>& cases)
{
  using Class = DeWallTriangulation<PointXYZ>;
  cloudFace<Class, PointXYZ>("DeWallTriangulation",
                             [](Class& object) {
                               TriangleMesh mesh;
                               object.reconstruct(mesh);
                               return given(mesh.triangles.empty(), object.getReport());
                             })
      .number("edge length", &DeWallParameters::setMaximumEdgeLength)
      .number("leaf size", &DeWallParameters::setLeafSize)
      .number("memory limit", &DeWallParameters::setMemoryLimit)
      .addTo(cases);
}

void
addConsolidation(std::vector<BadCase>& cases)
{
  using Class = VoxelConsolidation<PointNormal>;
  auto face = cloudFace<Class, PointNormal>("VoxelConsolidation", [](Class& object) {
    PointCloud<PointNormal> output;
    object.filter(output);
    return given(output.empty(), object.getReport());
  });
  face.give("viewpoints",
            badViewpoints(),
            [](Class& object, const auto& places) { object.setViewpoints(places); })
      .number("voxel size", &ConsolidationParameters::setVoxelSize)
      .addTo(cases);
}

template <typename Class>
void
setNormals(Class& object, const PointCloud<Normal>::Ptr& normals)
{
  object.setInputNormals(normals);
}

void
addPlanes(std::vector<BadCase>& cases)
{
  using Class = PlaneHypothesisClustering<PointNormal>;
  auto face =
      cloudFace<Class, PointNormal>("PlaneHypothesisClustering", planesOf<Class>);
  face.give("normals", badNormals(goodView().size()), setNormals<Class>)
      .give("mesh", badMeshes(goodView().size()), setMesh<Class>)
      .give(
          "source",
          orNone(badClouds()),
          [](Class& object, const Cloud::Ptr& cloud) { object.setSourceCloud(cloud); })
      .number("tolerance", &PlaneClusteringParameters::setClusterTolerance)
      .number("angle", &PlaneClusteringParameters::setSmoothnessThreshold)
      .number("distance", &PlaneClusteringParameters::setDistanceThreshold)
      .number("size", &PlaneClusteringParameters::setMinClusterSize)
      .number("area", &PlaneClusteringParameters::setMinArea)
      .addTo(cases);
}

void
addCylinders(std::vector<BadCase>& cases)
{
  using Class = CylinderHypothesisClustering<PointNormal>;
  auto face =
      cloudFace<Class, PointNormal>("CylinderHypothesisClustering", [](Class& object) {
        std::vector<CylinderPatch> cylinders;
        object.segment(cylinders);
        return given(cylinders.empty(), object.getReport());
      });
  const std::size_t points = goodView().size();
  face.give("normals", badNormals(points), setNormals<Class>)
      .give("mesh", badMeshes(points), setMesh<Class>)
      .give("planes",
            badPlanes(),
            [=](Class& object, const std::vector<PlanePatch>& planes) {
              object.setPlanes(planes, PointLabels(points, planes.empty() ? -1 : 1));
            })
      .number("noise", &CylinderClusteringParameters::setNoise)
      .addTo(cases);
}

void
addDepth(std::vector<BadCase>& cases)
{
  using Segmentation = DepthPlaneSegmentation<PointXYZ>;
  cloudFace<Segmentation, PointXYZ>("DepthPlaneSegmentation", planesOf<Segmentation>)
      .number("area", &Segmentation::setMinArea)
      .addTo(cases);
  using Refinement = DepthRefinement<PointXYZ>;
  const std::size_t points = goodView().size();
  cloudFace<Refinement, PointXYZ>("DepthRefinement",
                                  [](Refinement& object) {
                                    PointCloud<PointXYZ> output;
                                    object.filter(output);
                                    return given(output.empty(), object.getReport());
                                  })
      .give("planes",
            badPlanes(),
            [=](Refinement& object, const std::vector<PlanePatch>& planes) {
              object.setPlanes(planes, PointLabels(points, planes.empty() ? -1 : 1));
            })
      .addTo(cases);
}

/** The second of two observations, which a filter turns into one cloud. */
template <typename Class, typename PointT>
void
addFilter(std::vector<BadCase>& cases, const std::string& name)
{
  cloudFace<Class, PointT>(
      name,
      [](Class& object) {
        PointCloud<PointT> map;
        object.filter(map);
        return given(map.empty(), object.getReport());
      },
      [](Class& object) {
        object.clear();
        object.addPointCloud(as<PointT>(goodView().makeShared()),
                             Eigen::Isometry3d::Identity());
      })
      .addTo(cases);
}

template <typename Class, typename Output>
void
addFitting(std::vector<BadCase>& cases, const std::string& name)
{
  const auto set = [](Class& object, const std::vector<PlanePatch>& planes) {
    object.setPlanes(planes);
  };
  Face<Class> face(
      name,
      [=](Class& object) { set(object, {goodPlane()}); },
      [](Class& object) {
        std::vector<Output> found;
        object.segment(found);
        return given(found.empty(), object.getReport());
      });
  face.give("planes", badPlanes(), set)
      .give("planes", badPolygons(), set)
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); })
      .addTo(cases);
}

} // namespace

void
addCloudCases(std::vector<BadCase>& cases)
{
  addVoting(cases);
  addTriangulation(cases);
  addConsolidation(cases);
  addPlanes(cases);
  addCylinders(cases);
  addDepth(cases);
  addFilter<EntropyRectification<PointNormal>, PointNormal>(
      cases, "EntropyRectification, a filter");
  addFilter<PlaneAdjustment<PointXYZ>, PointXYZ>(cases, "PlaneAdjustment, a filter");
  addFitting<BoxFitting, BoxPatch>(cases, "BoxFitting");
  addFitting<RecessFitting, RecessPatch>(cases, "RecessFitting");
}

} // namespace pcl::acmap::test
