# Installs the package into a folder of its own, then configures, builds and runs projects that find it
# there: the README's program without components, the same with the compiled methods, and another one with all components. Two
# more use the sources, by add_subdirectory() and FetchContent. The definitions BUILD_FOLDER, PACKAGE_FOLDER, PROJECT_FOLDER,
# DATA_FOLDER, WORK_FOLDER, GENERATOR, CXX_COMPILER and OPTIONS come from the command line.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${WORK_FOLDER}/installed)
function(build_and_run project)
  set(build_folder ${WORK_FOLDER}/build/${project})
  run(${CMAKE_COMMAND} -S ${PROJECT_FOLDER}/${project} -B ${build_folder} -G ${GENERATOR}
      -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release ${OPTIONS} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build_folder} --target all)
  run(${build_folder}/my_program ${DATA_FOLDER}/tetrahedron.off ${WORK_FOLDER}/tetrahedron.seg)
endfunction()

foreach(project . compiled with_components)
  build_and_run(${project} -DCMAKE_PREFIX_PATH=${WORK_FOLDER}/installed)
  # The headers must be the installed ones.
  file(READ ${WORK_FOLDER}/build/${project}/CMakeCache.txt cache)
  string(FIND "${cache}" "Protrusion_segmentation_DIR:PATH=${WORK_FOLDER}/installed" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "Another installation of the package was found")
  endif()
endforeach()
build_and_run(added -DPACKAGE_FOLDER=${PACKAGE_FOLDER})
build_and_run(fetched -DPACKAGE_FOLDER=${PACKAGE_FOLDER} -DFETCHCONTENT_SOURCE_DIR_PROTRUSION_SEGMENTATION=${PACKAGE_FOLDER})
