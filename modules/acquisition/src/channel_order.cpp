#include "images/corner_votes.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

namespace pcl {

namespace {

// Measured thresholds, see doc/acquisition/channel_order.md.
constexpr std::size_t min_found = 10; // corners
constexpr std::size_t min_lead = 4;   // factor to the number under any other order

void
requireImages(const TrinocularFrame& frame, const RigCalibration& calibration)
{
  requireSoundCalibration(calibration);
  for (const RigCamera camera :
       {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical}) {
    const CameraImage& image = frame.image(camera);
    const auto fail = [&](const std::string& fault) {
      throw acmap::BadArgument("the " + std::string(nameOf(camera)) + ' ' + fault);
    };
    if (!calibration.camera(camera).is_there)
      fail("camera is not in the calibration; three are needed to tell their order");
    if (!isWhole(image))
      fail("image is missing, or has not all its values");
    if (image.width != calibration.width || image.height != calibration.height)
      fail("image has " + acmap::sizeText(image) + " pixels, the calibration " +
           acmap::sizeText(calibration) + " pixels");
  }
}

void
requireOrder(const ChannelOrder& order)
{
  ChannelOrder sorted = order;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw acmap::BadArgument("channel order " + textOf(order) + " has a camera twice");
}

/** The images by their byte in a pixel. */
class ChannelImages {
public:
  ChannelImages(const TrinocularFrame& frame, const ChannelOrder& order)
  {
    for (std::size_t k = 0; k < order.size(); ++k) {
      images_[k].emplace(frame.image(order[k]));
      corners_[k] = images_[k]->corners();
    }
  }

  acmap::CornerVotes
  votesUnder(const ChannelOrder& order, const RigCalibration& calibration) const
  {
    std::array<const acmap::SmoothImage*, 3> by_camera{};
    std::size_t reference = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      by_camera[static_cast<std::size_t>(order[k])] = &*images_[k];
      if (order[k] == RigCamera::Reference)
        reference = k;
    }
    return acmap::countVotes(by_camera, corners_[reference], calibration);
  }

private:
  std::array<std::optional<acmap::SmoothImage>, 3> images_;
  std::array<std::vector<cv::Point>, 3> corners_;
};

} // namespace

std::string
textOf(const ChannelOrder& order)
{
  return std::string(nameOf(order[0])) + ',' + nameOf(order[1]) + ',' +
         nameOf(order[2]);
}

ChannelOrder
channelOrderIn(const std::string& text)
{
  std::istringstream words(text);
  std::vector<RigCamera> order;
  for (std::string word; std::getline(words, word, ',');)
    for (const RigCamera camera : acmap::rig_cameras) {
      const std::string name = nameOf(camera);
      const bool is_new = std::count(order.begin(), order.end(), camera) == 0;
      if (is_new && (word == name || word == name.substr(0, 1)))
        order.push_back(camera);
    }
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (order.size() != acmap::rig_cameras.size() || commas != 2)
    throw acmap::BadArgument(text + " is no order of r,h,v");
  return {order[0], order[1], order[2]};
}

ChannelOrderCheck
checkChannelOrder(const TrinocularFrame& frame,
                  const ChannelOrder& assumed,
                  const RigCalibration& calibration)
{
  requireImages(frame, calibration);
  requireOrder(assumed);
  const ChannelImages planes(frame, assumed);
  ChannelOrder best_order = assumed;
  acmap::CornerVotes best = planes.votesUnder(assumed, calibration);
  acmap::CornerVotes other;
  ChannelOrder order{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  do {
    if (order == assumed)
      continue;
    acmap::CornerVotes votes = planes.votesUnder(order, calibration);
    if (votes.found > best.found) {
      std::swap(votes, best);
      best_order = order;
    }
    if (votes.found > other.found)
      other = votes;
  } while (std::next_permutation(order.begin(), order.end()));

  ChannelOrderCheck check;
  check.best = best_order;
  check.is_certain = best.found >= min_found && best.found >= min_lead * other.found;
  check.corners = best.corners;
  check.share = best.share();
  check.runner_up = other.share();
  return check;
}

} // namespace pcl
