#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/impl/point_shares.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/ranks.h>
#include <pcl/point_types.h>
#include <pcl/texture/plane_texturing.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief The observations of a map, shared out over Ranks. Each rank reads its own,
 * transforms their points, sums their voxels, and paints with them. Rank 0 joins what the others
 * have done, and does all the rest. Of a cloud that rank 0 has read, the others sum the voxels
 * of a part each. Sums of voxels are integers, and the samples of a texel
 * have one order: the map has the same bytes for any number of ranks.
 *
 * Rank 0 makes one, and the others call \ref serveRanks. \ingroup pipeline */
class ACMAP_EXPORT RankedWork {
public:
  /** \param[in] ranks of which this process is rank 0
   * \param[in] sequence with poses, of files that all ranks can read
   * \param[in] threads of each rank, 0 for all
   * \param[in] scratch_folder for the points of each rank, as of ScratchMemory; a rank that
   * does not have it takes its folder for temporary files; empty: in memory
   * \param[in] resident of the same
   * \throws what Ranks::send does */
  RankedWork(std::shared_ptr<Ranks> ranks,
             const ObservationSequence& sequence,
             unsigned threads,
             const std::string& scratch_folder,
             std::size_t resident);

  /** \brief Shares points out that only this process has, for the sums of their voxels: see
   * \ref shares. The other ranks have theirs in memory, 20 bytes a point.
   * \param[in] ranks of which this process is rank 0
   * \param[in] rows with finite and other points
   * \param[in] viewpoints sensors of a field `view`, or of all points; may be empty
   * \param[in] threads of each rank, 0 for all
   * \throws what Ranks::send does */
  RankedWork(std::shared_ptr<Ranks> ranks,
             const CloudRows& rows,
             const std::vector<Eigen::Vector3f>& viewpoints,
             unsigned threads);

  /** \brief Waits until the other ranks are ready for other work. */
  ~RankedWork();

  RankedWork(const RankedWork&) = delete;

  RankedWork&
  operator=(const RankedWork&) = delete;

  /** \brief Number of observations of rank 0, or of its points, the first ones. */
  std::size_t
  own() const;

  /** \brief Lets the other ranks merge their observations, as \ref ObservationMerging
   * does. */
  void
  startMerging(DepthSensor sensor,
               const Eigen::Isometry3d& T_cloud_map,
               bool skip_broken);

  /** \brief Waits for the next rank that has merged its observations.
   * \return what it has merged, without the points; nothing after the last one
   * \throws what the rank has thrown, such as InputFileException */
  std::optional<acmap::MergedRows>
  nextMerged();

  /** \brief The next rows of that rank, in the layout of MapRows, with its own numbers of
   * observations; none at its end. */
  acmap::ByteParcel::Bytes
  nextRows();

  /** \brief The points of the other ranks, for the merged cloud.
   * \param[in] own number of the points of rank 0 */
  std::shared_ptr<const acmap::PointShares>
  shares(std::size_t own);

  /** \brief Lets the other ranks paint with their observations.
   * \param[in] texturing with surfaces and settings
   * \return false if rank 0 has to paint with all of them: the grey of intensities depends on
   * the observations before */
  bool
  startPainting(const PlaneTexturing<PointXYZRGB>& texturing);

  /** \brief The next part of the answers to the last request, of one rank after the other.
   * \return nothing after the last one
   * \throws what the rank has thrown */
  std::optional<acmap::ByteParcel>
  nextPart();

  const Ranks&
  ranks() const
  {
    return *ranks_;
  }

private:
  void
  request(std::size_t to, acmap::ByteParcel parcel);

  std::optional<acmap::ByteParcel>
  next();

  std::shared_ptr<Ranks> ranks_;
  std::size_t all_;                  ///< observations, or points
  std::size_t current_ = 0;          ///< rank whose messages are next; 0: none
  std::vector<std::size_t> points_;  ///< of each other rank
  std::vector<std::size_t> waiting_; ///< answers that a rank still has to end
  bool are_colored_ = true;
};

namespace acmap {

/** \brief Shares a sequence out over ranks, unless this process works alone.
 * \param[in] ranks may be null
 * \param[out] remarks one more if the observations are not files, so that rank 0 reads and
 * paints alone
 * \return null if there is no other rank, or none for these observations
 * \throws what Ranks::send does; other parameters as of RankedWork */
ACMAP_EXPORT std::shared_ptr<RankedWork>
shareOut(const std::shared_ptr<Ranks>& ranks,
         const ObservationSequence& sequence,
         unsigned threads,
         const std::string& scratch_folder,
         std::size_t resident,
         std::vector<std::string>& remarks);

} // namespace acmap

/** \brief Lets the other ranks return from \ref serveRanks. \ingroup pipeline
 * \throws what Ranks::send does */
ACMAP_EXPORT void
endRanks(Ranks& ranks);

/** \brief Does what rank 0 asks for, until it calls \ref endRanks. \ingroup pipeline
 * \throws what Ranks::receive does */
ACMAP_EXPORT void
serveRanks(Ranks& ranks);

} // namespace pcl
