# Makes the results that the browser tests look at.
#
#   cmake -DPROGRAM=<anisofront> -DSTUDIES=<folder of the .toml> -DRESULTS=<folder>
#         -P make_results.cmake
cmake_minimum_required(VERSION 3.25)

function(call expected)
  execute_process(COMMAND ${PROGRAM} ${ARGN} -q RESULT_VARIABLE code ERROR_VARIABLE errors)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "anisofront ${ARGN} ended with ${code}, not ${expected}:\n${errors}")
  endif()
endfunction()

file(REMOVE_RECURSE ${RESULTS})
file(MAKE_DIRECTORY ${RESULTS})
set(ENV{PATH} ${RESULTS})  # no gnuplot: figures take longer than all the rest
foreach(study problem metric hostile)
  call(0 run ${STUDIES}/${study}.toml -o ${RESULTS}/${study})
endforeach()
call(0 run ${STUDIES}/problem.toml --set mesh.preset=paper -o ${RESULTS}/problem-paper)
call(5 run ${STUDIES}/failing.toml -o ${RESULTS}/failing)  # a budget
call(0 report ${RESULTS}/problem ${RESULTS}/problem-paper -o ${RESULTS}/several.html)
