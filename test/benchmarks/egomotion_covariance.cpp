#include "egomotion_input.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "statistics.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace pcl::acmap::bench {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

double
mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

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

/** Chains of \a links neighbouring motions, one after another. */
Consistency
ofChains(const EgomotionSequence& sequence, const Motions& motions, std::size_t links)
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
  MarkdownRow()
      .text(sequence.name)
      .text(what)
      .count(found.all.size())
      .number(mean(found.all), 2)
      .number(median(found.all), 2)
      .number(mean(found.place), 2)
      .number(mean(found.turn), 2)
      .print();
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
      for (const std::size_t links : {5, 15})
        printRow(sequence,
                 "chains of " + std::to_string(links),
                 ofChains(sequence, motions, links));
  }
}

} // namespace

void
printEgomotionCovariance()
{
  printHead({"session",
             "motions",
             "number",
             "NEES, mean",
             "median",
             "place, mean",
             "turn, mean"});
  for (const char* scene : {"corridor_drive", "l_corridor_drive"})
    for (const double grain : {2.0, 12.0})
      printSequence(driveThrough(scene, grain));
  if (const auto kitchen = loadKitchen())
    printSequence(*kitchen);
}

} // namespace pcl::acmap::bench
