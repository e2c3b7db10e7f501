# `cpack` makes a Debian package of the headers and the command line tools.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME protrusion-segmentation)
set(CPACK_PACKAGE_VENDOR "The Protrusion_segmentation authors")
set(CPACK_PACKAGE_CONTACT "The Protrusion_segmentation authors")
file(READ package_info/Protrusion_segmentation/long_description.txt CPACK_PACKAGE_DESCRIPTION)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
# What the tools are linked with is found out by dpkg-shlibdeps; the rest is what the headers include.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++, cmake, libeigen3-dev, libspectra-dev, libtbb-dev")
include(CPack)
