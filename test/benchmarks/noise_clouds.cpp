#include "noise_clouds.h"

#include "bench_data.h"
#include "packed_cloud.h"

#include <pcl/core/exceptions.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

struct NoiseSource {
  const char* name;
  const char* path;
  bool is_view;
  bool is_exact;
};

constexpr NoiseSource sources[] = {
    {"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd", true, false},
    {"office1", "E_meshing/office1.pcd", true, false},
    {"capture0001", "E_meshing/capture0001.pcd", true, false},
    {"bun0", "E_meshing/bun0.pcd", false, false},
    {"stanford-bunny", "E_meshing/stanford-bunny.obj", false, false},
    {"fandisk", "E_meshing/fandisk.obj", false, true},
    {"room_scan1", "C_sequence/pcl_room_scans/room_scan1.pcd", false, false},
    {"grenoble_room", "D_large/grenoble_room_5.2M.ply.xz", false, false},
    {"wtc37_corridor", "D_large/wtc37_corridor_1M.ply.xz", false, false},
};

} // namespace

void
forEachNoiseCloud(const std::function<void(const NoiseCloud&)>& use)
{
  for (const NoiseSource& source : sources) {
    const std::optional<std::string> path = pathOfData(source.path);
    if (!path)
      continue;
    try {
      use({source.name, loadMaybePacked(*path), source.is_view, source.is_exact});
    }
    catch (const InputFileException& error) {
      std::cerr << "left out: " << error.what() << "\n";
    }
  }
}

} // namespace pcl::acmap::bench
