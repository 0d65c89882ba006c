#pragma once

#include "shot_contract.h"

#include <pcl/core/random.h>
#include <pcl/stereo/disparity_fusion.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {

/** \brief Constructed with a rig, which each input needs, and with Statistical, which
 * matches and fuses. The output consists of the bytes of disparities, standard
 * deviations and support. */
struct DisparityFusionTraits : CommonTraits<DisparityFusion> {
  static constexpr const char* header = "stereo/include/pcl/stereo/disparity_fusion.h";
  using Output = std::vector<std::uint32_t>;

  static Class
  make()
  {
    TrinocularRig rig;
    rig.width = 64;
    rig.height = 48;
    rig.focal_length = 52;
    rig.center_x = 31.5;
    rig.center_y = 23.5;
    Class object;
    object.setMethod(Class::Method::Statistical);
    object.setInputRig(rig);
    return object;
  }

  /** A wall of random texture with a disparity of two or three pixels. */
  static TrinocularFrame::Ptr
  shot(int pattern, int disparity)
  {
    Random random(static_cast<std::uint64_t>(pattern));
    auto frame = std::make_shared<TrinocularFrame>();
    frame->pattern = pattern;
    std::array<std::uint8_t, 80 * 64> wall;
    for (std::uint8_t& value : wall)
      value = static_cast<std::uint8_t>(random.bits());
    const std::array<std::array<int, 2>, 3> moves = {{{0, 0}, {1, 0}, {0, 1}}};
    for (std::size_t i = 0; i < moves.size(); ++i) {
      frame->images[i] = {64, 48, 1, {}};
      for (int row = 0; row < 48; ++row)
        for (int column = 0; column < 64; ++column)
          frame->images[i].values.push_back(
              wall[static_cast<std::size_t>((row + 8 - disparity * moves[i][1]) * 80 +
                                            column + 8 - disparity * moves[i][0])]);
    }
    return frame;
  }

  static void
  run(Class& object, int which, Output& output)
  {
    object.clear();
    for (int pattern = 0; pattern < 4; ++pattern)
      object.addShot(shot(pattern, 2 + which));
    fuse(object, output);
  }

  static bool
  isEmpty(const Output& output)
  {
    const std::uint32_t maximum =
        *std::max_element(output.end() - 64 * 48, output.end()); // support
    return output.size() != 3u * 64 * 48 || maximum != 4;
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
    return {
        {[](Class& o) { o.setMinimumSupport(0); }, {"support", "0", "[1, 256] shots"}},
        {[](Class& o) { o.setMinimumSupport(257); }, {"support", "257", "256"}},
        {[=](Class& o) { o.setLeastGain(nan); }, {"gain", "nan", "[0, 1]", "pixels"}},
        {[](Class& o) { o.setLeastGain(-0.1); }, {"gain", "-0.1", "[0, 1]"}},
        {[](Class& o) {
           TrinocularRig rig;
           rig.focal_length = -2;
           o.setInputRig(rig);
         },
         {"focal", "-2", "px"}},
        {[](Class& o) {
           TrinocularRig rig;
           rig.baseline_horizontal = rig.baseline_vertical = 0;
           o.setInputRig(rig);
         },
         {"baseline", "0", "m"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no rig",
             [](Class&, Output& output) {
               Class object;
               fuse(object, output);
             }},
            {"no shot", [](Class& object, Output&) { object.addShot(nullptr); }},
            {"another size",
             [](Class& object, Output&) {
               const auto frame = shot(0, 0);
               frame->images[0].width = 32;
               object.addShot(frame);
             }},
            {"cancelled", [](Class& object, Output& output) {
               object.addShot(shot(0, 0));
               object.setProgressCallback(
                   [](double, const std::string&) { return false; });
               try {
                 fuse(object, output);
               }
               catch (...) {
                 object.setProgressCallback({});
                 throw;
               }
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "method " << static_cast<int>(object.getMethod()) << ", support "
          << object.getMinimumSupport() << ", passive " << object.getPassive()
          << ", gain " << object.getLeastGain() << ", threads "
          << object.getNumberOfThreads() << ", disparities "
          << object.getMatching().getMaxDisparity() << ", focal length "
          << object.getMatching().getInputRig().focal_length;
    return words.str();
  }

private:
  static void
  fuse(Class& object, Output& output)
  {
    MatchedDisparity fused;
    object.fuse(fused);
    const std::size_t pixels = fused.support.size();
    Output bytes(2 * pixels);
    std::memcpy(bytes.data(), fused.disparity.values.data(), 4 * pixels);
    std::memcpy(bytes.data() + pixels, fused.sigma.data(), 4 * pixels);
    bytes.insert(bytes.end(), fused.support.begin(), fused.support.end());
    output = std::move(bytes);
  }
};

} // namespace pcl::acmap::test
