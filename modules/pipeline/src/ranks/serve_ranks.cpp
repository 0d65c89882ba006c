#include "chain/chain_stages.h"
#include "ranks/rank_messages.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>

namespace pcl {

namespace acmap {
namespace {

namespace fs = std::filesystem;

std::string
folderOn(const std::string& wanted)
{
  std::error_code error;
  return fs::is_directory(wanted, error) ? wanted
                                         : fs::temp_directory_path(error).string();
}

/** What one rank has of the work. */
class Server {
public:
  explicit Server(Ranks& ranks)
  : ranks_(ranks)
  {}

  void
  run()
  {
    while (true) {
      ByteParcel parcel(ranks_.receive(0));
      const auto request = parcel.take<RankRequest>();
      if (request == RankRequest::End)
        return;
      answer(request, parcel);
    }
  }

private:
  void
  answer(RankRequest request, ByteParcel& parcel)
  {
    try {
      if (request == RankRequest::Begin)
        return begin(parcel);
      if (!begin_fault_.empty())
        throw acmap::IoFault(begin_fault_);
      if (request == RankRequest::BeginPoints)
        return beginPoints(parcel);
      if (request == RankRequest::TakePoints)
        return takePoints(parcel);
      if (request == RankRequest::Merge)
        merge(parcel);
      else if (request == RankRequest::SumCells)
        sum(parcel);
      else
        paint(parcel);
      end(RankAnswer::End);
    }
    catch (const InputFileException& error) {
      end(RankAnswer::InputFault, error.what());
    }
    catch (const std::bad_alloc&) {
      end(RankAnswer::MemoryFault);
    }
    catch (const std::exception& error) {
      fail(request, error.what());
    }
  }

  /** What begins has no answer: its fault is that of the next request. */
  void
  fail(RankRequest request, const std::string& fault)
  {
    const std::string text = "rank " + std::to_string(ranks_.rank()) + ": " + fault;
    if (request == RankRequest::Begin || request == RankRequest::BeginPoints ||
        request == RankRequest::TakePoints)
      begin_fault_ = text;
    else
      end(RankAnswer::Fault, begin_fault_.empty() ? text : begin_fault_);
  }

  void
  end(RankAnswer answer, const std::string& text = {})
  {
    ByteParcel parcel;
    parcel.put(answer);
    if (answer != RankAnswer::End)
      parcel.putText(text);
    ranks_.send(0, parcel.bytes());
  }

  void
  send(const ByteParcel& part)
  {
    ByteParcel parcel;
    parcel.put(RankAnswer::Part);
    parcel.putAll(part.bytes().data(), part.bytes().size());
    ranks_.send(0, parcel.bytes());
  }

  void
  begin(ByteParcel& parcel)
  {
    threads_ = parcel.take<unsigned>();
    const std::string folder = parcel.takeText();
    const auto resident = parcel.take<std::size_t>();
    sequence_.emplace(ObservationSequence::taken(parcel));
    if (!folder.empty())
      scratch_.emplace(folderOn(folder), resident);
  }

  void
  beginPoints(ByteParcel& parcel)
  {
    threads_ = parcel.take<unsigned>();
    viewpoints_.resize(parcel.takeCount<Eigen::Vector3f>());
    for (Eigen::Vector3f& viewpoint : viewpoints_)
      parcel.takeAll(viewpoint.data(), 3);
    taken_.emplace(0, true);
  }

  void
  takePoints(ByteParcel& parcel)
  {
    if (!begin_fault_.empty())
      return;
    std::vector<std::uint8_t> rows(parcel.left());
    parcel.takeAll(rows.data(), rows.size());
    taken_->appendRows(rows, 0);
  }

  void
  merge(ByteParcel& parcel)
  {
    ObservationMerging merging;
    merging.setDepthSensor(parcel.take<DepthSensor>());
    merging.setFrame(takePose(parcel));
    skip_broken_ = parcel.take<bool>();
    merging.setSkipBroken(skip_broken_);
    merging.setNumberOfThreads(threads_);
    const MergedRows merged = merging.mergeShare(*sequence_);
    cloud_ = merged.cloud;
    viewpoints_.clear();
    for (const Eigen::Isometry3d& pose : merged.poses)
      viewpoints_.push_back(pose.translation().cast<float>());
    ByteParcel head;
    head.put(merged.poses.size());
    for (const Eigen::Isometry3d& pose : merged.poses)
      head.putAll(pose.matrix().data(), 16);
    std::vector<std::string> remarks = merged.remarks;
    if (scratch_ && scratch_->getRefused() > 0)
      remarks.push_back(
          "rank " + std::to_string(ranks_.rank()) + ": its disk is full, " +
          std::to_string(scratch_->getRefused()) + " bytes stayed in memory");
    for (const auto& texts : {remarks, merged.of_poses}) {
      head.put(texts.size());
      for (const std::string& text : texts)
        head.putText(text);
    }
    head.put(merged.refined);
    head.put(merged.are_colored);
    head.put(cloud_.size());
    send(head);
    const std::size_t step = cloud_.layout().point_step;
    for (std::size_t i = 0; i < cloud_.size(); i += points_of_part) {
      ByteParcel rows;
      rows.putAll(cloud_.data() + i * step,
                  std::min(points_of_part, cloud_.size() - i) * step);
      send(rows);
    }
  }

  void
  sum(ByteParcel& parcel)
  {
    const auto lattice = parcel.take<VoxelLattice>();
    const auto has_sensors = parcel.take<bool>(), has_colors = parcel.take<bool>();
    const auto first = parcel.take<std::int32_t>();
    if (taken_) {
      cloud_ = taken_->finish();
      taken_.reset();
    }
    if (cloud_.size() == 0)
      return;
    sendCells(requirePoints(cloud_),
              has_sensors ? sensorsOf(cloud_, viewpoints_, Eigen::Vector3f::Zero())
                          : SensorView(),
              has_colors ? colorsOf(cloud_) : ColorView(),
              lattice,
              first,
              threads_,
              [this](const ByteParcel& part) { send(part); });
  }

  void
  paint(ByteParcel& parcel)
  {
    auto settings = parcel.take<TexturingSettings>();
    settings.threads = threads_;
    std::vector<PlanePatch> planes;
    std::vector<CylinderPatch> cylinders;
    takeShapes(parcel, planes, cylinders);
    std::vector<TexturedObservationLoader> loaders;
    for (std::size_t i = 0; i < sequence_->size(); ++i)
      loaders.push_back(
          [this, i] { return loadTextured(*sequence_, i, skip_broken_); });
    sendPainted(planes, cylinders, settings, loaders, [this](const ByteParcel& part) {
      send(part);
    });
  }

  Ranks& ranks_;
  unsigned threads_ = 0;
  bool skip_broken_ = false;
  std::string begin_fault_;
  std::optional<ScratchMemory> scratch_; // before what is in it
  std::optional<ObservationSequence> sequence_;
  std::optional<MapRows> taken_; // points of rank 0, until they are summed
  CloudRows cloud_;
  std::vector<Eigen::Vector3f> viewpoints_;
};

} // namespace
} // namespace acmap

void
serveRanks(Ranks& ranks)
{
  acmap::Server(ranks).run();
}

} // namespace pcl
