#include "ranks/rank_messages.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <new>
#include <utility>

namespace pcl {

using acmap::ByteParcel;
using acmap::RankAnswer;
using acmap::RankRequest;

namespace {

ByteParcel
parcelOf(RankRequest request)
{
  ByteParcel parcel;
  parcel.put(request);
  return parcel;
}

[[noreturn]] void
throwFault(RankAnswer answer, ByteParcel& parcel)
{
  const std::string text = parcel.takeText();
  switch (answer) {
  case RankAnswer::InputFault:
    throw InputFileException(text);
  case RankAnswer::MemoryFault:
    throw std::bad_alloc();
  default:
    throw acmap::IoFault(text);
  }
}

} // namespace

RankedWork::RankedWork(std::shared_ptr<Ranks> ranks,
                       const ObservationSequence& sequence,
                       unsigned threads,
                       const std::string& scratch_folder,
                       std::size_t resident)
: ranks_(std::move(ranks))
, all_(sequence.size())
, points_(ranks_->size(), 0)
, waiting_(ranks_->size(), 0)
{
  for (std::size_t rank = 1; rank < ranks_->size(); ++rank) {
    ByteParcel parcel = parcelOf(RankRequest::Begin);
    parcel.put(threads);
    parcel.putText(scratch_folder);
    parcel.put(resident);
    const auto [begin, end] = acmap::shareOf(rank, ranks_->size(), all_);
    sequence.put(begin, end, parcel);
    ranks_->send(rank, parcel.bytes());
  }
}

RankedWork::RankedWork(std::shared_ptr<Ranks> ranks,
                       const CloudRows& rows,
                       const std::vector<Eigen::Vector3f>& viewpoints,
                       unsigned threads)
: ranks_(std::move(ranks))
, all_(rows.size())
, points_(ranks_->size(), 0)
, waiting_(ranks_->size(), 0)
{
  for (std::size_t rank = 1; rank < ranks_->size(); ++rank) {
    ByteParcel parcel = parcelOf(RankRequest::BeginPoints);
    parcel.put(threads);
    parcel.put(viewpoints.size());
    for (const Eigen::Vector3f& viewpoint : viewpoints)
      parcel.putAll(viewpoint.data(), 3);
    ranks_->send(rank, parcel.bytes());
    const auto [begin, end] = acmap::shareOf(rank, ranks_->size(), all_);
    points_[rank] = end - begin;
    for (std::size_t i = begin; i < end; i += acmap::points_of_part) {
      ByteParcel part = parcelOf(RankRequest::TakePoints);
      acmap::putMapRows(rows, i, std::min(i + acmap::points_of_part, end), part);
      ranks_->send(rank, part.bytes());
    }
  }
}

/** A rank may wait until the rest of its answer is received. */
RankedWork::~RankedWork()
{
  try {
    for (std::size_t rank = 1; rank < ranks_->size(); ++rank)
      while (waiting_[rank] > 0)
        if (ByteParcel(ranks_->receive(rank)).take<RankAnswer>() != RankAnswer::Part)
          --waiting_[rank];
  }
  catch (const std::exception&) { // this process was interrupted
    return;
  }
}

void
endRanks(Ranks& ranks)
{
  for (std::size_t rank = 1; rank < ranks.size(); ++rank)
    ranks.send(rank, parcelOf(RankRequest::End).bytes());
}

std::size_t
RankedWork::own() const
{
  return acmap::shareOf(0, ranks_->size(), all_).second;
}

void
RankedWork::request(std::size_t to, ByteParcel parcel)
{
  ranks_->send(to, parcel.bytes());
  ++waiting_[to];
}

/** Returns the next part of the answer of the current rank, nothing at its end. */
std::optional<ByteParcel>
RankedWork::next()
{
  ByteParcel parcel(ranks_->receive(current_));
  const auto answer = parcel.take<RankAnswer>();
  if (answer == RankAnswer::Part)
    return parcel;
  --waiting_[current_];
  if (answer != RankAnswer::End)
    throwFault(answer, parcel);
  return std::nullopt;
}

void
RankedWork::startMerging(DepthSensor sensor,
                         const Eigen::Isometry3d& T_cloud_map,
                         bool skip_broken)
{
  for (std::size_t rank = 1; rank < ranks_->size(); ++rank) {
    ByteParcel parcel = parcelOf(RankRequest::Merge);
    parcel.put(sensor);
    parcel.putAll(T_cloud_map.matrix().data(), 16);
    parcel.put(skip_broken);
    request(rank, std::move(parcel));
  }
  current_ = 0;
}

std::optional<acmap::MergedRows>
RankedWork::nextMerged()
{
  if (++current_ >= ranks_->size())
    return std::nullopt;
  std::optional<ByteParcel> parcel = next();
  if (!parcel)
    throw acmap::IoFault("a process has merged nothing");
  acmap::MergedRows merged;
  for (auto poses = parcel->take<std::size_t>(); poses > 0; --poses)
    merged.poses.push_back(takePose(*parcel));
  for (auto* const texts : {&merged.remarks, &merged.of_poses})
    for (auto left = parcel->take<std::size_t>(); left > 0; --left)
      texts->push_back(parcel->takeText());
  merged.refined = parcel->take<std::size_t>();
  merged.are_colored = parcel->take<bool>();
  points_[current_] = parcel->take<std::size_t>();
  are_colored_ = are_colored_ && merged.are_colored;
  return merged;
}

ByteParcel::Bytes
RankedWork::nextRows()
{
  std::optional<ByteParcel> parcel = next();
  ByteParcel::Bytes rows;
  if (parcel) {
    rows.resize(parcel->left());
    parcel->takeAll(rows.data(), rows.size());
  }
  return rows;
}

std::shared_ptr<const acmap::PointShares>
RankedWork::shares(std::size_t own)
{
  const auto shares = std::make_shared<acmap::PointShares>();
  shares->own = own;
  shares->request = [this, own](const acmap::VoxelLattice& lattice,
                                bool has_sensors,
                                bool has_colors) {
    std::size_t first = own;
    for (std::size_t rank = 1; rank < ranks_->size(); ++rank) {
      ByteParcel parcel = parcelOf(RankRequest::SumCells);
      parcel.put(lattice);
      parcel.put(has_sensors);
      parcel.put(has_colors);
      parcel.put(static_cast<std::int32_t>(first));
      request(rank, std::move(parcel));
      first += points_[rank];
    }
    current_ = 1;
  };
  shares->receive = [this] { return nextPart(); };
  return shares;
}

bool
RankedWork::startPainting(const PlaneTexturing<PointXYZRGB>& texturing)
{
  if (!are_colored_)
    return false;
  ByteParcel parcel = parcelOf(RankRequest::Paint);
  parcel.put(texturing.settings());
  acmap::putShapes(texturing.getPlanes(), texturing.getCylinders(), parcel);
  for (std::size_t rank = 1; rank < ranks_->size(); ++rank)
    request(rank, parcel);
  current_ = 1;
  return true;
}

std::optional<ByteParcel>
RankedWork::nextPart()
{
  for (; current_ < ranks_->size(); ++current_)
    if (std::optional<ByteParcel> parcel = next())
      return parcel;
  return std::nullopt;
}

namespace acmap {

std::shared_ptr<RankedWork>
shareOut(const std::shared_ptr<Ranks>& ranks,
         const ObservationSequence& sequence,
         unsigned threads,
         const std::string& scratch_folder,
         std::size_t resident,
         std::vector<std::string>& remarks)
{
  if (!ranks || ranks->size() == 1)
    return nullptr;
  if (sequence.areFiles())
    return std::make_shared<RankedWork>(
        ranks, sequence, threads, scratch_folder, resident);
  remarks.emplace_back("rank 0 reads and paints alone: the observations are not files");
  return nullptr;
}

} // namespace acmap
} // namespace pcl
