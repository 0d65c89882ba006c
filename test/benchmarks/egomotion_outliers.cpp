#include "bench.h"
#include "egomotion_runs.h"
#include "stereo_matches.h"

#include <pcl/common/io.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/random.h>
#include <pcl/correspondence.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_poly.h>
#include <pcl/registration/correspondence_rejection_sample_consensus.h>
#include <pcl/types.h>

#include <cstdlib>
#include <functional>

namespace pcl::acmap::bench {
namespace {

/** \brief Two views with matches between their keypoints. */
struct MatchedPair {
  PointCloud<PointXYZRGB>::ConstPtr source, target;
  IndicesPtr target_keypoints;
  Correspondences matches;
  Eigen::Isometry3d truth; ///< T_target_source
};

/** \brief Matches of which a fraction leads to random keypoints, and the other ones
 * alone. */
struct SpoiltMatches {
  Correspondences all, right;
};

using Point = PointXYZRGB;
using Cloud = PointCloud<Point>;

IndicesPtr
keypointsOf(const Cloud::ConstPtr& cloud)
{
  GradientMaximumKeypoint<Point> detector;
  detector.setInputCloud(cloud);
  Cloud keypoints;
  detector.compute(keypoints);
  return std::make_shared<Indices>(detector.getKeypointsIndices()->indices);
}

Cloud::Ptr
withoutSigma(const EgomotionCloud& seen)
{
  const auto cloud = std::make_shared<Cloud>();
  copyPointCloud(seen, *cloud);
  return cloud;
}

/** \brief Matches neighbouring views with the public classes.
 * \param[in] target the earlier one of both views */
MatchedPair
matchedPair(const EgomotionSequence& sequence, std::size_t target)
{
  const Cloud::ConstPtr before = withoutSigma(*sequence.clouds[target]);
  MatchedPair pair{withoutSigma(*sequence.clouds[target + 1]),
                   before,
                   keypointsOf(before),
                   {},
                   sequence.truth[target].inverse() * sequence.truth[target + 1]};
  registration::CorrespondenceEstimationLogPolar<Point> matcher;
  matcher.setMinimumContrast(1.5F); // grey levels: the grain of the walls is weak
  matcher.setInputSource(pair.source);
  matcher.setIndicesSource(keypointsOf(pair.source));
  matcher.setInputTarget(pair.target);
  matcher.setIndicesTarget(pair.target_keypoints);
  matcher.determineCorrespondences(pair.matches, 1.5); // metres
  return pair;
}

/** \brief Replaces a fraction of a pair's matches by wrong ones. */
SpoiltMatches
spoilt(const MatchedPair& pair, double share, Random& random)
{
  const auto drawn = [&random](std::size_t count) {
    return std::min(
        count - 1,
        static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
  };
  SpoiltMatches matches{pair.matches, pair.matches};
  const auto wrong =
      static_cast<std::size_t>(share * static_cast<double>(pair.matches.size()));
  for (std::size_t i = 0; i < wrong;
       ++i) // partial shuffle; the first ones become wrong
    std::swap(matches.right[i], matches.right[i + drawn(matches.right.size() - i)]);
  matches.all = matches.right;
  matches.right.erase(matches.right.begin(),
                      matches.right.begin() + static_cast<std::ptrdiff_t>(wrong));
  for (std::size_t i = 0; i < wrong; ++i)
    matches.all[i].index_match =
        (*pair.target_keypoints)[drawn(pair.target_keypoints->size())];
  return matches;
}

/** Result for some matches. */
struct PlanarResult {
  std::size_t kept = 0;
  PlanarAction action;
};

/** Accounts for noise along the ray, which grows with the square of the depth. */
double
weightOf(const Point& now, const Point& before)
{
  return 1 / (std::pow(now.z, 4) + std::pow(before.z, 4));
}

PlanarResult
planarMotion(const MatchedPair& pair, const Correspondences& matches)
{
  registration::CorrespondenceRejectorWorstOut rejector;
  rejector.setInputSource<Point>(pair.source);
  rejector.setInputTarget<Point>(pair.target);
  Correspondences kept;
  rejector.getRemainingCorrespondences(matches, kept);
  if (kept.empty())
    return {};
  std::vector<double> weights;
  for (const Correspondence& match : kept)
    weights.push_back(
        weightOf((*pair.source)[match.index_query], (*pair.target)[match.index_match]));
  registration::TransformationEstimationPlanar<Point, Point> estimation;
  estimation.setCorrespondenceWeights(weights);
  Eigen::Matrix4f motion;
  estimation.estimateRigidTransformation(*pair.source, *pair.target, kept, motion);
  const PlanarPose pose = planarPartOf(Eigen::Isometry3d(motion.cast<double>()));
  return {kept.size(), {pose.x, pose.z, pose.theta}};
}

Eigen::Vector3d
vectorOf(const PlanarAction& action)
{
  return {action.dx, action.dz, std::remainder(action.dtheta, 2 * M_PI)};
}

/** Root mean square of each component. */
Eigen::Vector3d
rmsOf(const std::vector<Eigen::Vector3d>& differences)
{
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& difference : differences)
    squares += difference.cwiseAbs2();
  return (squares / static_cast<double>(differences.size())).cwiseSqrt();
}

Eigen::Vector3d
foundAction(const MatchedPair& pair, const Correspondences& matches)
{
  return vectorOf(planarMotion(pair, matches).action);
}

Eigen::Vector3d
trueAction(const MatchedPair& pair)
{
  const PlanarPose truth = planarPartOf(pair.truth);
  return vectorOf({truth.x, truth.z, truth.theta});
}

/** \param[in] clean actions from all matches, without wrong ones
 * \param[in] noise standard deviations of their dx, dz (metres), dtheta (rad) */
void
printShare(const std::vector<MatchedPair>& pairs,
           const std::vector<Eigen::Vector3d>& clean,
           const Eigen::Vector3d& noise,
           double share)
{
  Random random(1);
  std::vector<Eigen::Vector3d> changes, losses, errors;
  std::vector<double> kept;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SpoiltMatches matches = spoilt(pairs[i], share, random);
    const PlanarResult found = planarMotion(pairs[i], matches.all);
    refused += found.kept == 0 ? 1 : 0;
    if (found.kept == 0)
      continue;
    kept.push_back(static_cast<double>(found.kept));
    const Eigen::Vector3d action = vectorOf(found.action);
    const Eigen::Vector3d without = foundAction(pairs[i], matches.right);
    changes.push_back((action - without).cwiseQuotient(noise));
    losses.push_back((without - clean[i]).cwiseQuotient(noise));
    errors.push_back(action - trueAction(pairs[i]));
  }
  const Eigen::Vector3d change = rmsOf(changes), error = rmsOf(errors);
  Row() << figure(100 * share, 0) << pairs.size() << refused << figure(median(kept), 0)
        << atMost(change.x(), 1, 2) << atMost(change.y(), 1, 2)
        << atMost(change.z(), 1, 2) << figure(rmsOf(losses).norm() / std::sqrt(3), 2)
        << figure(centi * error.head<2>().norm(), 2) << figure(error.z() / degree, 3);
}

const Section outliers_section("outliers", [] {
  constexpr double grain = 6;
  const EgomotionSequence sequence = driveThrough("corridor_drive", grain);
  std::vector<MatchedPair> pairs;
  for (std::size_t i = 0; i + 1 < sequence.clouds.size(); ++i)
    pairs.push_back(matchedPair(sequence, i));
  std::vector<Eigen::Vector3d> clean, off;
  for (const MatchedPair& pair : pairs) {
    clean.push_back(foundAction(pair, pair.matches));
    off.push_back(clean.back() - trueAction(pair));
  }
  printHead("matches replaced, % | pairs | without a motion | matches kept, median | "
            "change by the wrong ones: of dx, rms, in its noise | of dz | of dtheta | "
            "change by the loss of right ones, all three | error of the place, rms, cm "
            "| of the heading, degrees");
  for (const double share : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5})
    printShare(pairs, clean, rmsOf(off), share);
});

