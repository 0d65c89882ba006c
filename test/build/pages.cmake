# Checks that every public class and every tool has a page under doc; the page of a
# class with setters must describe each of them, and when to change it. ROOT: the
# repository.
cmake_minimum_required(VERSION 3.25)
file(GLOB classes "${ROOT}/modules/*/include/pcl/*/impl/*.hpp")
file(GLOB tools "${ROOT}/apps/pcl_*.cpp"
     "${ROOT}/test/benchmarks/paper_figures/acmap_*.cpp")
file(GLOB_RECURSE pages "${ROOT}/doc/*.md")
list(TRANSFORM pages REPLACE ".*/" "")
foreach(file IN LISTS classes tools)
  cmake_path(GET file STEM name)
  if(NOT "${name}.md" IN_LIST pages)
    message(SEND_ERROR "${file} has no page ${name}.md under doc")
  endif()
endforeach()

file(GLOB headers RELATIVE "${ROOT}/modules" "${ROOT}/modules/*/include/pcl/*/*.h")
# core has no stages, only shared code, as the base of the classes of mapping
# the store of a chain is on the page of the chain
list(FILTER headers EXCLUDE REGEX "^core/|/posed_clouds\\.h$|/stage_store\\.h$")
foreach(header IN LISTS headers)
  # The return type is on a separate line.
  file(STRINGS "${ROOT}/modules/${header}" setters REGEX "^  set[A-Z][A-Za-z]*\\(")
  if(NOT setters)
    continue()
  endif()
  string(REGEX REPLACE "^([^/]*)/.*/([^/]*)\\.h$" "doc/\\1/\\2.md" page "${header}")
  set(text)
  if(EXISTS "${ROOT}/${page}")
    file(READ "${ROOT}/${page}" text)
  endif()
  string(REGEX MATCHALL "set[A-Z][A-Za-z]*\\(" setters "${setters}")
  list(TRANSFORM setters REPLACE "\\(" "")
  list(REMOVE_DUPLICATES setters)
  foreach(wanted IN ITEMS "\n## Which parameter when\n" LISTS setters)
    string(FIND "${text}" "${wanted}" place)
    if(place EQUAL -1)
      string(STRIP "${wanted}" wanted)
      message(SEND_ERROR "${page} has no ${wanted}")
    endif()
  endforeach()
endforeach()
