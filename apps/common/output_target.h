#pragma once

#include <pcl/core/impl/file_ending.h>
#include <pcl/core/output_folder.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Checks, before any work, that a result can be written to a path: its
 * extension is known, its folder exists and is writable, and it is not the path of an
 * input.
 * \param[in] path of the result
 * \param[in] endings legal extensions, with the dot, lower case
 * \param[in] others files of this run that the result must not replace
 * \throws OutputFileException when it cannot be written
 * \throws UsageError when it is one of the other files */
void
requireWritable(const std::string& path,
                const std::vector<std::string>& endings,
                const std::vector<std::string>& others);

/** \brief Refuses a folder that holds files with which new ones would mix.
 * \param[in] is_ours returns true for the name of such a file
 * \throws OutputFileException naming the first */
void
requireNoneIn(const OutputFolder& folder,
              const std::function<bool(const std::string& name)>& is_ours);

/** \brief Refuses a folder that holds parts of a sequence, with which new ones would
 * mix.
 * \param[in] more names that it must not hold either
 * \throws OutputFileException naming what it holds */
void
requireNoSequence(const OutputFolder& folder,
                  const std::vector<std::string>& more = {});

} // namespace pcl::acmap
