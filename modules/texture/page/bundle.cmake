# Makes the script of the page: its modules and those that it imports, in one, with the licences
# of others before it, as a function of the library (acmap_write_embedded).
#   cmake -DROOT=repository -DMODULES=node_modules -DOUTPUT=file.cpp -P bundle.cmake
cmake_minimum_required(VERSION 3.25)
include("${ROOT}/cmake/AcmapEmbedText.cmake")
get_filename_component(folder "${OUTPUT}" DIRECTORY)
set(bundle "${folder}/map_page.js")
file(GLOB esbuild "${MODULES}/@esbuild/*/bin/esbuild" "${MODULES}/@esbuild/*/esbuild.exe")
list(GET esbuild 0 esbuild)

set(ENV{NODE_PATH} "${MODULES}")
execute_process(
  COMMAND "${esbuild}" "${ROOT}/modules/texture/page/src/main.js" --bundle --minify --format=iife
          --target=es2020 --legal-comments=none --log-level=warning "--outfile=${bundle}"
  COMMAND_ERROR_IS_FATAL ANY)

set(licences "")
foreach(name three camera-controls three-mesh-bvh)
  file(READ "${MODULES}/${name}/LICENSE" licence)
  string(STRIP "${licence}" licence)
  string(APPEND licences "${name}\n\n${licence}\n\n")
endforeach()
string(REPLACE "*/" "* /" licences "${licences}")

file(READ "${bundle}" script)
# no text in it ends the element of the page that holds it
string(REPLACE "</script" "<\\/script" script "${script}")
acmap_write_embedded("${OUTPUT}" mapPageScript export/map_page_parts.h "/*\n${licences}*/\n${script}")
file(TOUCH "${OUTPUT}")
