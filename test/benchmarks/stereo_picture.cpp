#include "disparity_picture.h"
#include "picture_sheet.h"
#include "simulated_shots.h"
#include "stereo_bag.h"
#include "stereo_tables.h"

#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/disparity_fusion.h>

#include <filesystem>

namespace pcl::acmap::bench {
namespace {

constexpr int columns = 4;
constexpr int single_shots = 3;
constexpr double from_right = -0.45, from_left = 0.15; // rad

/** An observation with the parameters of its matching and display. */
struct Showing {
  StereoShots shots;
  TrinocularFrame::ConstPtr off;
  TrinocularMatching matching;
  float minimum; // px, minimum of the colour map
  float maximum;

  CameraImage
  colored(const DisparityImage& disparity) const
  {
    return coloredDisparity(disparity, minimum, maximum);
  }

  CameraImage
  colorOfOne(const TrinocularFrame& shot)
  {
    MatchedDisparity matched;
    matching.match(shot, matched);
    return colored(matched.disparity);
  }

  DisparityImage
  fused(DisparityFusion::Method method) const
  {
    DisparityFusion fusion;
    fusion.setMatching(matching);
    fusion.setMethod(method);
    fusion.setInputRig(shots.rig);
    for (const TrinocularFrame::ConstPtr& frame : shots.frames)
      fusion.addShot(frame);
    MatchedDisparity matched;
    fusion.fuse(matched);
    return matched.disparity;
  }
};

/** Fig. 2: the reference without a pattern and with three, the disparities of each,
 * their median and space-time result, and the points of these from beside. */
void
putFusion(PictureSheet& sheet, Showing showing)
{
  showing.matching.setInputRig(showing.shots.rig);
  const CameraImage& color = showing.off->image(RigCamera::Reference);
  std::vector<TrinocularFrame::ConstPtr> shown = {showing.off};
  shown.insert(shown.end(),
               showing.shots.frames.begin(),
               showing.shots.frames.begin() + single_shots);
  for (int column = 0; column < columns; ++column) {
    const TrinocularFrame& shot = *shown[static_cast<std::size_t>(column)];
    sheet.put(column, 0, shot.image(RigCamera::Reference));
    sheet.put(column, 1, showing.colorOfOne(shot));
  }
  const DisparityImage median = showing.fused(DisparityFusion::Method::Median);
  const DisparityImage together = showing.fused(DisparityFusion::Method::SpaceTime);
  sheet.put(0, 2, showing.colored(median));
  sheet.put(1, 2, showing.colored(together));
  sheet.put(2, 2, viewFromBeside(together, color, showing.shots.rig, from_right));
  sheet.put(3, 2, viewFromBeside(together, color, showing.shots.rig, from_left));
}

/** Fig. 3: the reference, the disparities, the true disparities, and the points. */
void
putPlace(PictureSheet& sheet, int row, const Showing& showing)
{
  const CameraImage& color = showing.off->image(RigCamera::Reference);
  const DisparityImage fused = showing.fused(DisparityFusion::Method::SpaceTime);
  sheet.put(0, row, color);
  sheet.put(1, row, showing.colored(fused));
  sheet.put(2, row, showing.colored(showing.shots.truth));
  sheet.put(3, row, viewFromBeside(fused, color, showing.shots.rig, -from_right));
}

Showing
corridorAt(std::size_t view)
{
  constexpr float maximum = 42.0f; // px: 1.2 m
  SimulatedShots taken = takeShots(standardScene("corridor"), view);
  return {std::move(taken.shots), std::move(taken.off), {}, 0.0f, maximum};
}

void
saveCorridor(const std::string& path)
{
  constexpr std::size_t place = 8, other_place = 21;
  constexpr int rows = 4, smaller = 3;
  const Showing here = corridorAt(place);
  PictureSheet sheet(
      columns, rows, here.shots.rig.width, here.shots.rig.height, smaller);
  putFusion(sheet, here);
  putPlace(sheet, 3, corridorAt(other_place));
  sheet.save(path);
}

void
saveBag(const std::string& path)
{
  constexpr int rows = 3, smaller = 2;
  constexpr float minimum = 70.0f, maximum = 86.0f; // px
  const Showing bag{loadBag(), loadPassiveBag(), bagMatching(), minimum, maximum};
  PictureSheet sheet(columns, rows, bag.shots.rig.width, bag.shots.rig.height, smaller);
  putFusion(sheet, bag);
  sheet.save(path);
}

} // namespace

void
saveStereoPictures(const std::string& folder)
{
  const std::filesystem::path place(folder);
  saveCorridor((place / "stereo_disparities.png").string());
  if (hasBag("picture"))
    saveBag((place / "bag_disparities.png").string());
}

} // namespace pcl::acmap::bench
