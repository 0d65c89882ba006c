#pragma once

#include <pcl/core/output_folder.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Checks, before any work, that a result could be written there: its ending is
 * known, its folder exists and can be written to, and no input stands in its place.
 * \param[in] path of the result
 * \param[in] endings legal ones, with the dot, lower case
 * \param[in] others files of this run that the result must not replace
 * \throws OutputFileException when the place is unfit
 * \throws UsageError when it is one of the other files */
void
requireWritable(const std::string& path,
                const std::vector<std::string>& endings,
                const std::vector<std::string>& others);

/** \brief Refuses a folder that holds files which new ones would mix with.
 * \param[in] is_ours whether a file of that name is one
 * \throws OutputFileException naming the first */
void
requireNoneIn(const OutputFolder& folder,
              const std::function<bool(const std::string& name)>& is_ours);

/** \brief Refuses a folder that holds parts of a sequence, which new ones would mix with.
 * \param[in] more names that it must not hold either
 * \throws OutputFileException naming what it holds */
void
requireNoSequence(const OutputFolder& folder,
                  const std::vector<std::string>& more = {});

/** \brief Ending of a file name with its dot, in lower case; empty without one. */
std::string
endingOf(const std::string& path);

} // namespace pcl::acmap
