#pragma once

#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/point_cloud.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::acmap::test {

using StereoCloud = PointCloud<PointXYZRGBSigma>;

/** \brief Content of the PCD of an observation. */
struct StereoFile {
  StereoCloud cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
};

StereoFile
loadStereo(const std::string& path);

/** \brief Comparison of disparities with the truth, over the pixels that all cameras
 * see and the projector lights. */
struct TruthFit {
  double found = 0;  ///< fraction that has a disparity
  double wrong = 0;  ///< fraction of these with an error above 1 px
  double median = 0; ///< px, of the errors of these
};

TruthFit
fitOf(const DisparityImage& disparity, const std::string& session, int observation = 0);

/** \brief Disparities that correspond to a cloud's depths. */
DisparityImage
disparityOf(const StereoCloud& cloud, const TrinocularRig& rig);

/** \brief A slanted wall and a box in front of it, filmed from two positions under six
 * patterns by a small rig; filmed once for all tests. */
class ActiveStereoRuns : public testing::Test {
protected:
  static void
  SetUpTestSuite();

  static void
  TearDownTestSuite();

  /** \brief Runs pcl_active_stereo on the session. */
  ToolRun
  runSession(const std::vector<std::string>& more = {},
             const RunSettings& settings = {}) const;

  /** \brief Runs it on the images of the first observation under a pattern. */
  ToolRun
  runLists(const std::vector<std::string>& more = {},
           const RunSettings& settings = {}) const;

  /** \brief Checks that a run failed with a code and a message, and left no files. */
  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const;

  std::string
  out(const std::string& name) const
  {
    return out_ + "/" + name;
  }

  static std::string
  session()
  {
    return filmed_->path("session");
  }

  static TemporaryFolder* filmed_;
  TemporaryFolder folder_;
  std::string out_ = folder_.path("out");
  std::string input_ = session();
  std::string rig_ = session() + "/rig.yaml";
  std::array<std::vector<std::string>, 3> images_ = listed_; ///< by RigCamera

private:
  static std::array<std::vector<std::string>, 3> listed_;
};

/** \brief Writes the images of a session's first observation: its shots under a
 * pattern, then `off.png`, the reference without one.
 * \return the shots' paths by RigCamera */
std::array<std::vector<std::string>, 3>
writeImages(const std::string& session, const TemporaryFolder& folder);

} // namespace pcl::acmap::test
