# acmap_page_modules (<variable> <folder>): the folder node_modules with what package-lock.json of
# a folder names, or nothing. ACMAP_PAGE_MODULES states one; else npm brings it into the build
# tree when configuring, once for each content of the lock file. Nothing of it runs on that way.
set(ACMAP_PAGE_MODULES "" CACHE PATH
    "Folder node_modules with what modules/texture/page/package.json names; empty: npm brings it")

function(acmap_page_modules variable folder)
  set(${variable} "" PARENT_SCOPE)
  set(lock "${folder}/package-lock.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${lock}")
  set(modules "${ACMAP_PAGE_MODULES}")
  set(why "ACMAP_PAGE_MODULES, ${modules}, lacks some of")
  if(modules STREQUAL "")
    set(modules "${PROJECT_BINARY_DIR}/page_modules/node_modules")
    acmap_install_page_modules("${folder}" "${lock}" why)
  endif()
  file(GLOB esbuild "${modules}/@esbuild/*/bin/esbuild" "${modules}/@esbuild/*/esbuild.exe")
  if(esbuild AND EXISTS "${modules}/three/package.json"
     AND EXISTS "${modules}/camera-controls/package.json"
     AND EXISTS "${modules}/three-mesh-bvh/package.json")
    set(${variable} "${modules}" PARENT_SCOPE)
    return()
  endif()
  message(WARNING "There will be no map.html: ${why} what modules/texture/page/package.json names. "
                  "State a folder node_modules that has it by -DACMAP_PAGE_MODULES=DIR")
endfunction()

# Fills page_modules of the build tree, unless it has what the lock file says already.
function(acmap_install_page_modules folder lock why)
  set(place "${PROJECT_BINARY_DIR}/page_modules")
  file(SHA256 "${lock}" sum)
  set(stamp "${place}/installed")
  if(EXISTS "${stamp}")
    file(READ "${stamp}" installed)
    if(installed STREQUAL sum)
      return()
    endif()
  endif()
  find_program(ACMAP_NPM npm)
  mark_as_advanced(ACMAP_NPM)
  if(NOT ACMAP_NPM)
    set(${why} "there is no npm to bring" PARENT_SCOPE)
    return()
  endif()
  message(STATUS "Bringing the modules of map.html by npm")
  file(REMOVE_RECURSE "${place}")
  file(COPY "${folder}/package.json" "${lock}" DESTINATION "${place}")
  execute_process(
    COMMAND "${ACMAP_NPM}" ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
    WORKING_DIRECTORY "${place}" TIMEOUT 300 RESULT_VARIABLE failed OUTPUT_VARIABLE told
    ERROR_VARIABLE told)
  if(failed)
    string(STRIP "${told}" told)
    message(STATUS "npm: ${told}")
    set(${why} "npm could not bring" PARENT_SCOPE)
    return()
  endif()
  file(WRITE "${stamp}" "${sum}")
endfunction()