constexpr std::uint64_t draws = 10;
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

const Section rejection_section("rejection", [] {
  // peers with their defaults, and with their best settings here
  const std::vector<Rejection> rejections = {worstOut(1.06),
                                             polygons(0.75F),
                                             polygons(0.95F),
                                             sampleConsensus(0.05),
                                             sampleConsensus(0.2)};
  printHead("wrong, % | method | precision, % | recall, % | Eq. 2 of them: off by, mm "
            "| degrees | CPU, ms");
  for (const std::size_t percent : {10, 30, 50, 60, 70}) {
    for (const Rejection& rejection : rejections) {
      RejectionScore sum;
      for (std::uint64_t seed = 1; seed <= draws; ++seed)
        score(rejection, givenMatches(percent, seed), sum);
      Row() << percent << rejection.name << figure(100 * sum.kept_right / sum.kept, 1)
            << figure(100 * sum.kept_right / sum.right, 1)
            << figure(milli * std::sqrt(sum.squared_metres / draws), 1)
            << figure(std::sqrt(sum.squared_radians / draws) / degree, 3)
            << figure(milli * sum.seconds / draws, 3);
    }
  }
});

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/** A motion with its covariance, as EgomotionEstimate; nothing if it failed. */
using Motions = std::vector<std::optional<EgomotionEstimate>>;

/** Of views i and i + step. */
Motions
motionsOf(const EgomotionSequence& sequence, std::size_t step)
{
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setNumberOfThreads(1);
  egomotion.setMotionModel(sequence.is_planar ? MotionModel::Planar
                                              : MotionModel::Rigid);
  Motions motions;
  for (std::size_t i = 0; i + step < sequence.clouds.size(); ++i) {
    egomotion.setInputSource(sequence.clouds[i + step]);
    egomotion.setInputTarget(sequence.clouds[i]);
    motions.push_back(egomotion.compute());
  }
  return motions;
}

