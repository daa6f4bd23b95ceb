# Writes a source that holds the files of the page: skeleton, styles and scripts.
#
#   cmake -DPAGE=<folder of the files> -DOUTPUT=<source> -P embed.cmake
cmake_minimum_required(VERSION 3.25)

# Sets `result` to the files that match, one after the other in the order of their names, as the
# definition of a function. Literals have limits in some compilers: one for each file.
function(definition name result)
  file(GLOB files ${PAGE}/${ARGN})
  list(SORT files)
  set(text "std::string_view ${name}() {\n  static constexpr std::string_view kText =\n")
  foreach(file IN LISTS files)
    file(READ ${file} content)
    string(APPEND text "R\"file(${content})file\"\n")
  endforeach()
  set(${result} "${text}      \"\";\n  return kText;\n}\n" PARENT_SCOPE)
endfunction()

definition(page_skeleton skeleton page.html)
definition(page_style style *.css)
definition(page_script script *.js)
file(WRITE ${OUTPUT} "#include \"drivers/report/page.hpp\"\n\nnamespace anisofront {\n\n"
     "${skeleton}\n${style}\n${script}\n}  // namespace anisofront\n")
