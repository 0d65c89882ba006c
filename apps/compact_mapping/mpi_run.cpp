#include "compact_mapping/run_ranks.h"

#include <pcl/mpi/mpi_ranks.h>

#include <algorithm>
#include <cstdlib>

namespace pcl::acmap {

namespace {

/** Set by OpenMPI, and by MPICH and its relatives: a run on its own does without the half
 * second that MPI takes to start. */
bool
isStartedByMpi()
{
  constexpr const char* names[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(std::begin(names), std::end(names), [](const char* name) {
    return std::getenv(name) != nullptr;
  });
}

} // namespace

RunRanks::RunRanks(int& argc, char**& argv)
{
  if (!isStartedByMpi())
    return;
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  ranks_ = std::make_shared<MpiRanks>(MPI_COMM_WORLD);
}

RunRanks::~RunRanks()
{
  if (ranks_)
    MPI_Finalize();
}

void
RunRanks::abort(int exit_code) const
{
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::exit(exit_code);
}

} // namespace pcl::acmap
