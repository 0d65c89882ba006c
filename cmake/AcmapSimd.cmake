# acmap_add_simd_variant (<module> <instructions> <file> [PRAGMA])
#
# Adds a source compiled for an instruction set, chosen at run time, where the compiler
# makes it for this processor family; defines ACMAP_SIMD_<INSTRUCTIONS> for the module.
# With PRAGMA, the source chooses the functions that get these instructions itself, because
# it uses templates of libraries.
include(CheckCXXSourceCompiles)
include(CMakePushCheckState)

function(acmap_add_simd_variant module instructions file)
  string(TOUPPER ${instructions} name)
  cmake_push_check_state(RESET)
  set(CMAKE_REQUIRED_FLAGS -m${instructions})
  check_cxx_source_compiles(
    "int main () { return __builtin_cpu_supports (\"${instructions}\") ? 0 : 1; }"
    ACMAP_COMPILES_${name})
  cmake_pop_check_state()
  if(ACMAP_COMPILES_${name})
    target_sources(acmap_${module}_objects PRIVATE ${file})
    set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
                                                   SKIP_PRECOMPILE_HEADERS ON)
    if(NOT "PRAGMA" IN_LIST ARGN)
      set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS -m${instructions})
    endif()
    target_compile_definitions(acmap_${module}_objects PUBLIC ACMAP_SIMD_${name})
  endif()
endfunction()
