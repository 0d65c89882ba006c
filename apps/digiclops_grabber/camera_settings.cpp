#include "camera_settings.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace pcl::acmap {

namespace {

IidcMode
modeOf(const IidcCamera& camera, const std::string& wanted)
{
  std::string all;
  for (const IidcMode& mode : camera.modes()) {
    if (std::to_string(mode.format) + ":" + std::to_string(mode.mode) == wanted)
      return mode;
    all += (all.empty() ? "" : ", ") + mode.text();
  }
  throw UsageError("--mode: the camera has no mode " + wanted + "; it has " +
                   (all.empty() ? "none" : all));
}

void
setFeature(IidcCamera& camera, IidcFeature feature, const NumberOrAuto& wanted)
{
  if (wanted.is_auto)
    camera.setAutomatic(feature);
  else if (wanted.number)
    camera.setPhysical(feature, static_cast<float>(*wanted.number));
}

} // namespace

std::optional<ChannelOrder>
channelOrderOf(const std::string& text)
{
  if (text == "auto")
    return std::nullopt;
  constexpr std::array cameras = {
      RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  std::istringstream words(text);
  std::vector<RigCamera> order;
  for (std::string word; std::getline(words, word, ',');)
    for (const RigCamera camera : cameras) {
      const std::string name = nameOf(camera);
      const bool is_new = std::count(order.begin(), order.end(), camera) == 0;
      if (is_new && (word == name || word == name.substr(0, 1)))
        order.push_back(camera);
    }
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (order.size() != cameras.size() || commas != 2)
    throw UsageError("--channel-order: " + text +
                     " is neither auto nor an order of r,h,v");
  return ChannelOrder{order[0], order[1], order[2]};
}

void
setUpCamera(DigiclopsGrabber& grabber, const GrabberOptions& options)
{
  if (const auto order = channelOrderOf(options.channel_order))
    grabber.setChannelOrder(*order);
  if (!options.mode.empty())
    grabber.setMode(modeOf(grabber.camera(), options.mode));
  grabber.setFramesPerSecond(static_cast<float>(options.rate));
  setFeature(grabber.camera(), IidcFeature::Shutter, options.shutter);
  setFeature(grabber.camera(), IidcFeature::Gain, options.gain);
  grabber.camera().setTrigger(options.trigger == "external" ? IidcTrigger::External
                                                            : IidcTrigger::Off);
}

} // namespace pcl::acmap
