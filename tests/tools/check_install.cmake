# Installs a build, uses it as strangers would (the program, a ready study, a project that finds the
# package) and looks into its Debian packages.
#
#   cmake -DBUILD=<build folder> -DCONSUMER=<source folder> -DWORK=<scratch folder> -P check_install.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# Runs a command; its output in `output`.
macro(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code
                  OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${output}${errors}")
  endif()
endmacro()

macro(expect_files folder)
  foreach(name ${ARGN})
    if(NOT EXISTS ${folder}/${name})
      message(FATAL_ERROR "${folder}/${name} is missing")
    endif()
  endforeach()
endmacro()

set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --strip)
set(shared share/man/man1/anisofront.1 share/bash-completion/completions/anisofront
           share/zsh/site-functions/_anisofront share/anisofront/studies/paper/example-2.toml)
expect_files(${prefix} bin/anisofront ${shared})
run(${prefix}/bin/anisofront --version)
run(${prefix}/bin/anisofront run ${prefix}/share/anisofront/studies/paper/example-2.toml -q -o ${WORK}/run
    --set adapt.mode=anisotropic --set mesh.elements=triangle --set mesh.preset=best --set adapt.cycles=1)
expect_files(${WORK}/run report.html history.json)

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/consumer -G Ninja -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
foreach(library mesher solver adapt)
  run(${WORK}/consumer/use_${library})
  message("${output}")
endforeach()

find_program(cpack cpack REQUIRED)
run(${cpack} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${WORK}/packages)
file(GLOB packages ${WORK}/packages/*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "expected two packages, found ${packages}")
endif()
foreach(package ${packages})
  run(dpkg-deb --info ${package})
  message("${output}")
  run(dpkg-deb -x ${package} ${WORK}/unpacked)
endforeach()
expect_files(${WORK}/unpacked/usr bin/anisofront lib ${shared})
run(${WORK}/unpacked/usr/bin/anisofront --version)
file(REMOVE_RECURSE ${WORK})
