#pragma once

#include "shot_contract.h"

#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

namespace pcl::acmap::test {

/** \brief Its input is set by its constructor, so it is not default-constructible;
 * light and projector are. */
struct SimulatedRigGrabberTraits : CommonTraits<SimulatedRigGrabber> {
  static constexpr const char* header =
      "simulation/include/pcl/simulation/simulated_rig_grabber.h";
  using Output = std::vector<std::array<CameraImage, 3>>;

  static SimulatedScene
  smallOffice()
  {
    SimulatedScene scene = standardScene("office");
    scene.rig.width = 64;
    scene.rig.height = 48;
    scene.rig.focal_length = 52;
    scene.rig.center_x = 31.5;
    scene.rig.center_y = 23.5;
    scene.views.resize(2);
    return scene;
  }

  static Class
  make()
  {
    const SimulatedProjector projector;
    RgbImage white{projector.width, projector.height, {}};
    white.values.assign(
        static_cast<std::size_t>(3 * projector.width * projector.height), 255);
    return Class(smallOffice(), {white});
  }

  static void
  run(Class& object, int which, Output& output)
  {
    Output seen;
    for (const auto& frame : object.observe(static_cast<std::size_t>(which)))
      seen.push_back(frame->images);
    output = std::move(seen);
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.size() != 2 || output[0][2].empty() || output[0] == output[1];
  }

  static Output
  sentinel()
  {
    return Output(7);
  }

  static Calls
  refusedCalls()
  {
    return {{[](Class& o) { o.setNumberOfObservations(0); },
             {"observations", "0", "[1, 2]"}},
            {[](Class& o) { o.setNumberOfObservations(3); },
             {"observations", "3", "[1, 2]"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"a view that is not there",
             [](Class& object, Output& output) { run(object, 2, output); }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "seed " << object.getSeed() << ", observations "
          << object.getNumberOfObservations() << ", threads "
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
