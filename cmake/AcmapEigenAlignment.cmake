# How Eigen aligns memory decides the layout of PCL's points and who frees their memory: PCL,
# acmap and what includes their headers must agree (pcl/core/build_config.h). Sets
# ACMAP_<macro> for each of Eigen's macros that decide it.
set(acmap_eigen_macros EIGEN_MAX_ALIGN_BYTES EIGEN_MAX_STATIC_ALIGN_BYTES
                       EIGEN_MALLOC_ALREADY_ALIGNED)

# acmap_find_eigen_alignment (<result> [<flags>]): the macros' values, as these flags and those
# that PCL's package file tells make them.
function(acmap_find_eigen_alignment result)
  if(DEFINED ${result})
    return()
  endif()
  set(program "#include <Eigen/Core>
#define ACMAP_TEXT_OF(value) #value
#define ACMAP_TEXT(macro) \" \" ACMAP_TEXT_OF (macro)
const char* const text = \"alignment of Eigen:\"")
  foreach(macro IN LISTS acmap_eigen_macros)
    string(APPEND program " ACMAP_TEXT (${macro})")
  endforeach()
  string(APPEND program ";\nint main (int count, char**) { return text[count]; }\n")
  set(file "${PROJECT_BINARY_DIR}/eigen_alignment")
  file(WRITE "${file}.cpp" "${program}")
  set(CMAKE_CXX_FLAGS "${ARGN}")
  set(CMAKE_TRY_COMPILE_CONFIGURATION None)
  try_compile(is_compiled "${PROJECT_BINARY_DIR}" "${file}.cpp" OUTPUT_VARIABLE output
              LINK_LIBRARIES pcl_common Eigen3::Eigen COPY_FILE "${file}.out")
  if(is_compiled)
    file(STRINGS "${file}.out" text REGEX "^alignment of Eigen:")
  endif()
  if(NOT text MATCHES "^alignment of Eigen: ([0-9]+ [0-9]+ [0-9]+)$")
    message(FATAL_ERROR "cannot tell how Eigen aligns memory: ${text}\n${output}")
  endif()
  string(REPLACE " " ";" values "${CMAKE_MATCH_1}")
  set(${result} "${values}" CACHE INTERNAL "${acmap_eigen_macros}")
endfunction()

acmap_find_eigen_alignment(ACMAP_EIGEN_ALIGNMENT_OF_PCL)
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
acmap_find_eigen_alignment(ACMAP_EIGEN_ALIGNMENT
                           "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
foreach(macro value of_pcl IN ZIP_LISTS acmap_eigen_macros ACMAP_EIGEN_ALIGNMENT
                                        ACMAP_EIGEN_ALIGNMENT_OF_PCL)
  set(ACMAP_${macro} ${value})
  if(NOT value EQUAL of_pcl)
    message(WARNING "The compiler's flags change ${macro} from ${of_pcl} to ${value}. PCL must "
                    "have been built with such flags, too, or memory will be corrupted.")
  endif()
endforeach()
