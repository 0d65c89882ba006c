# Runs the programs of this project in its build folder, before and after the change,
# and checks what they print. TOOLS: the folder of acmap's tools.
cmake_minimum_required(VERSION 3.25)

# tell (<command> <argument>...): sets told to what the command prints
function(tell)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output
                  COMMAND_ERROR_IS_FATAL ANY)
  message("${ARGN}\n${output}")
  set(told "${output}" PARENT_SCOPE)
endfunction()

# expect_planes (<program>): the floor and the two walls
function(expect_planes program)
  tell(./${program} view.pcd)
  if(NOT told MATCHES "(^|\n)3 planes")
    message(SEND_ERROR "${program} does not print 3 planes")
  endif()
endfunction()

# expect_within (<program> <regex> <minimum> <maximum>): the number in the output
function(expect_within program regex minimum maximum)
  if(NOT told MATCHES "${regex}" OR CMAKE_MATCH_1 LESS minimum OR CMAKE_MATCH_1 GREATER maximum)
    message(SEND_ERROR "${program} prints no number from ${minimum} to ${maximum}")
  endif()
endfunction()

tell(./make_view view.pcd)
foreach(after IN ITEMS "" _after)
  tell(./greedy_projection${after} view.pcd mesh.ply) # of 76800 points
  expect_within(greedy_projection${after} "([0-9]+) triangles" 130000 153600)
  expect_planes(largest_planes${after})
  expect_planes(organized_planes${after})
  tell(./voxel_grid${after} view.pcd fewer.pcd)
  expect_within(voxel_grid${after} "76800 points, then ([0-9]+)" 3000 12000)
endforeach()

find_program(XVFB_RUN xvfb-run)
if(NOT XVFB_RUN)
  message("the viewer is not run: there is no xvfb-run")
  return()
endif()
file(REMOVE_RECURSE session)
tell("${TOOLS}/pcl_simulated_rig" -o session --observations 2 --patterns 2)
tell("${XVFB_RUN}" -a -s "-screen 0 1280x960x24" ./openni_viewer_after)
if(NOT told MATCHES "(^|\n)2 clouds")
  message(SEND_ERROR "openni_viewer_after does not print 2 clouds")
endif()
