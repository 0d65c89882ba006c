#include "digiclops_grabber/grab_run.h"

namespace {

using namespace pcl::acmap;

/** \brief Throws if no frame of a recording could be read. */
void
requireFrames(const GrabRun& run, const GrabberOptions& options)
{
  if (run.frames() == 0)
    throw pcl::InputFileException(options.device + ": has no frame that can be read");
}

void
pass(GrabRun& run,
     const GrabberOptions& options,
     const std::optional<Projection>& projection)
{
  if (projection)
    run.passObservations(*projection->sequence);
  else if (options.isStream())
    run.passStream();
  else {
    run.passRecording();
    requireFrames(run, options);
  }
}

void
grab(Tool& tool, const GrabberOptions& options)
{
  StepTimer timer(tool.report());
  // locks the drawing of the projector's window and of the live window
  std::mutex drawing;
  std::optional<LiveWindow> live;
  if (options.live)
    live.emplace(drawing);
  StatusLine status(!tool.isQuiet());
  const Device device = openDevice(options);
  GrabOutputs outputs(tool, options, device, [&](const auto& cloud) {
    if (live)
      live->show(*cloud);
  });
  std::optional<Projection> projection;
  if (device.camera && !options.isStream())
    projection = openProjection(tool, options, device, drawing, status);
  timer.finish("open");

  GrabRun run(tool, options, device, outputs, status, live ? &*live : nullptr);
  try {
    pass(run, options, projection);
    timer.finish("grab");
    outputs.finish();
  }
  catch (...) {
    outputs.keep(std::current_exception());
  }
  tellDevice(tool, options, device, projection ? &*projection : nullptr, run.frames());
  outputs.tell();
  run.waitForWindow();
}

void
run(Tool& tool, const GrabberOptions& options)
{
  requireSense(tool, options);
  if (options.list)
    listCameras(tool);
  else
    grab(tool, options);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool(
      "pcl_digiclops_grabber",
      "Takes observations with a trinocular camera and a projector: point clouds, "
      "a raw session, or both.");
  GrabberOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { run(tool, options); });
}
