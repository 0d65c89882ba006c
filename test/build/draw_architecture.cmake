# Draws the modules and what they depend on, as their CMakeLists.txt declare it:
#   cmake -P test/build/draw_architecture.cmake
# writes doc/pictures/architecture.svg; with -DCOMPARE=ON it compares it instead.
cmake_minimum_required(VERSION 3.25)
cmake_path(SET root NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../..")
set(picture "${root}doc/pictures/architecture.svg")

file(GLOB lists RELATIVE "${root}modules" "${root}modules/*/CMakeLists.txt")
list(TRANSFORM lists REPLACE "/.*" "" OUTPUT_VARIABLE modules)
foreach(module IN LISTS modules)
  file(READ "${root}modules/${module}/CMakeLists.txt" text)
  set(depends_${module})
  if(text MATCHES "\n  DEPENDS ([a-z \n]+)")
    string(REGEX REPLACE "[ \n]+" ";" depends_${module} "${CMAKE_MATCH_1}")
    list(REMOVE_ITEM depends_${module} "")
  endif()
endforeach()

# A module is in the row above the highest one that it depends on.
set(rows)
set(placed)
set(row 0)
set(above ${modules})
while(above)
  set(row_${row})
  foreach(module IN LISTS above)
    set(waits ${depends_${module}})
    list(REMOVE_ITEM waits "" ${placed})
    if(NOT waits)
      list(APPEND row_${row} ${module})
    endif()
  endforeach()
  list(REMOVE_ITEM above ${row_${row}})
  list(APPEND placed ${row_${row}})
  list(PREPEND rows ${row})
  math(EXPR row "${row} + 1")
endwhile()
# Those that a higher row uses are side by side.
foreach(module IN LISTS row_2)
  set(used ${depends_${module}})
  list(REMOVE_ITEM used ${row_0})
  list(REMOVE_ITEM row_1 ${used})
  list(PREPEND row_1 ${used})
endforeach()

set(box_width 88)
set(box_height 30)
set(gap 8)
set(row_height 90)
list(LENGTH row_1 count)
math(EXPR width "${count} * (${box_width} + ${gap}) + ${gap}")
math(EXPR height "${row} * ${row_height} + ${row_height}")
math(EXPR band_width "${width} - 2 * ${gap}")

# box (<x> <y> <width> <text>)
set(boxes)
function(box x y w text)
  math(EXPR middle "${x} + ${w} / 2")
  math(EXPR base "${y} + 20")
  string(APPEND boxes "  <rect x=\"${x}\" y=\"${y}\" width=\"${w}\" height=\"${box_height}\" rx=\"4\"/>\n"
         "  <text x=\"${middle}\" y=\"${base}\">${text}</text>\n")
  set(boxes "${boxes}" PARENT_SCOPE)
endfunction()

box(${gap} 20 ${band_width} "apps, python, examples, benchmarks: may use every module")
set(y 20)
foreach(row IN LISTS rows)
  math(EXPR y "${y} + ${row_height}")
  list(LENGTH row_${row} count)
  math(EXPR x "(${width} - ${count} * (${box_width} + ${gap}) + ${gap}) / 2")
  foreach(module IN LISTS row_${row})
    set(x_${module} ${x})
    set(y_${module} ${y})
    box(${x} ${y} ${box_width} ${module})
    math(EXPR x "${x} + ${box_width} + ${gap}")
  endforeach()
endforeach()

# What a module depends on through another one has no line.
set(lines)
foreach(module IN LISTS modules)
  set(direct ${depends_${module}})
  foreach(depend IN LISTS depends_${module})
    if(depends_${depend})
      list(REMOVE_ITEM direct ${depends_${depend}})
    endif()
  endforeach()
  foreach(depend IN LISTS direct)
    math(EXPR from_x "${x_${module}} + ${box_width} / 2")
    math(EXPR from_y "${y_${module}} + ${box_height}")
    math(EXPR to_x "${x_${depend}} + ${box_width} / 2")
    string(APPEND lines "  <line x1=\"${from_x}\" y1=\"${from_y}\" x2=\"${to_x}\" y2=\"${y_${depend}}\"/>\n")
  endforeach()
endforeach()

set(svg "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${width}\" height=\"${height}\" font-family=\"sans-serif\" font-size=\"12\" text-anchor=\"middle\">
<rect width=\"100%\" height=\"100%\" fill=\"white\"/>
<g stroke=\"#8090a0\">
${lines}</g>
<g fill=\"#eef2f6\" stroke=\"#405060\">
${boxes}</g>
</svg>
")
string(REPLACE "<text" "<text fill=\"black\" stroke=\"none\"" svg "${svg}")
if(NOT COMPARE)
  file(WRITE "${picture}" "${svg}")
  return()
endif()
file(READ "${picture}" stored)
if(NOT stored STREQUAL svg)
  message(FATAL_ERROR "doc/pictures/architecture.svg is not what the modules declare; "
                      "cmake -P test/build/draw_architecture.cmake draws it anew")
endif()
