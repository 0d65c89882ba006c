# Figures of the demo that pages show are those of doc/demo.txt, which the command that prints
# them wrote (sh cmake/bootstrap figures). In text and tables, a comment after the number names
# the figure.
file(STRINGS "${ROOT}/doc/demo.txt" rows)
foreach(row IN LISTS rows)
  if(NOT row MATCHES "^([a-z_]+) ([0-9.,]+)$")
    message(FATAL_ERROR "doc/demo.txt: ${row}: is no name and number")
  endif()
  set(demo_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
endforeach()

set(faults)
set(count 0)
file(GLOB_RECURSE pages "${ROOT}/doc/*.md")
foreach(page IN LISTS pages ITEMS "${ROOT}/README.md")
  file(READ "${page}" text)
  string(REGEX MATCHALL "[0-9][0-9.,]*<!--demo [a-z_]+-->" figures "${text}")
  foreach(figure IN LISTS figures)
    string(REGEX MATCH "^([0-9.,]+)<!--demo ([a-z_]+)-->" figure "${figure}")
    math(EXPR count "${count} + 1")
    if(NOT CMAKE_MATCH_1 STREQUAL "${demo_${CMAKE_MATCH_2}}")
      string(APPEND faults "\n${page}: ${CMAKE_MATCH_2} is ${CMAKE_MATCH_1}, not "
                           "\"${demo_${CMAKE_MATCH_2}}\"")
    endif()
  endforeach()
endforeach()
if(count LESS 8)
  string(APPEND faults "\nonly ${count} figures of the demo were found")
endif()

# What is copied as it is printed.
string(REPLACE "," "" plain "${demo_compactness}")
foreach(printed IN ITEMS "tools/pcl_compact_mapping.md=compactness: ${plain} : 1"
                         "tools/pcl_compact_mapping.md=${demo_ate_after} m after"
                         "paper_figures.md=; ${demo_compactness} : 1"
                         "paper_figures.md=| ${demo_points} |")
  string(REGEX MATCH "^([^=]*)=(.*)$" printed "${printed}")
  file(READ "${ROOT}/doc/${CMAKE_MATCH_1}" text)
  string(FIND "${text}" "${CMAKE_MATCH_2}" place)
  if(place EQUAL -1)
    string(APPEND faults "\ndoc/${CMAKE_MATCH_1} has no \"${CMAKE_MATCH_2}\"")
  endif()
endforeach()
if(faults)
  message(FATAL_ERROR "Figures that the demo does not print:${faults}\n"
                      "sh cmake/bootstrap figures writes them into the pages.")
endif()
message("${count} figures in pages are those of the demo")
