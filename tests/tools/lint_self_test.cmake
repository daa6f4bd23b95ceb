# Plants defects in a copy of the sources and expects the lint scripts to name them.
#
#   cmake -DWORK=<scratch folder> -P lint_self_test.cmake
cmake_minimum_required(VERSION 3.25)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)

function(run_lint script result output)
  execute_process(COMMAND ${CMAKE_COMMAND} ${ARGN} -P ${CMAKE_CURRENT_LIST_DIR}/${script}
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  set(${result} ${code} PARENT_SCOPE)
  set(${output} "${out}${err}" PARENT_SCOPE)
endfunction()

function(expect_failure defect code output text)
  string(FIND "${output}" "${text}" found)
  if(code EQUAL 0 OR found EQUAL -1)
    message(FATAL_ERROR "not caught: ${defect}; the output is\n${output}")
  endif()
endfunction()

# Copies the file, adds the line at its end and expects check_layers.cmake to say `text`.
function(expect_include_caught file line text)
  file(READ ${root}/${file} content)
  file(WRITE ${WORK}/${file} "${content}\n${line}\n")
  run_lint(check_layers.cmake code output -DROOT=${WORK} -DNOTES=OFF)
  expect_failure("${line} in ${file}" "${code}" "${output}" "${file} includes ${text}")
  file(WRITE ${WORK}/${file} "${content}")
endfunction()

# Expects check_test_names.cmake to say `text` about a test file.
function(expect_test_caught content text)
  file(WRITE ${WORK}/names/planted_test.cpp "${content}")
  run_lint(check_test_names.cmake code output -DSOURCES=${WORK}/names ${ARGN})
  expect_failure("${content}" "${code}" "${output}" "${text}")
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(folder mesher solver adapt drivers)
  file(COPY ${root}/${folder} DESTINATION ${WORK} FILES_MATCHING PATTERN *.hpp PATTERN *.cpp)
endforeach()
run_lint(check_layers.cmake code output -DROOT=${WORK} -DNOTES=OFF)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the copy does not keep to the layers:\n${output}")
endif()
expect_include_caught(mesher/metric/metric.hpp "#include \"solver/scalar/norms.hpp\"" "\"solver/scalar/norms.hpp\"")
expect_include_caught(mesher/metric/metric.hpp "#include \"mesher/front/front.hpp\""
                      "\"mesher/front/front.hpp\"")
expect_include_caught(mesher/mesh/check.cpp "#include \"topology.hpp\"" "\"topology.hpp\"")
expect_include_caught(mesher/generate.cpp "  # include \"mesher/io/medit.hpp\""
                      "\"mesher/io/medit.hpp\"")
expect_include_caught(solver/scalar/norms.cpp "#include \"adapt/loop.hpp\"" "\"adapt/loop.hpp\"")
expect_include_caught(mesher/mesh/check.cpp "#include <Eigen/Core>" "<Eigen/Core>")
expect_include_caught(mesher/quads/matching.hpp "#include <lemon/matching.h>" "<lemon/matching.h>")
expect_include_caught(mesher/quads/matching.cpp "#include <CGAL/number_utils.h>"
                      "<CGAL/number_utils.h>")
expect_include_caught(drivers/commands/main.cpp "#include <CGAL/number_utils.h>" "<CGAL/number_utils.h>")
expect_include_caught(drivers/report/page.cpp "#include \"drivers/run/run_study.hpp\""
                      "\"drivers/run/run_study.hpp\"")

file(WRITE ${WORK}/mesher/stray/new.cpp "")
run_lint(check_layers.cmake code output -DROOT=${WORK} -DNOTES=OFF)
expect_failure("a folder without layer" "${code}" "${output}" "mesher/stray/new.cpp lies in no known layer")

expect_test_caught("TEST_CASE(\"a\;b\") {}\n" "<semicolon>")
expect_test_caught("TEST_CASE(\n    \"a long name that\"\n    \" goes on, and on\") {}\n" "goes on, and on")
expect_test_caught("TEST_CASE(\"lies in [0 1]\") {}\n" "<bracket>")
expect_test_caught("TEST_CASE(\"a\") {}\nTEST_CASE(\"a\") {}\n" "already a test")
# A program that registers one case more or less: here one that prints doctest's line.
file(WRITE ${WORK}/program "#!/bin/sh\necho '[doctest] unskipped test cases passing the current filters: 2'\n")
file(CHMOD ${WORK}/program PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
expect_test_caught("TEST_CASE(\"a\") {}\n" "registers 2" -DPROGRAM=${WORK}/program)
file(REMOVE_RECURSE ${WORK})
message("all planted defects are caught")
