#include "egomotion_runs.h"
#include "egomotion_tables.h"
#include "visual_egomotion/egomotion_pictures.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <filesystem>

namespace pcl::acmap::bench {
namespace {

/** Draws all matches above, and the ones used for the motion below. */
RgbImage
picturePair(const EgomotionSequence& sequence, std::size_t target)
{
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setInputSource(sequence.clouds[target + 1]);
  egomotion.setInputTarget(sequence.clouds[target]);
  egomotion.compute();
  return matchPicture(*sequence.clouds[target + 1],
                      *sequence.clouds[target],
                      egomotion.getMatches(),
                      egomotion.getInliers());
}

} // namespace

void
saveEgomotionPictures(const std::string& folder)
{
  constexpr std::size_t pair = 5;
  const std::filesystem::path place(folder);
  const EgomotionSequence sequence = driveThrough("l_corridor_drive");
  savePng((place / "drive_matches.png").string(), picturePair(sequence, pair));
  const EgomotionRun run = runChain(oursMethod(true), sequence);
  savePng((place / "drive_path.png").string(),
          trajectoryPicture({run.poses.begin(), run.poses.end()}, sequence.truth));
}

} // namespace pcl::acmap::bench
