#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/texture/impl/plane_texturing.hpp>
#include <pcl/texture/impl/texturing_kernel.h>

namespace pcl::acmap {

ColoredView
viewOfObservation(const TexturedObservation& observation)
{
  ColoredView view;
  view.points = requirePoints(observation.cloud);
  const PCLPointCloud2& cloud = observation.cloud.layout();
  view.colors = colorsOf(observation.cloud);
  if (const PCLPointField* const field = findField(cloud, "intensity");
      field && observation.cloud.bytes() > 0)
    view.intensities = {
        observation.cloud.data() + field->offset, cloud.point_step, field->datatype};
  if (const PCLPointField* const field = findField(cloud, "view", PCLPointField::INT32);
      field && observation.cloud.bytes() > 0)
    view.stations = {observation.cloud.data() + field->offset, cloud.point_step};
  const bool is_picture = observation.has_sensor && cloud.height > 1;
  view.width = is_picture ? static_cast<int>(cloud.width) : 0;
  view.has_eye = observation.has_sensor;
  view.T_map_camera = observation.T_map_camera;
  return view;
}

} // namespace pcl::acmap

PCL_INSTANTIATE(PlaneTexturing, ACMAP_ALL_POINT_TYPES)
