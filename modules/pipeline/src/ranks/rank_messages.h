#pragma once

#include <pcl/core/impl/byte_parcel.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace pcl::acmap {

/** First byte of a message of rank 0. */
enum class RankRequest : std::uint8_t {
  Begin,
  Merge,
  BeginPoints,
  TakePoints,
  SumCells,
  Paint,
  End
};

/** First byte of an answer: part of it, its end, or why there is none. */
enum class RankAnswer : std::uint8_t { Part, End, InputFault, MemoryFault, Fault };

/** Points of a message that has rows of MapRows. */
inline constexpr std::size_t points_of_part = std::size_t{1} << 18;

/** \return the first observation, or point, of a rank, and that of the next one */
inline std::pair<std::size_t, std::size_t>
shareOf(std::size_t rank, std::size_t ranks, std::size_t all)
{
  return {rank * all / ranks, (rank + 1) * all / ranks};
}

inline Eigen::Isometry3d
takePose(ByteParcel& parcel)
{
  Eigen::Isometry3d pose;
  parcel.takeAll(pose.matrix().data(), 16);
  return pose;
}

} // namespace pcl::acmap
