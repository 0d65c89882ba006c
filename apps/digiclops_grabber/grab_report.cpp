#include "grab_run.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

// number of remarks in warnings; the report has all
constexpr std::size_t max_named = 10;

void
tellRecording(Tool& tool, const GrabberOptions& options, const Device& device)
{
  const TrinocularFileReport report = device.recording->getReport();
  for (std::size_t i = 0; i < std::min(max_named, report.remarks.size()); ++i)
    tool.warn(report.remarks[i]);
  if (report.remarks.size() > max_named)
    tool.warn(std::to_string(report.remarks.size() - max_named) +
              " further findings, the report names them");
  if (!report.doubled.empty())
    tool.warn(std::to_string(report.doubled.size()) +
              " frames whose shot was there before are left out");
  tool.details()["recording"] = {{"folder", options.device},
                                 {"is_finished", report.is_finished},
                                 {"broken_frames", report.broken},
                                 {"left_out_frames", report.doubled},
                                 {"findings", report.remarks}};
  tool.tell("recording", options.device);
}

Json
jsonOf(const std::optional<ChannelOrderCheck>& check)
{
  if (!check)
    return nullptr;
  return {{"best", textOf(check->best)},
          {"is_certain", check->is_certain},
          {"corners", check->corners},
          {"share", check->share},
          {"runner_up", check->runner_up}};
}

void
tellCamera(Tool& tool, DigiclopsGrabber& grabber)
{
  const IidcIdentity identity = grabber.camera().identity();
  const DigiclopsGrabberReport report = grabber.getReport();
  const std::string order = textOf(grabber.getChannelOrder());
  tool.details()["camera"] = {{"place", grabber.camera().place()},
                              {"serial", identity.serial()},
                              {"maker", identity.maker},
                              {"model", identity.model},
                              {"iidc", identity.version},
                              {"mode", grabber.getMode().text()},
                              {"rate", grabber.getFramesPerSecond()},
                              {"lost", report.lost},
                              {"broken", report.broken},
                              {"early", report.early},
                              {"restarts", report.restarts},
                              {"channel_order", order},
                              {"order_check", jsonOf(report.order)}};
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tool.tell("camera",
            identity.serial() + ", " + identity.maker + ", " + identity.model + ", " +
                grabber.camera().place());
  tool.tell("mode", grabber.getMode().text() + ", channels " + order);
  tool.tell("lost",
            std::to_string(report.lost) + ", broken " + std::to_string(report.broken) +
                ", restarts " + std::to_string(report.restarts));
}

void
tellProjector(Tool& tool, const GrabberOptions& options, const Projection& projection)
{
  const MonitorPlace& monitor = projection.window->getMonitor();
  const PatternSequenceGrabberReport report = projection.sequence->getReport();
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tool.details()["projector"] = {{"monitor", monitor.name},
                                 {"width", monitor.width},
                                 {"height", monitor.height},
                                 {"patterns", options.pattern.patterns},
                                 {"seed", options.pattern.seed},
                                 {"settle", projection.sequence->getSettleTime()},
                                 {"spared", report.spared}};
  tool.tell("projector",
            "monitor " + monitor.name + ", " + std::to_string(monitor.width) + " x " +
                std::to_string(monitor.height) + " px, settles in " +
                shortNumber(projection.sequence->getSettleTime()) + " s" +
                (options.early
                     ? ", " + std::to_string(report.spared) + " patterns spared"
                     : ""));
}

} // namespace

void
tellDevice(Tool& tool,
           const GrabberOptions& options,
           const Device& device,
           const Projection* projection,
           std::size_t frames)
{
  if (device.camera)
    tellCamera(tool, *device.camera);
  else
    tellRecording(tool, options, device);
  if (projection)
    tellProjector(tool, options, *projection);
  tool.details()["frames"] = frames;
  tool.details()["is_rectified"] = !device.cameras.has_value();
  tool.tell("frames",
            std::to_string(frames) + (device.cameras ? ", raw" : ", rectified"));
}

} // namespace pcl::acmap
