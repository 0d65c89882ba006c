#include "bench.h"
#include "egomotion_runs.h"
#include "stereo_matches.h"

#include <pcl/correspondence.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_poly.h>
#include <pcl/registration/correspondence_rejection_sample_consensus.h>

#include <cstdlib>
#include <functional>

namespace pcl::acmap::bench {
namespace {

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
