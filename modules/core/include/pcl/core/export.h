#pragma once

#include <pcl/core/build_config.h>

/** \brief Exports a symbol of the libraries; all other symbols are hidden.
 *
 * For class templates it is also needed at the explicit instantiation: the template
 * arguments are PCL's types, which are not exported, and would hide an instantiation
 * that is only marked at its class. */
#define ACMAP_EXPORT __attribute__((visibility("default")))
