#pragma once

#include <pcl/pipeline/ranks.h>

#include <mpi.h>

namespace pcl {

/** \brief The processes of an MPI communicator as ranks that make one map.
 * \code
 * int provided = 0;
 * MPI_Init_thread (&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
 * const auto ranks = std::make_shared<pcl::MpiRanks> (MPI_COMM_WORLD);
 * pcl::CompactMapping mapping;
 * mapping.setRanks (ranks);
 * pcl::CompactMap map;
 * mapping.compute (map);                               // of rank 0; others get none
 * MPI_Finalize ();
 * \endcode
 * \ingroup mpi */
class ACMAP_EXPORT MpiRanks : public Ranks {
public:
  /** \param[in] communicator of processes on machines of the same kind; MPI must have been
   * initialised with MPI_THREAD_SERIALIZED at least
   * \throws BadArgumentException if it was not */
  explicit MpiRanks(MPI_Comm communicator);

  std::size_t
  rank() const override
  {
    return rank_;
  }

  std::size_t
  size() const override
  {
    return size_;
  }

protected:
  void
  beginSending(std::size_t to, const Bytes& bytes) override;

  bool
  isSent() override;

  bool
  tryReceiving(std::size_t from, Bytes& bytes) override;

private:
  MPI_Comm communicator_;
  std::size_t rank_ = 0;
  std::size_t size_ = 1;
  /** A message that is being received, also if the caller gave up waiting for it. */
  struct Incoming {
    Bytes bytes;
    std::vector<MPI_Request> parts;
  };

  std::vector<MPI_Request> sending_;
  std::vector<Incoming> incoming_; // of each rank
};

} // namespace pcl
