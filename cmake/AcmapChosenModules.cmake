# Sets acmap_chosen_modules: those of ACMAP_MODULES and what they depend on, each after its
# dependencies; all if ACMAP_MODULES is empty.
set(acmap_all_modules core egomotion mapping acquisition simulation stereo filters surface
                      features segmentation texture video visualization pipeline)
foreach(module IN LISTS ACMAP_MODULES)
  if(NOT module IN_LIST acmap_all_modules)
    message(FATAL_ERROR "ACMAP_MODULES: there is no module \"${module}\"; there are "
                        "${acmap_all_modules}")
  endif()
endforeach()
set(acmap_chosen_modules ${acmap_all_modules})
if(ACMAP_MODULES)
  set(wanted core ${ACMAP_MODULES})
  if(pipeline IN_LIST wanted)
    list(APPEND wanted egomotion features filters mapping segmentation stereo surface texture)
  endif()
  foreach(module IN LISTS acmap_all_modules)
    if(NOT module IN_LIST wanted)
      list(REMOVE_ITEM acmap_chosen_modules ${module})
    endif()
  endforeach()
endif()

# acmap_if_chosen (<variable> <module>...): true if one of these modules is built.
function(acmap_if_chosen variable)
  set(${variable} FALSE PARENT_SCOPE)
  foreach(module IN LISTS ARGN)
    if(module IN_LIST acmap_chosen_modules)
      set(${variable} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()
