#pragma once

#include "room_views.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/impl/visual_egomotion.hpp>

namespace pcl::acmap::test {

/** \brief A view of a room in the format of the chain. */
inline CameraView
chainView(const Room& room,
          const Eigen::Isometry3d& T_room_camera,
          const RoomCamera& camera = {})
{
  return cameraViewOf(*viewOf(room, T_room_camera, camera));
}

} // namespace pcl::acmap::test
