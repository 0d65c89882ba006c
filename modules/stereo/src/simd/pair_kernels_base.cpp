#include "pair_costs_kernel.h"
#include "pair_paths_kernel.h"
#include "sub_pixel_kernel.h"

namespace pcl::acmap {

const PairKernels pair_kernels_base{correlate,
                                    addProducts,
                                    correlateWindows,
                                    countBits,
                                    follow,
                                    findWinners,
                                    sumAtQuarters,
                                    sumWindow};

} // namespace pcl::acmap
