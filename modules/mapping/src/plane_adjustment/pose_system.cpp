#include "pose_system.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>

namespace pcl::acmap {
namespace {

using Neighbours = std::vector<std::vector<std::size_t>>; ///< ascending, of each pose

Neighbours
neighboursOf(std::size_t poses, const std::vector<PoseSystem::Pair>& pairs)
{
  Neighbours neighbours(poses);
  for (const auto& [a, b] : pairs)
    if (a != b) {
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

/** Row of each pose in an order with little fill. */
std::vector<std::size_t>
placesOf(const Neighbours& neighbours)
{
  const auto size = static_cast<Eigen::Index>(neighbours.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < size; ++i) {
    entries.emplace_back(i, i, 1);
    for (const std::size_t j : neighbours[static_cast<std::size_t>(i)])
      entries.emplace_back(i, static_cast<Eigen::Index>(j), 1);
  }
  Eigen::SparseMatrix<double> pattern(size, size);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern, order);
  std::vector<std::size_t> places(neighbours.size());
  for (Eigen::Index row = 0; row < size; ++row)
    places[static_cast<std::size_t>(order.indices()[row])] =
        static_cast<std::size_t>(row);
  return places;
}

} // namespace

PoseSystem::PoseSystem(std::size_t poses, const std::vector<Pair>& pairs)
: columns_(poses)
{
  const Neighbours neighbours = neighboursOf(poses, pairs);
  place_ = placesOf(neighbours);
  for (std::size_t pose = 0; pose < poses; ++pose)
    for (const std::size_t other : neighbours[pose])
      if (place_[other] > place_[pose])
        columns_[place_[pose]].rows.push_back(place_[other]);
  // A column receives the rows of those columns whose first row it is.
  for (std::size_t j = 0; j < poses; ++j) {
    auto& rows = columns_[j].rows;
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    columns_[j].blocks.resize(rows.size());
    if (!rows.empty()) {
      auto& parent = columns_[rows.front()].rows;
      parent.insert(parent.end(), rows.begin() + 1, rows.end());
    }
  }
  setZero();
}

void
PoseSystem::setZero()
{
  for (Column& column : columns_) {
    column.diagonal.setZero();
    std::fill(column.blocks.begin(), column.blocks.end(), Matrix6::Zero());
  }
}

const Matrix6&
PoseSystem::blockAt(std::size_t row, std::size_t column) const
{
  const Column& found = columns_[column];
  const auto place = std::lower_bound(found.rows.begin(), found.rows.end(), row);
  return found.blocks[static_cast<std::size_t>(place - found.rows.begin())];
}

Matrix6&
PoseSystem::blockAt(std::size_t row, std::size_t column)
{
  return const_cast<Matrix6&>(
      static_cast<const PoseSystem&>(*this).blockAt(row, column));
}

void
PoseSystem::add(std::size_t i, std::size_t j, const Matrix6& block)
{
  const std::size_t row = place_[i], column = place_[j];
  if (row == column)
    columns_[row].diagonal += block;
  else if (row > column)
    blockAt(row, column) += block;
  else
    blockAt(column, row) += block.transpose();
}

void
PoseSystem::damp(double share)
{
  for (Column& column : columns_)
    column.diagonal.diagonal() *= 1 + share;
}

bool
PoseSystem::factorize()
{
  for (Column& column : columns_) {
    const Eigen::LLT<Matrix6> root(column.diagonal);
    if (root.info() != Eigen::Success || !column.diagonal.allFinite())
      return false;
    column.diagonal = root.matrixL();
    const auto lower = column.diagonal.triangularView<Eigen::Lower>();
    for (Matrix6& block : column.blocks)
      block = lower.solve(block.transpose()).transpose().eval();
    for (std::size_t k = 0; k < column.rows.size(); ++k) {
      Column& target = columns_[column.rows[k]];
      const Matrix6 factor = column.blocks[k].transpose();
      target.diagonal.noalias() -= column.blocks[k] * factor;
      std::size_t place = 0;
      for (std::size_t i = k + 1; i < column.rows.size(); ++i) {
        while (target.rows[place] != column.rows[i])
          ++place;
        target.blocks[place].noalias() -= column.blocks[i] * factor;
      }
    }
  }
  return true;
}

std::vector<Vector6>
PoseSystem::solve(const std::vector<Vector6>& right) const
{
  std::vector<Vector6> rows(size());
  for (std::size_t pose = 0; pose < size(); ++pose)
    rows[place_[pose]] = right[pose];
  for (std::size_t j = 0; j < size(); ++j) {
    const Column& column = columns_[j];
    column.diagonal.triangularView<Eigen::Lower>().solveInPlace(rows[j]);
    for (std::size_t k = 0; k < column.rows.size(); ++k)
      rows[column.rows[k]] -= column.blocks[k] * rows[j];
  }
  for (std::size_t j = size(); j-- > 0;) {
    const Column& column = columns_[j];
    for (std::size_t k = 0; k < column.rows.size(); ++k)
      rows[j] -= column.blocks[k].transpose() * rows[column.rows[k]];
    column.diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace(rows[j]);
  }
  std::vector<Vector6> result(size());
  for (std::size_t pose = 0; pose < size(); ++pose)
    result[pose] = rows[place_[pose]];
  return result;
}

void
PoseSystem::invert()
{
  std::vector<Matrix6> factor;
  for (std::size_t j = size(); j-- > 0;) {
    Column& column = columns_[j];
    const Matrix6 root =
        column.diagonal.triangularView<Eigen::Lower>().solve(Matrix6::Identity());
    factor.clear();
    for (const Matrix6& block : column.blocks)
      factor.push_back(block * root); // of the factor with a unit diagonal
    std::fill(column.blocks.begin(), column.blocks.end(), Matrix6::Zero());
    for (std::size_t k = 0; k < column.rows.size(); ++k) {
      const Column& other = columns_[column.rows[k]];
      column.blocks[k].noalias() -= other.diagonal * factor[k];
      std::size_t place = 0;
      for (std::size_t i = k + 1; i < column.rows.size(); ++i) {
        while (other.rows[place] != column.rows[i])
          ++place;
        column.blocks[i].noalias() -= other.blocks[place] * factor[k];
        column.blocks[k].noalias() -= other.blocks[place].transpose() * factor[i];
      }
    }
    column.diagonal.noalias() = root.transpose() * root;
    for (std::size_t k = 0; k < column.rows.size(); ++k)
      column.diagonal.noalias() -= column.blocks[k].transpose() * factor[k];
  }
}

Matrix6
PoseSystem::inverse(std::size_t i, std::size_t j) const
{
  const std::size_t row = place_[i], column = place_[j];
  if (row == column)
    return columns_[row].diagonal;
  return row > column ? blockAt(row, column)
                      : Matrix6(blockAt(column, row).transpose());
}

std::size_t
PoseSystem::fill() const
{
  std::size_t blocks = 0;
  for (const Column& column : columns_)
    blocks += column.rows.size();
  return blocks;
}

} // namespace pcl::acmap
