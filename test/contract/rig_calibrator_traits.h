#pragma once

#include "rendered_boards.h"
#include "shot_contract.h"

#include <pcl/stereo/rig_calibrator.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief Constructed with the shots of the first input, so that its parameters can be
 * compared. Uses a pair with few boards in small images, because detecting boards
 * takes most of the time of these tests. */
struct RigCalibratorTraits : CommonTraits<RigCalibrator> {
  static constexpr const char* header = "stereo/include/pcl/stereo/rig_calibrator.h";

  /** Parameters of the cameras and of the rig. */
  using Output = std::vector<double>;

  static constexpr std::size_t shots_of_input = 6;

  static Class
  make()
  {
    static const Class made = [] {
      Class object;
      addShots(object, 0, shots_of_input);
      return object;
    }();
    return made;
  }

  static const std::vector<TrinocularFrame>&
  shots()
  {
    static const std::vector<TrinocularFrame> all = [] {
      RigCalibration pair = builtRig(0.65);
      pair.camera(RigCamera::Vertical).is_there = false;
      return boardShots(pair, 2 * shots_of_input);
    }();
    return all;
  }

  /** \param[in] first index of the first shot that is added */
  static void
  addShots(Class& object, std::size_t first, std::size_t count)
  {
    object.setBoard({9, 6, 0.03});
    for (std::size_t i = first; i < first + count; ++i)
      object.addShot(shots()[i], shotNames(i));
  }

  static void
  run(Class& object, int which, Output& output)
  {
    addShots(object, shots_of_input * static_cast<std::size_t>(which), shots_of_input);
    calibrate(object, output);
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.size() < 20;
  }

  static Output
  sentinel()
  {
    return {42};
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{[](Class& o) {
               o.setBoard({2, 5, 0.03});
             },
             {"columns", "2", "[3, 100]"}},
            {[](Class& o) {
               o.setBoard({9, 101, 0.03});
             },
             {"rows", "101", "corners"}},
            {[](Class& o) {
               o.setBoard({8, 6, 0.03});
             },
             {"8 x 6", "even", "odd"}},
            {[=](Class& o) {
               o.setBoard({9, 6, nan});
             },
             {"square", "nan", "10] m"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no shot",
             [](Class& object, Output& output) {
               object.setBoard({});
               calibrate(object, output);
             }},
            {"too few shots", [](Class& object, Output& output) {
               addShots(object, 0, 4);
               calibrate(object, output);
             }}};
  }

  /** Rejected boards must not remove shots. */
  static std::string
  parameters(const Class& object)
  {
    std::string names;
    for (const BoardImage& image : object.getReport().images)
      names += image.name + " ";
    return names;
  }

private:
  /** Checks also that the outputs are unchanged if the function throws. */
  static void
  calibrate(Class& object, Output& output)
  {
    RigCalibration cameras;
    cameras.width = 0;
    TrinocularRig rig;
    try {
      object.calibrate(cameras, rig);
    }
    catch (...) {
      if (cameras.width != 0)
        output.clear();
      throw;
    }
    output = {rig.focal_length, rig.center_x, rig.center_y, rig.baseline_horizontal};
    for (const CameraCalibration& camera : cameras.cameras) {
      output.insert(output.end(), {camera.focal_x, camera.focal_y, camera.center_x});
      output.insert(output.end(), camera.distortion.begin(), camera.distortion.end());
      const auto& place = camera.T_reference_camera.matrix();
      output.insert(output.end(), place.data(), place.data() + place.size());
    }
  }
};

} // namespace pcl::acmap::test