/** The components that a motion model estimates. */
std::vector<int>
freedomsOf(const EgomotionSequence& sequence)
{
  return sequence.is_planar ? std::vector<int>{0, 2, 4}
                            : std::vector<int>{0, 1, 2, 3, 4, 5};
}

/** Squared error in units of its covariance, and the same of one group of components. */
double
normalizedSquare(const Vector6& error,
                 const Matrix6& covariance,
                 const std::vector<int>& components)
{
  const auto size = static_cast<Eigen::Index>(components.size());
  Eigen::VectorXd part(size);
  Eigen::MatrixXd block(size, size);
  for (Eigen::Index a = 0; a < size; ++a) {
    part[a] = error[components[a]];
    for (Eigen::Index b = 0; b < size; ++b)
      block(a, b) = covariance(components[a], components[b]);
  }
  return part.dot(block.ldlt().solve(part));
}

/** The small motion from the estimate to the truth, in the target's frame. */
Vector6
errorOf(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth)
{
  const Eigen::Isometry3d change = truth * found.inverse();
  const Eigen::AngleAxisd turn(change.linear());
  Vector6 error;
  error << change.translation(), turn.angle() * turn.axis();
  return error;
}

/** Transforms a small motion to another frame. */
Matrix6
adjoint(const Eigen::Isometry3d& T)
{
  Eigen::Matrix3d cross;
  const Eigen::Vector3d& p = T.translation();
  cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  Matrix6 matrix = Matrix6::Zero();
  matrix.topLeftCorner<3, 3>() = T.linear();
  matrix.topRightCorner<3, 3>() = cross * T.linear();
  matrix.bottomRightCorner<3, 3>() = T.linear();
  return matrix;
}

constexpr std::size_t links = 15; // of a chain

/** NEES divided by its number of components: 1 on average if the covariances hold. */
struct Consistency {
  std::vector<double> all, place, turn;

  void
  add(const Vector6& error, const Matrix6& covariance, const std::vector<int>& freedoms)
  {
    std::vector<int> places, turns;
    for (const int component : freedoms)
      (component < 3 ? places : turns).push_back(component);
    const auto ratio = [&](const std::vector<int>& some) {
      return normalizedSquare(error, covariance, some) /
             static_cast<double>(some.size());
    };
    all.push_back(ratio(freedoms));
    place.push_back(ratio(places));
    turn.push_back(ratio(turns));
  }
};

/** Chains of neighbouring motions, one after another. */
Consistency
ofChains(const EgomotionSequence& sequence, const Motions& motions)
{
  Consistency consistency;
  for (std::size_t begin = 0; begin + links <= motions.size(); begin += links) {
    Eigen::Isometry3d chain = Eigen::Isometry3d::Identity();
    Matrix6 covariance = Matrix6::Zero();
    bool is_complete = true;
    for (std::size_t i = begin; i < begin + links; ++i) {
      is_complete = is_complete && motions[i].has_value();
      if (!is_complete)
        break;
      const Matrix6 to_first = adjoint(chain);
      covariance += to_first * motions[i]->covariance * to_first.transpose();
      chain = chain * motions[i]->T_target_source;
    }
    if (is_complete)
      consistency.add(
          errorOf(chain,
                  sequence.truth[begin].inverse() * sequence.truth[begin + links]),
          covariance,
          freedomsOf(sequence));
  }
  return consistency;
}

Consistency
ofPairs(const EgomotionSequence& sequence, const Motions& motions, std::size_t step)
{
  Consistency consistency;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (motions[i])
      consistency.add(errorOf(motions[i]->T_target_source,
                              sequence.truth[i].inverse() * sequence.truth[i + step]),
                      motions[i]->covariance,
                      freedomsOf(sequence));
  return consistency;
}

void
printRow(const EgomotionSequence& sequence,
         const std::string& what,
         const Consistency& found)
{
  Row() << sequence.name << what << found.all.size() << figure(meanOf(found.all), 2)
        << figure(median(found.all), 2) << figure(meanOf(found.place), 2)
        << figure(meanOf(found.turn), 2);
}

void
printSequence(const EgomotionSequence& sequence)
{
  for (const std::size_t step : {1, 3}) {
    const Motions motions = motionsOf(sequence, step);
    printRow(sequence,
             step == 1 ? "neighbours" : "three apart",
             ofPairs(sequence, motions, step));
    if (step == 1)
      printRow(
          sequence, "chains of " + std::to_string(links), ofChains(sequence, motions));
  }
}

const Section covariance_section("covariance", [] {
  printHead(
      "session | motions | number | NEES, mean | median | place, mean | turn, mean");
  for (const char* scene : {"corridor_drive", "l_corridor_drive"})
    for (const double grain : {2.0, 12.0})
      printSequence(driveThrough(scene, grain));
  if (const auto kitchen = loadKitchen())
    printSequence(*kitchen);
});

} // namespace
} // namespace pcl::acmap::bench
