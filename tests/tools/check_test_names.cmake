# Every TEST_CASE of the sources is registered with CTest under a name that it can pass on. `;`
# would split a name into two tests that run nothing and pass, `,` separates doctest's filters, `*`
# and `?` are its wildcards, brackets and backslashes break CMake's lists.
#
#   cmake -DSOURCES=<folder> -DPROGRAM=<doctest executable> -P check_test_names.cmake
#
# Without PROGRAM only the names are checked.
cmake_minimum_required(VERSION 3.25)

set(defects 0)
macro(defect text)
  message("${text}")
  math(EXPR defects "${defects} + 1")
endmacro()

# The heads of the test cases of a file, from TEST_CASE to the opening brace, as a list in which
# characters that would disturb a list are written as words.
function(test_heads file result)
  file(READ ${file} text)
  string(REPLACE "\\" "<backslash>" text "${text}")
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REPLACE "[" "<bracket>" text "${text}")
  string(REPLACE "]" "<bracket>" text "${text}")
  string(REGEX MATCHALL "\n *TEST_CASE(_FIXTURE|_TEMPLATE)?\\([^{]*" heads "\n${text}")
  set(${result} "${heads}" PARENT_SCOPE)
endfunction()

# The name in the head of a test case: its string literals joined.
function(test_name head result)
  string(REGEX MATCHALL "\"[^\"]*\"" literals "${head}")
  string(JOIN "" name ${literals})
  string(REPLACE "\"" "" name "${name}")
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files ${SOURCES}/*_test.cpp)
set(names)
foreach(file IN LISTS files)
  test_heads(${file} heads)
  foreach(head IN LISTS heads)
    test_name("${head}" name)
    if(name MATCHES "<semicolon>|<bracket>|<backslash>|[,*?]")
      defect("${file}: test name \"${name}\" must not contain ; , * ? [ ] or a backslash")
    endif()
    if(name IN_LIST names)
      defect("${file}: there is already a test \"${name}\"")
    endif()
    list(APPEND names "${name}")
  endforeach()
endforeach()

list(LENGTH names written)
if(PROGRAM)
  execute_process(COMMAND ${PROGRAM} --count --no-skip --no-colors OUTPUT_VARIABLE output
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "filters: ([0-9]+)" found "${output}")
  set(registered "${CMAKE_MATCH_1}")
  if(NOT registered EQUAL written)
    defect("${SOURCES} holds ${written} test cases but ${PROGRAM} registers ${registered}")
  endif()
endif()
if(defects GREATER 0)
  message(FATAL_ERROR "${defects} defects in the test cases of ${SOURCES}")
endif()
message("${written} test cases of ${SOURCES} are well named")
