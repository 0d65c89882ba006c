#include <pcl/texture/impl/plane_texturing.hpp>
#include <pcl/texture/impl/texturing_kernel.h>

#include <array>
#include <optional>

namespace pcl::acmap {

namespace {

template <typename Matrix>
void
putMatrix(const Matrix& matrix, ByteParcel& parcel)
{
  parcel.putAll(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

template <typename Matrix>
void
takeMatrix(ByteParcel& parcel, Matrix& matrix)
{
  parcel.takeAll(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

using Loop = std::vector<Eigen::Vector3f>;

void
putLoop(const Loop& loop, ByteParcel& parcel)
{
  parcel.put(loop.size());
  for (const Eigen::Vector3f& point : loop)
    putMatrix(point, parcel);
}

Loop
takeLoop(ByteParcel& parcel)
{
  Loop loop(parcel.takeCount<std::array<float, 3>>());
  for (Eigen::Vector3f& point : loop)
    takeMatrix(parcel, point);
  return loop;
}

void
putPlane(const PlanePatch& plane, ByteParcel& parcel)
{
  putMatrix(plane.coefficients, parcel);
  putMatrix(plane.center, parcel);
  putMatrix(plane.axis_u, parcel);
  putMatrix(plane.axis_v, parcel);
  parcel.put(plane.polygons.size());
  for (const PlanePolygon& polygon : plane.polygons) {
    putLoop(polygon.outer, parcel);
    parcel.put(polygon.holes.size());
    for (const Loop& hole : polygon.holes)
      putLoop(hole, parcel);
  }
}

PlanePatch
takePlane(ByteParcel& parcel)
{
  PlanePatch plane;
  takeMatrix(parcel, plane.coefficients);
  takeMatrix(parcel, plane.center);
  takeMatrix(parcel, plane.axis_u);
  takeMatrix(parcel, plane.axis_v);
  for (auto polygons = parcel.take<std::size_t>(); polygons > 0; --polygons) {
    PlanePolygon& polygon = plane.polygons.emplace_back();
    polygon.outer = takeLoop(parcel);
    for (auto holes = parcel.take<std::size_t>(); holes > 0; --holes)
      polygon.holes.push_back(takeLoop(parcel));
  }
  return plane;
}

void
putCylinder(const CylinderPatch& cylinder, ByteParcel& parcel)
{
  putMatrix(cylinder.axis_point, parcel);
  putMatrix(cylinder.axis_direction, parcel);
  putMatrix(cylinder.axis_u, parcel);
  putMatrix(cylinder.axis_v, parcel);
  for (const double length :
       {cylinder.radius, cylinder.low, cylinder.high, cylinder.arc})
    parcel.put(length);
  parcel.put(cylinder.is_hollow);
}

CylinderPatch
takeCylinder(ByteParcel& parcel)
{
  CylinderPatch cylinder;
  takeMatrix(parcel, cylinder.axis_point);
  takeMatrix(parcel, cylinder.axis_direction);
  takeMatrix(parcel, cylinder.axis_u);
  takeMatrix(parcel, cylinder.axis_v);
  for (double* const length :
       {&cylinder.radius, &cylinder.low, &cylinder.high, &cylinder.arc})
    *length = parcel.take<double>();
  cylinder.is_hollow = parcel.take<bool>();
  return cylinder;
}

} // namespace

void
putShapes(const std::vector<PlanePatch>& planes,
          const std::vector<CylinderPatch>& cylinders,
          ByteParcel& parcel)
{
  parcel.put(planes.size());
  for (const PlanePatch& plane : planes)
    putPlane(plane, parcel);
  parcel.put(cylinders.size());
  for (const CylinderPatch& cylinder : cylinders)
    putCylinder(cylinder, parcel);
}

void
takeShapes(ByteParcel& parcel,
           std::vector<PlanePatch>& planes,
           std::vector<CylinderPatch>& cylinders)
{
  for (auto left = parcel.take<std::size_t>(); left > 0; --left)
    planes.push_back(takePlane(parcel));
  for (auto left = parcel.take<std::size_t>(); left > 0; --left)
    cylinders.push_back(takeCylinder(parcel));
}

void
sendPainted(const std::vector<PlanePatch>& planes,
            const std::vector<CylinderPatch>& cylinders,
            const TexturingSettings& settings,
            const std::vector<TexturedObservationLoader>& observations,
            const std::function<void(const ByteParcel&)>& send)
{
  TextureBuilder builder(planes, cylinders, settings);
  Trajectory trajectory;
  for (const TexturedObservationLoader& load : observations) {
    std::optional<TexturedObservation> observation = load();
    if (!observation)
      continue;
    observation->T_map_camera = RigidMotion(observation->T_map_camera);
    builder.add(viewOfObservation(*observation));
    trajectory.stamps.push_back(observation->stamp);
    trajectory.poses.push_back(observation->T_map_camera);
  }
  builder.sendTo(trajectory, send);
}

} // namespace pcl::acmap
