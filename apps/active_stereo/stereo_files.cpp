#include "stereo_files.h"

#include "disparity_picture.h"
#include "output_target.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/observation_files.h>

namespace pcl::acmap {

namespace {

constexpr const char* disparity_name = "disparity";

bool
isStereoName(const std::string& name)
{
  return isSequenceName(name) || name.rfind(disparity_name, 0) == 0;
}

} // namespace

void
requireNoStereo(const OutputFolder& folder)
{
  requireNoneIn(folder, isStereoName);
}

void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            const ObservationShots& shots,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(made.cloud, cloud);
  saveObservation(folder.path(observationName(shots.number)), cloud, T_map_camera);
  if (!options.hasLists() && !options.disparity)
    return;
  const auto path = [&](const char* ending) {
    return folder.path(options.hasLists()
                           ? std::string(disparity_name) + ending
                           : numberedName(disparity_name, shots.number, ending));
  };
  const DisparityImage& disparity = made.matched.disparity;
  savePfm(path(".pfm"), disparity);
  savePng(path(".png"), disparity.width, disparity.height, pictureOf(disparity));
}

} // namespace pcl::acmap
