# Installs the package into a folder of its own, then configures, builds and runs projects that find it
# there: the README's program without components, the same with the compiled methods, and another one with all components. The definitions BUILD_FOLDER, PROJECT_FOLDER,
# DATA_FOLDER, WORK_FOLDER, GENERATOR, CXX_COMPILER and OPTIONS come from the command line.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${WORK_FOLDER}/installed)
foreach(project . compiled with_components)
  set(build_folder ${WORK_FOLDER}/build/${project})
  run(${CMAKE_COMMAND} -S ${PROJECT_FOLDER}/${project} -B ${build_folder} -G ${GENERATOR}
      -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_PREFIX_PATH=${WORK_FOLDER}/installed ${OPTIONS})
  run(${CMAKE_COMMAND} --build ${build_folder})

  # The headers must be the installed ones.
  file(READ ${build_folder}/CMakeCache.txt cache)
  string(FIND "${cache}" "Protrusion_segmentation_DIR:PATH=${WORK_FOLDER}/installed" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "Another installation of the package was found")
  endif()
  run(${build_folder}/my_program ${DATA_FOLDER}/tetrahedron.off ${WORK_FOLDER}/tetrahedron.seg)
endforeach()
