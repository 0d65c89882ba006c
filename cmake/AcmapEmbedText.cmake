# acmap_embed_text (<output.cpp> <function> <header> <file>): writes a function that returns
# the text of a file, which is so a part of the tool; the header declares the function.
function(acmap_embed_text output function header file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" text)
  acmap_write_embedded(${output} ${function} ${header} "${text}")
endfunction()

# The same for a text; an empty one is legal.
function(acmap_write_embedded output function header text)
  string(FIND "${text}" ")text\"" end)
  if(end GREATER -1)
    message(FATAL_ERROR "a text for ${output} has what ends a raw string of C++")
  endif()
  set(source "#include \"${header}\"

namespace pcl::acmap {

const char*
${function}()
{
  return R\"text(${text})text\";
}

} // namespace pcl::acmap
")
  file(CONFIGURE OUTPUT ${output} CONTENT "@source@" @ONLY)
endfunction()
