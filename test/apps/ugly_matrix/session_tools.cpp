#include "input_cases.h"
#include "ugly_tools.h"

namespace pcl::acmap::test {

UglyTool
uglyActiveStereo()
{
  const auto command = [](const std::string& input) {
    return std::vector<std::string>{input, "-o", "clouds"};
  };
  return {"pcl_active_stereo",
          "clouds",
          true,
          false,
          sessionCases(command, sessionOutcomes())};
}

namespace {

/** \brief A tool that opens a recording like a camera. */
UglyTool
uglyGrabber(const std::string& tool)
{
  const auto command = [](const std::string& input) {
    return std::vector<std::string>{"--device", input, "--pcd", "clouds"};
  };
  std::map<std::string, UglyOutcome> outcomes = sessionOutcomes();
  outcomes["no such session"] = {2, "none is no folder with a recording"};
  outcomes["a file for the session"] = outcomes["no such session"];
  outcomes["`/dev/zero`"] = {2, "/dev/zero is no folder with a recording"};
  outcomes[one_frame] = {4, "no pixel has a place"};
  return {tool, "clouds", true, false, sessionCases(command, outcomes)};
}

} // namespace

UglyTool
uglyCameraGrabber()
{
  return uglyGrabber("pcl_camera_grabber");
}

UglyTool
uglyDigiclopsGrabber()
{
  return uglyGrabber("pcl_digiclops_grabber");
}

} // namespace pcl::acmap::test
