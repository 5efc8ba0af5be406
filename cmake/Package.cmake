# Says what `cpack` makes: a Debian package, and a tarball that runs from any folder. `./dev package` makes both, with lane
# code for every x86-64 CPU; packages/ of the build folder holds them.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_NAME drydock)
set(CPACK_PACKAGE_VENDOR drydock)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "run Unreal Engine post-process patches on the CPU")
set(CPACK_PACKAGE_DESCRIPTION "\
The same C++ and the same HLSL as in the engine run on a rendered frame,
under a debugger, with every intermediate picture to look at.
\"drydock new\" makes a patch to begin with, \"drydock build\" compiles it,
\"drydock run\" draws the frame and writes a page to look at it.")
set(CPACK_PACKAGE_FILE_NAME drydock-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# No mail reaches the developers: the address stands for that, in the form that Debian asks for.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "drydock developers <nobody@drydock.invalid>")
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# `drydock build` calls cmake, which calls ninja or make and the compiler; the headers of drydock include those of glm. The
# shader tier calls the compiler too. dpkg-shlibdeps adds the shared libraries.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, cmake (>= 3.25), ninja-build | make, libglm-dev")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The test of a patch that `drydock new` makes is written with GoogleTest.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgtest-dev")
# gdb stops in patches and shaders, graphviz draws graphs, ffmpeg makes videos, and a Vulkan driver compares shaders.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gdb, graphviz, ffmpeg, libvulkan1, mesa-vulkan-drivers")

# Debian asks for more than what is installed.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/FinishPackage.cmake)
include(CPack)
