#include "entropy_bins_kernel.h"

namespace pcl::acmap {

const EntropyBins entropy_bins_base{fillCells<false>,
                                    fillCells<true>,
                                    forcesOnCells<false>,
                                    forcesOnCells<true>,
                                    smoothAcross,
                                    takeLogarithms,
                                    takeFromLevels,
                                    sumUp,
                                    takeExactLogarithms};

} // namespace pcl::acmap
