#pragma once

#include <pcl/pipeline/ranks.h>

#include <memory>

namespace pcl::acmap {

/** \brief The processes that mpirun has started, of which this is one; MPI lasts as long as
 * this object. */
class RunRanks {
public:
  /** \brief There are none unless mpirun has started this process, and acmap was built with
   * MPI. */
  RunRanks(int& argc, char**& argv);

  ~RunRanks();

  RunRanks(const RunRanks&) = delete;

  RunRanks&
  operator=(const RunRanks&) = delete;

  const std::shared_ptr<Ranks>&
  get() const
  {
    return ranks_;
  }

  /** \brief Ends all processes: the others may wait for this one. */
  [[noreturn]] void
  abort(int exit_code) const;

private:
  std::shared_ptr<Ranks> ranks_;
};

} // namespace pcl::acmap
