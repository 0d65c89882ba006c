#pragma once

#include "rendered_boards.h"
#include "shot_contract.h"

#include <pcl/core/random.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief Constructed with a calibration, so that its parameters can be compared. Its
 * report describes the calibration, not a run. */
struct TrinocularRectificationTraits : CommonTraits<TrinocularRectification> {
  static constexpr const char* header =
      "stereo/include/pcl/stereo/trinocular_rectification.h";
  using Output = std::array<CameraImage, 3>;

  static Class
  make()
  {
    Class object;
    object.setInputCalibration(builtRig());
    return object;
  }

  static TrinocularFrame
  noise(std::uint64_t seed)
  {
    Random random(seed);
    TrinocularFrame frame;
    for (CameraImage& image : frame.images) {
      image = {640, 480, 1, std::vector<std::uint8_t>(640 * 480)};
      for (std::uint8_t& value : image.values)
        value = static_cast<std::uint8_t>(random.bits());
    }
    return frame;
  }

  static void
  run(Class& object, int which, Output& output)
  {
    rectify(object, noise(static_cast<std::uint64_t>(which)), output);
  }

  static bool
  isEmpty(const Output& output)
  {
    return output[2].values.size() != 640 * 480;
  }

  static Output
  sentinel()
  {
    Output output;
    output[1].width = 42;
    return output;
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Calls calls;
    for (const auto& [value, word] :
         {std::pair(0.0, "= 0"), std::pair(nan, "nan"), std::pair(1e4, "10000")})
      calls.push_back({[value = value](Class& o) { o.setNearestDepth(value); },
                       {"nearest depth", word, "[0.01, 1000] m"}});
    calls.push_back({[](Class& o) {
                       RigCalibration rig = builtRig();
                       rig.camera(RigCamera::Vertical).focal_y = -2;
                       o.setInputCalibration(rig);
                     },
                     {"focal_y", "-2", " px"}});
    return calls;
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no calibration",
             [](Class&, Output& output) { rectify(Class(), noise(1), output); }},
            {"another size", [](Class& object, Output& output) {
               TrinocularFrame frame = noise(1);
               frame.images[2].width = 320;
               rectify(object, frame, output);
             }}};
  }

  /** The rig depends on the calibration, and the residual on the minimum depth. */
  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words.precision(std::numeric_limits<double>::max_digits10);
    words << "focal length " << object.getRig().focal_length << ", residual "
          << object.getReport().column_residual;
    return words.str();
  }

private:
  static void
  rectify(const Class& object, const TrinocularFrame& frame, Output& output)
  {
    TrinocularFrame rectified;
    rectified.images = output;
    try {
      object.rectify(frame, rectified);
    }
    catch (...) {
      output = rectified.images;
      throw;
    }
    output = rectified.images;
  }
};

} // namespace pcl::acmap::test
