# Installs drydock into a fresh prefix, builds the outside project against it, and runs its host from another folder with
# an empty shader cache, as on a machine that has only the package.
#
# cmake -DBUILD=<drydock build folder> -DSOURCE=<this folder> -DWORK=<scratch folder> -P InstalledPackageTest.cmake

cmake_minimum_required(VERSION 3.25)

function(run_step Name)
	execute_process(COMMAND ${ARGN} RESULT_VARIABLE Result OUTPUT_VARIABLE Output ERROR_VARIABLE Output)
	if(NOT Result EQUAL 0)
		message(FATAL_ERROR "${Name} failed (${Result}):\n${Output}")
	endif()
	message(STATUS "${Name}: done")
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/elsewhere")
run_step("install" ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")

# The public face: headers of rdg, settings and passes, the engine's names for them, and one of the pipeline's.
file(GLOB_RECURSE Headers RELATIVE "${WORK}/prefix/include/drydock" "${WORK}/prefix/include/drydock/*")
foreach(Header IN LISTS Headers)
	if(NOT Header MATCHES "^(rdg|settings|passes|engine)/.*[.](h|inl)$" AND NOT Header STREQUAL "pipeline/DrydockFrame.h")
		message(FATAL_ERROR "${Header} is installed, which is no affair of plugins")
	endif()
endforeach()
foreach(Header IN ITEMS rdg/Core/CoreMinimal.h settings/PostProcessSettings.h passes/Scene/SceneView.h
	engine/Runtime/Engine/Public/SceneView.h pipeline/DrydockFrame.h)
	if(NOT Header IN_LIST Headers)
		message(FATAL_ERROR "${Header} is not installed")
	endif()
endforeach()

run_step("configure" ${CMAKE_COMMAND} -S "${SOURCE}" -B "${WORK}/build" -G Ninja
	-DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run_step("build" ${CMAKE_COMMAND} --build "${WORK}/build")
execute_process(
	COMMAND ${CMAKE_COMMAND} -E env "DRYDOCK_CACHE_DIR=${WORK}/cache" "${WORK}/build/OutsideHost"
	WORKING_DIRECTORY "${WORK}/elsewhere"
	RESULT_VARIABLE Result OUTPUT_VARIABLE Output ERROR_VARIABLE Errors)
message(STATUS "host: ${Output}${Errors}")
if(NOT Result EQUAL 0)
	message(FATAL_ERROR "the host failed (${Result})")
endif()
execute_process(
	COMMAND "${WORK}/prefix/bin/drydock" --version
	WORKING_DIRECTORY "${WORK}/elsewhere"
	RESULT_VARIABLE Result OUTPUT_VARIABLE Output ERROR_VARIABLE Errors)
if(NOT Result EQUAL 0)
	message(FATAL_ERROR "the installed program failed (${Result}): ${Output}${Errors}")
endif()
message(STATUS "installed program: ${Output}")
