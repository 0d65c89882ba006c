#pragma once

#include <pcl/core/export.h>

namespace pcl::acmap {

/** \brief From now on, the first interruption (SIGINT, SIGTERM, SIGHUP) is only recorded, so
 * that the program can stop cleanly; the second one ends it at once. Signals that the caller
 * ignores, as nohup does, stay ignored. For programs, not for libraries.
 * \code
 * pcl::acmap::noteInterruptions ();
 * mapping.setProgressCallback ([] (double, const std::string&) { return !pcl::acmap::interrupted (); });
 * \endcode
 * \ingroup core */
ACMAP_EXPORT void
noteInterruptions();

/** \brief From now on, an interruption ends the program at once, as usual. */
ACMAP_EXPORT void
obeyInterruptions();

/** \brief Was there an interruption? */
ACMAP_EXPORT bool
interrupted();

/** \brief Forgets an interruption that was obeyed: the next one is only recorded again. */
ACMAP_EXPORT void
forgetInterruption();

/** \throws CancelledException when there was an interruption */
ACMAP_EXPORT void
stopIfInterrupted();

} // namespace pcl::acmap
