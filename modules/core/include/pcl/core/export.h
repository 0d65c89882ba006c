#pragma once

/** \brief Marks what users of the libraries may link to; all else is hidden.
 *
 * Class templates carry it at their explicit instantiation: the template arguments are
 * PCL's unmarked types, which would hide an instantiation marked in its class alone. */
#define ACMAP_EXPORT __attribute__((visibility("default")))
