#include "egomotion_tables.h"
#include "markdown_row.h"
#include "stereo_matches.h"
#include "timing.h"

#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_poly.h>
#include <pcl/registration/correspondence_rejection_sample_consensus.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

constexpr int rounds = 10;
constexpr std::size_t matches_a_round = 300;

/** Matches in the format of PCL. */
struct GivenMatches {
  test::StereoMatchSettings scene;
  test::StereoMatches made;
  PointCloud<PointXYZ>::Ptr source{new PointCloud<PointXYZ>},
      target{new PointCloud<PointXYZ>};
  Correspondences matches;
};

GivenMatches
givenMatches(std::size_t percent, std::uint64_t seed)
{
  GivenMatches given;
  given.scene.wrong = matches_a_round * percent / 100;
  given.scene.right = matches_a_round - given.scene.wrong;
  given.scene.seed = seed;
  given.made = test::stereoMatches(given.scene);
  for (std::size_t i = 0; i < matches_a_round; ++i) {
    given.source->emplace_back();
    given.source->back().getVector3fMap() = given.made.source[i];
    given.target->emplace_back();
    given.target->back().getVector3fMap() = given.made.target[i];
    given.matches.emplace_back(static_cast<int>(i), static_cast<int>(i), 0.0F);
  }
  return given;
}

/** A named rejection method. */
struct Rejection {
  std::string name;
  std::function<void(const GivenMatches&, Correspondences&)> run;
};

template <typename Rejector>
void
reject(Rejector& rejector, const GivenMatches& given, Correspondences& kept)
{
  rejector.template setInputSource<PointXYZ>(given.source);
  rejector.template setInputTarget<PointXYZ>(given.target);
  rejector.getRemainingCorrespondences(given.matches, kept);
}

Rejection
worstOut(double distortion)
{
  return {"leaving the worst out, D " + std::to_string(distortion).substr(0, 4),
          [=](const GivenMatches& given, Correspondences& kept) {
            registration::CorrespondenceRejectorWorstOut rejector;
            rejector.setMaximumDistortion(distortion);
            reject(rejector, given, kept);
          }};
}

Rejection
polygons(float similarity)
{
  return {"PCL, polygons, similarity " + std::to_string(similarity).substr(0, 4),
          [=](const GivenMatches& given, Correspondences& kept) {
            std::srand(1);
            registration::CorrespondenceRejectorPoly<PointXYZ, PointXYZ> rejector;
            rejector.setSimilarityThreshold(similarity);
            rejector.setInputSource(given.source);
            rejector.setInputTarget(given.target);
            rejector.getRemainingCorrespondences(given.matches, kept);
          }};
}

Rejection
sampleConsensus(double metres)
{
  return {"PCL, RANSAC, " + std::to_string(metres).substr(0, 4) + " m",
          [=](const GivenMatches& given, Correspondences& kept) {
            registration::CorrespondenceRejectorSampleConsensus<PointXYZ> rejector;
            rejector.setInlierThreshold(metres);
            rejector.setInputSource(given.source);
            rejector.setInputTarget(given.target);
            rejector.getRemainingCorrespondences(given.matches, kept);
          }};
}

/** Results over all rounds. */
struct RejectionScore {
  double kept = 0, right = 0, kept_right = 0, seconds = 0;
  double squared_metres = 0, squared_radians = 0;
};

void
score(const Rejection& rejection, const GivenMatches& given, RejectionScore& score)
{
  Correspondences kept;
  score.seconds += measureThread([&] { rejection.run(given, kept); });
  std::vector<std::int32_t> positions;
  for (const Correspondence& match : kept) {
    positions.push_back(match.index_query);
    score.kept_right +=
        given.made.is_right[static_cast<std::size_t>(match.index_query)];
  }
  score.kept += static_cast<double>(kept.size());
  score.right += static_cast<double>(given.scene.right);
  const Eigen::Isometry3d error =
      given.scene.T_target_source.inverse() *
      fitMotion(test::placesAt(given.made.source, positions),
                test::placesAt(given.made.target, positions),
                {},
                MotionModel::Planar,
                MotionSolver::ConjugateGradient)
          .T_target_source;
  score.squared_metres += error.translation().squaredNorm();
  score.squared_radians += std::pow(Eigen::AngleAxisd(error.linear()).angle(), 2);
}

} // namespace

void
printEgomotionRejection()
{
  // peers with their defaults, and with their best settings here
  const std::vector<Rejection> rejections = {worstOut(1.06),
                                             polygons(0.75F),
                                             polygons(0.95F),
                                             sampleConsensus(0.05),
                                             sampleConsensus(0.2)};
  printHead({"wrong, %",
             "method",
             "precision, %",
             "recall, %",
             "Eq. 2 of them: off by, mm",
             "degrees",
             "CPU, ms"});
  for (const std::size_t percent : {10, 30, 50, 60, 70}) {
    for (const Rejection& rejection : rejections) {
      RejectionScore sum;
      for (int round = 1; round <= rounds; ++round)
        score(rejection, givenMatches(percent, static_cast<std::uint64_t>(round)), sum);
      MarkdownRow()
          .count(percent)
          .text(rejection.name)
          .number(100 * sum.kept_right / sum.kept, 1)
          .number(100 * sum.kept_right / sum.right, 1)
          .number(1e3 * std::sqrt(sum.squared_metres / rounds), 1)
          .number(180 / M_PI * std::sqrt(sum.squared_radians / rounds), 3)
          .number(1e3 * sum.seconds / rounds, 3)
          .print();
    }
  }
}

} // namespace pcl::acmap::bench
