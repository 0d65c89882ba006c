#include "bad_clouds.h"
#include "face.h"

#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>

namespace pcl::acmap::test {

namespace {

using RowsPtr = PCLPointCloud2::Ptr;

template <typename Class>
Face<Class>
rowFace(
    const std::string& name,
    const typename Face<Class>::Run& run,
    const typename Face<Class>::Change& good = [](Class&) {})
{
  const auto set = [](Class& object, const RowsPtr& rows) {
    object.setInputCloud(rows);
  };
  Face<Class> face(
      name + "<PCLPointCloud2>",
      [=](Class& object) {
        set(object, asRows(goodView().makeShared()));
        good(object);
        object.setNumberOfThreads(1);
      },
      run);
  face.give("cloud", badRows(), set).common([](Class& object, unsigned n) {
    object.setNumberOfThreads(n);
  });
  return face;
}

Given
rowCylinders(CylinderHypothesisClustering<PCLPointCloud2>& object)
{
  std::vector<CylinderPatch> cylinders;
  object.segment(cylinders);
  return given(cylinders.empty(), object.getReport());
}

template <typename Class>
void
addClustering(std::vector<BadCase>& cases,
              const std::string& name,
              const typename Face<Class>::Run& run)
{
  const std::size_t points = goodView().size();
  rowFace<Class>(
      name,
      run,
      [](Class& object) { object.setInputNormals(asRows(goodView().makeShared())); })
      .give("normals",
            badLayouts(),
            [](Class& object, const RowsPtr& normals) {
              object.setInputNormals(normals);
            })
      .give("source",
            orNone(badRows()),
            [](Class& object, const RowsPtr& source) {
              object.setSourceCloud(CloudRows(source));
            })
      .give("mesh",
            badMeshes(points),
            [](Class& object, const TriangleMesh& mesh) { object.setTriangles(mesh); })
      .addTo(cases);
}

template <typename Class>
Given
filterRows(Class& object)
{
  PCLPointCloud2 output;
  object.filter(output);
  return given(output.data.empty(), object.getReport());
}

void
addPlaneMapping(std::vector<BadCase>& cases)
{
  using Class = PlaneMapping;
  const auto run = [](Class& object) {
    MappedPlanes result;
    object.compute(result);
    return given(result.planes.empty(), object.getReport());
  };
  const auto set_file = [](Class& object, const RowsPtr& rows) {
    std::shared_ptr<PointCloudFile> file;
    if (rows) {
      file = std::make_shared<PointCloudFile>();
      file->cloud = *rows;
    }
    object.setInputCloud(std::shared_ptr<const PointCloudFile>(file));
  };
  rowFace<Class>("PlaneMapping", run)
      .give("file", badRows(), set_file)
      .give("points",
            badClouds(),
            [](Class& object, const Cloud::Ptr& cloud) { object.setInputCloud(cloud); })
      .give("indices",
            badIndices(goodView().size()),
            [](Class& object, const IndicesPtr& i) { object.setIndices(i); })
      .give("mesh",
            badMeshes(goodView().size()),
            [](Class& object, const TriangleMesh& mesh) { object.setInputMesh(mesh); })
      .give("viewpoints",
            badViewpoints(),
            [](Class& object, const auto& places) { object.setViewpoints(places); })
      .addTo(cases);
}

} // namespace

void
addRowCases(std::vector<BadCase>& cases)
{
  using Voting = NormalVectorVoting<PCLPointCloud2>;
  rowFace<Voting>("NormalVectorVoting",
                  [](Voting& object) {
                    CloudRows normals;
                    object.compute(normals);
                    return given(normals.size() == 0, object.getReport());
                  })
      .give("mesh",
            badMeshes(goodView().size()),
            [](Voting& object, const TriangleMesh& mesh) { object.setTriangles(mesh); })
      .addTo(cases);
  using Triangulation = DeWallTriangulation<PCLPointCloud2>;
  rowFace<Triangulation>("DeWallTriangulation", [](Triangulation& object) {
    TriangleMesh mesh;
    object.reconstruct(mesh);
    return given(mesh.triangles.empty(), object.getReport());
  }).addTo(cases);
  using Consolidation = VoxelConsolidation<PCLPointCloud2>;
  rowFace<Consolidation>("VoxelConsolidation", filterRows<Consolidation>)
      .give("indices",
            badIndices(goodView().size()),
            [](Consolidation& object, const IndicesPtr& i) { object.setIndices(i); })
      .addTo(cases);
  using Refinement = DepthRefinement<PCLPointCloud2>;
  rowFace<Refinement>("DepthRefinement", filterRows<Refinement>)
      .give("indices",
            badIndices(goodView().size()),
            [](Refinement& object, const IndicesPtr& i) { object.setIndices(i); })
      .addTo(cases);
  using Planes = PlaneHypothesisClustering<PCLPointCloud2>;
  addClustering<Planes>(cases, "PlaneHypothesisClustering", planesOf<Planes>);
  using Cylinders = CylinderHypothesisClustering<PCLPointCloud2>;
  addClustering<Cylinders>(cases, "CylinderHypothesisClustering", rowCylinders);
  addPlaneMapping(cases);
}

} // namespace pcl::acmap::test
