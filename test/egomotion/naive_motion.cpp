#include "naive_egomotion.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace pcl::acmap::test {

NaivePairs
pairsOf(const PointCloud<PointXYZRGBSigma>& source,
        const PointCloud<PointXYZRGBSigma>& target,
        const NaiveMatches& matches)
{
  NaivePairs pairs;
  for (const auto& [from, to] : matches) {
    pairs.source.push_back(source[from].getVector3fMap().cast<double>());
    pairs.target.push_back(target[to].getVector3fMap().cast<double>());
  }
  return pairs;
}

double
naiveDistortion(const NaivePairs& pairs, std::size_t match)
{
  double sum = 0;
  for (std::size_t k = 0; k < pairs.source.size(); ++k) {
    const double a = (pairs.source[match] - pairs.source[k]).norm();
    const double b = (pairs.target[match] - pairs.target[k]).norm();
    sum += a == b ? 1 : std::min(std::max(a / b, b / a), 1000.0);
  }
  return sum / static_cast<double>(pairs.source.size());
}

std::vector<std::size_t>
naiveLeaveWorstOut(const NaivePairs& pairs, double max_distortion)
{
  std::vector<std::size_t> left(pairs.source.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  while (!left.empty()) {
    NaivePairs now;
    for (const std::size_t i : left) {
      now.source.push_back(pairs.source[i]);
      now.target.push_back(pairs.target[i]);
    }
    std::vector<double> distortions;
    for (std::size_t i = 0; i < left.size(); ++i)
      distortions.push_back(naiveDistortion(now, i));
    const auto worst = std::max_element(distortions.begin(), distortions.end());
    if (*worst <= max_distortion)
      break;
    left.erase(left.begin() + (worst - distortions.begin()));
  }
  return left;
}

// On the floor a rotation by theta about y multiplies x + i z by exp (-i theta).
Eigen::Vector3d
naiveAction(const NaivePairs& pairs)
{
  using Complex = std::complex<double>;
  const auto mean = [](const std::vector<Eigen::Vector3d>& places) {
    Complex sum;
    for (const Eigen::Vector3d& place : places)
      sum += Complex(place.x(), place.z());
    return sum / static_cast<double>(places.size());
  };
  const Complex from = mean(pairs.source), to = mean(pairs.target);
  Complex product;
  for (std::size_t i = 0; i < pairs.source.size(); ++i)
    product += std::conj(Complex(pairs.source[i].x(), pairs.source[i].z()) - from) *
               (Complex(pairs.target[i].x(), pairs.target[i].z()) - to);
  const Complex shift = to - product / std::abs(product) * from;
  return {shift.real(), shift.imag(), -std::arg(product)};
}

Eigen::Matrix3d
naiveCovariance(const NaivePairs& pairs, const Eigen::Vector3d& action)
{
  const double c = std::cos(action[2]), s = std::sin(action[2]);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < pairs.source.size(); ++i) {
    const Eigen::Vector3d& place = pairs.source[i];
    const Eigen::Vector3d moved(c * place.x() + s * place.z() + action[0],
                                place.y(),
                                c * place.z() - s * place.x() + action[1]);
    Eigen::Matrix3d jacobian; // of x, y, z by the motions along x, z and about y
    jacobian << 1, 0, moved.z(), 0, 0, 0, 0, 1, -moved.x();
    information += jacobian.transpose() * jacobian;
    squares += (moved - pairs.target[i]).squaredNorm();
  }
  const double freedoms = 3 * static_cast<double>(pairs.source.size()) - 3;
  return squares / freedoms * information.inverse();
}

} // namespace pcl::acmap::test
