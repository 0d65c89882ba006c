# Counts in how many places tools and Python repeat what a module says once, so that these do
# not become more unnoticed: CONTRIBUTING.md, "The cost of a change". ROOT: the repository.
cmake_minimum_required(VERSION 3.25)
find_program(grep grep REQUIRED)

# count (<maximum> <folder> <what> <advice> <pattern>): places with the pattern,
# except where the checks themselves are defined.
function(count maximum folder what advice)
  execute_process(COMMAND "${grep}" -rnoE --include=*.h --include=*.cpp
                          --exclude=command_line.* ${ARGN} ${folder}
                  WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE found)
  string(REGEX MATCHALL "\n" ends "${found}")
  list(LENGTH ends number)
  message("${folder}: ${number} ${what}")
  if(number GREATER maximum)
    message(SEND_ERROR "${folder}: ${number} ${what}, ${maximum} are allowed. ${advice}:\n${found}")
  endif()
endfunction()

# Those of options that no class has: files, pictures, pace.
set(advice "If a class has the value, call its setter (apps/common/setter_option.h, "
           "python/setter_keyword.h)")
list(JOIN advice "" advice)
count(25 apps "ranges" "${advice}"
      "CLI::(Range|Bound|Positive|NonNegative)|(positiveNumber|numberWithin) *\\(")
count(1 python "ranges" "${advice}" "requireInRange|refuseArgument")

# Fields of reports with a name of two words, which are hardly anything else.
execute_process(COMMAND "${grep}" -rhoE --include=*.h --exclude-dir=impl "visit\\(\\{\"[a-z]+_[a-z_]+\"" modules
                WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE fields)
string(REGEX MATCHALL "\"[a-z_]+\"" fields "${fields}")
list(REMOVE_DUPLICATES fields)
list(LENGTH fields number)
if(number LESS 100)
  message(FATAL_ERROR "only ${number} fields of reports were found")
endif()
list(JOIN fields "|" fields)
set(advice "Write the report as it is (fieldsOf, pcl/core/fields_json.h, python/reports.h)")
count(35 apps "names of fields" "${advice}" "${fields}")
count(13 python "names of fields" "${advice}" "${fields}")

set(advice "What a stage is and does stands in modules/pipeline/src/chain/chain_stages.cpp")
count(9 apps "comparisons with the name of a stage" "${advice}"
      "== \"(egomotion|extension|rectification|adjustment|merging|planes|texture|cloud|map)\"")
