#pragma once

#include "matched_checks.h"
#include "shot_contract.h"
#include "synthetic_shots.h"

#include <pcl/stereo/trinocular_matching.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief Constructed with a rig, so that its parameters can be compared. */
struct TrinocularMatchingTraits : CommonTraits<TrinocularMatching> {
  static constexpr const char* header =
      "stereo/include/pcl/stereo/trinocular_matching.h";

  struct Output : MatchedDisparity {
    bool
    operator==(const Output& other) const
    {
      return isSame(*this, other);
    }
  };

  static Class
  make()
  {
    Class object;
    object.setInputRig(syntheticRig(-0.1, -0.1));
    return object;
  }

  static std::vector<TrinocularFrame::ConstPtr>
  shots(int which)
  {
    const auto all = shotsOf(flatScene(syntheticRig(-0.1, -0.1), 9 + 4 * which), 3);
    return {all.begin(), all.end()};
  }

  static void
  run(Class& object, int which, Output& output)
  {
    object.match(shots(which), output);
  }

  static bool
  isEmpty(const Output& output)
  {
    return countOutcomes(output)[0] < output.outcome.size() / 2;
  }

  static Output
  sentinel()
  {
    Output output;
    output.disparity.width = 42;
    return output;
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {
        {[](Class& o) { o.setXOffset(-1); }, {"-1", "[0, 4095] px"}},
        {[](Class& o) { o.setXOffset(4096); }, {"4096", "[0, 4095] px"}},
        {[](Class& o) { o.setMaxDisparity(7); }, {"7", "[8, 1024] px"}},
        {[](Class& o) { o.setMaxDisparity(1025); }, {"1025", "[8, 1024] px"}},
        {[](Class& o) { o.setRatioFilter(-1); }, {"-1", "[0, 100] percent"}},
        {[](Class& o) { o.setRatioFilter(101); }, {"101", "[0, 100] percent"}},
        {[](Class& o) { o.setPeakFilter(-0.5); }, {"-0.5", "[0, 128] grey levels"}},
        {[](Class& o) { o.setPeakFilter(nan); }, {"nan", "[0, 128] grey levels"}},
        {[](Class& o) { o.setCorrelationThreshold(1.5); }, {"1.5", "[-1, 1]"}},
        {[](Class& o) { o.setCorrelationThreshold(nan); }, {"nan", "[-1, 1]"}},
        {[](Class& o) { o.setLeftRightCheckThreshold(-1); }, {"-1", "[0, 16] px"}},
        {[](Class& o) { o.setLeftRightCheckThreshold(17); }, {"17", "[0, 16] px"}},
        {[](Class& o) { o.setPairAgreement(0); }, {"= 0 ", "[0.1, 16] px"}},
        {[](Class& o) { o.setPairAgreement(nan); }, {"nan", "[0.1, 16] px"}},
        {[](Class& o) { o.setInputRig(syntheticRig(0, 0)); },
         {"baseline_horizontal = 0", " m"}},
        {[](Class& o) { o.setInputRig(syntheticRig(nan, -0.1)); }, {"baseline", "nan"}},
    };
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no rig", [](Class&, Output& output) { Class().match(shots(0), output); }},
            {"no shot",
             [](Class& object, Output& output) {
               object.match(std::vector<TrinocularFrame::ConstPtr>(), output);
             }},
            {"another size",
             [](Class& object, Output& output) {
               auto shot = std::make_shared<TrinocularFrame>(*shots(0)[0]);
               shot->images[1].width /= 2;
               object.match(*shot, output);
             }},
            {"cancelled", [](Class& object, Output& output) {
               object.setProgressCallback(
                   [](double fraction, const std::string&) { return fraction < 0.5; });
               try {
                 run(object, 0, output);
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
    const TrinocularRig& rig = object.getInputRig();
    std::ostringstream words;
    words << "rig " << rig.baseline_horizontal << ' ' << rig.baseline_vertical
          << ", offset " << object.getXOffset() << ", disparities "
          << object.getMaxDisparity() << ", ratio " << object.getRatioFilter()
          << ", peak " << object.getPeakFilter().value_or(-1) << ", correlation "
          << object.getCorrelationThreshold().value_or(-2) << ", check "
          << object.getLeftRightCheck() << ' ' << object.getLeftRightCheckThreshold()
          << ", agreement " << object.getPairAgreement() << ' '
          << object.getRequirePairAgreement() << ", threads "
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
