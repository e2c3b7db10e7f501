# Makes the Debian packages, unpacks them, looks at what is in them, and runs a tool and the Python module from them. The
# definitions BUILD_FOLDER, WORK_FOLDER and CPACK come from the command line; and PYTHON, the interpreter, if there is a
# package for it.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
file(MAKE_DIRECTORY ${WORK_FOLDER})
run(${CPACK} --config ${BUILD_FOLDER}/CPackConfig.cmake -B ${WORK_FOLDER})
file(GLOB packages ${WORK_FOLDER}/*.deb)
file(GLOB library_package ${WORK_FOLDER}/protrusion-segmentation_*.deb)
file(GLOB tools_package ${WORK_FOLDER}/protrusion-segmentation-tools_*.deb)
file(GLOB python_package ${WORK_FOLDER}/python3-protrusion-segmentation_*.deb)
list(REMOVE_ITEM packages "${library_package}" "${tools_package}")
if(PYTHON)
  list(REMOVE_ITEM packages "${python_package}")
endif()
if(NOT library_package OR NOT tools_package OR packages)
  message(FATAL_ERROR "There is no package of the library or of the tools, or one too many: ${packages}")
endif()

# holds(NAME FILE...): the package that is unpacked in WORK_FOLDER/NAME has the files of /usr.
function(holds name)
  foreach(file ${ARGN})
    if(NOT EXISTS ${WORK_FOLDER}/${name}/usr/${file})
      message(FATAL_ERROR "The package of the ${name} has no /usr/${file}")
    endif()
  endforeach()
endfunction()

# depends_on(PACKAGE NAME...)
function(depends_on package)
  execute_process(COMMAND dpkg-deb --field ${package} Depends OUTPUT_VARIABLE depends)
  foreach(name ${ARGN})
    string(FIND "${depends}" ${name} position)
    if(position EQUAL -1)
      message(FATAL_ERROR "${package} does not depend on ${name}, but on ${depends}")
    endif()
  endforeach()
  set(depends "${depends}" PARENT_SCOPE)
endfunction()

run(dpkg-deb --extract ${library_package} ${WORK_FOLDER}/library)
holds(library
      include/CGAL/protrusion_segmentation.h include/CGAL/segmentation_metrics.h include/CGAL/IO/SEG.h
      include/CGAL/Protrusion_segmentation/Minimum_cut_method.h
      include/CGAL/Protrusion_segmentation/internal/segment_mesh.h
      share/doc/protrusion-segmentation/copyright share/doc/protrusion-segmentation/changelog.gz
      share/doc/protrusion-segmentation/examples/protrusion_segmentation_example.cpp)
file(GLOB_RECURSE config ${WORK_FOLDER}/library/usr/lib*/Protrusion_segmentationConfig.cmake)
if(NOT config)
  message(FATAL_ERROR "find_package() will not find the package")
endif()
depends_on(${library_package} libcgal-dev)

run(dpkg-deb --extract ${tools_package} ${WORK_FOLDER}/tools)
holds(tools
      bin/segment_by_protrusions bin/evaluate_segmentation bin/make_example_mesh
      share/man/man1/segment_by_protrusions.1.gz share/man/man1/evaluate_segmentation.1.gz
      share/man/man1/make_example_mesh.1.gz
      share/doc/protrusion-segmentation-tools/copyright share/doc/protrusion-segmentation-tools/changelog.gz)
depends_on(${tools_package} libc6 libgmp10 libstdc++6)
if(depends MATCHES "-dev" OR EXISTS ${WORK_FOLDER}/tools/usr/include OR EXISTS ${WORK_FOLDER}/library/usr/bin)
  message(FATAL_ERROR "The tools are not in a package of their own that needs no headers: ${depends}")
endif()
foreach(program segment_by_protrusions evaluate_segmentation make_example_mesh)
  execute_process(COMMAND gzip -dc ${WORK_FOLDER}/tools/usr/share/man/man1/${program}.1.gz OUTPUT_VARIABLE page)
  if(NOT page MATCHES "\n\\.SH Name\n${program} [^\n]*\n\\.SH Synopsis\n.*\n\\.SH Options\n\\.SS [^\n]*\n\\.TP\n\\.B .*\n\\.SH Examples\n.*\n\\.SH Exit status\n")
    message(FATAL_ERROR "The manual page of ${program} is not one:\n${page}")
  endif()
endforeach()
# As a new user would, from the package alone.
run(${WORK_FOLDER}/tools/usr/bin/make_example_mesh teddy ${WORK_FOLDER}/teddy.off --faces 2000)
run(${WORK_FOLDER}/tools/usr/bin/segment_by_protrusions ${WORK_FOLDER}/teddy.off -o ${WORK_FOLDER}/teddy.seg)

if(NOT PYTHON)
  return()
endif()
run(dpkg-deb --extract ${python_package} ${WORK_FOLDER}/python_root)
set(module_folder ${WORK_FOLDER}/python_root/usr/lib/python3/dist-packages)
run(${CMAKE_COMMAND} -E env PYTHONPATH=${module_folder} PYTHONDONTWRITEBYTECODE=1 ${PYTHON} -c
    "from protrusion_segmentation import segment\nassert list(segment([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])) == [0]")
foreach(file ${module_folder}/protrusion_segmentation/py.typed ${module_folder}/protrusion_segmentation/_core.pyi
        ${WORK_FOLDER}/python_root/usr/share/doc/python3-protrusion-segmentation/examples/label_with_meshio.py)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "The package of the module has no ${file}")
  endif()
endforeach()
depends_on(${python_package} python3 python3-numpy libstdc++6)
