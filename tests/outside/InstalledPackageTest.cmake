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

# The public face: headers that plugins and engine-style tests need, the engine's names for them, and one of the pipeline's.
# The inside of the shader tier is not there.
file(GLOB_RECURSE Headers RELATIVE "${WORK}/prefix/include/drydock" "${WORK}/prefix/include/drydock/*")
foreach(Header IN LISTS Headers)
	if((NOT Header MATCHES "^(rdg/core|rdg/graph|rdg/shader/Lanes|settings|passes|engine)/.*[.](h|inl)$"
			OR Header MATCHES "^(passes/Native|settings/Text)/") AND NOT Header MATCHES "^pipeline/Drydock(Frame|HeadersMark)[.]h$")
		message(FATAL_ERROR "${Header} is installed, which is no affair of plugins")
	endif()
endforeach()
foreach(Header IN ITEMS rdg/core/Core/CoreMinimal.h settings/Table/PostProcessSettings.h passes/Scene/SceneView.h
	engine/Runtime/Engine/Public/SceneView.h pipeline/DrydockFrame.h)
	if(NOT Header IN_LIST Headers)
		message(FATAL_ERROR "${Header} is not installed")
	endif()
endforeach()

# What shells and man read.
foreach(File IN ITEMS bash-completion/completions/drydock zsh/site-functions/_drydock man/man1/drydock.1)
	if(NOT EXISTS "${WORK}/prefix/share/${File}")
		message(FATAL_ERROR "share/${File} is not installed")
	endif()
	file(READ "${WORK}/prefix/share/${File}" Text)
	if(NOT Text MATCHES "explain")
		message(FATAL_ERROR "share/${File} knows no verb explain")
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

# The plugin's own setting, blended by the installed program: 1, then a quarter of the way to 3.
file(WRITE "${WORK}/elsewhere/lift.json" "{
	\"scene\": {\"file\": \"${WORK}/prefix/share/drydock/configs/scenes/moving_camera.0001.exr\"},
	\"plugins\": [\"${WORK}/build/libLiftSetting.so\"],
	\"volumes\": [
		{\"bUnbound\": true, \"Priority\": 1, \"Settings\": {\"OutsideLift\": 1}},
		{\"bUnbound\": true, \"Priority\": 2, \"BlendWeight\": 0.25, \"Settings\": {\"OutsideLift\": 3}}]}\n")
set(Drydock ${CMAKE_COMMAND} -E env "DRYDOCK_CACHE_DIR=${WORK}/cache"
	${CMAKE_COMMAND} -E chdir "${WORK}/elsewhere" "${WORK}/prefix/bin/drydock")
run_step("run of the blended setting" ${Drydock} run lift.json --out blended)
run_step("run of the same value" ${Drydock} run lift.json --pp OutsideLift=1.5 --out given)
run_step("run of the default" ${Drydock} run lift.json --pp OutsideLift=0 --out none)
run_step("comparison of the first two" ${Drydock} diff blended given --max 0)
execute_process(COMMAND ${Drydock} diff blended/scene_linear.exr none/scene_linear.exr --json
	RESULT_VARIABLE Result OUTPUT_VARIABLE Output ERROR_VARIABLE Errors)
message(STATUS "against the default: ${Output}")
string(JSON Largest ERROR_VARIABLE NoNumber GET "${Output}" images 0 max)
if(NOT Largest GREATER 1.49 OR NOT Largest LESS 1.51)
	message(FATAL_ERROR "OutsideLift 1.5 adds ${Largest}, not 1.5: ${Output}")
endif()

# The article's plugin, as its folder is.
run_step("build of a plugin's folder" ${Drydock} build "${SOURCE}/../plugins/ArticleBlur" --out article)
file(WRITE "${WORK}/elsewhere/article.json" "{
	\"scene\": {\"file\": \"${WORK}/prefix/share/drydock/configs/scenes/moving_camera.0001.exr\"},
	\"plugins\": [\"article/cmake/libArticleBlur.so\"]}\n")
execute_process(COMMAND ${Drydock} run article.json --out blurred
	RESULT_VARIABLE Result OUTPUT_VARIABLE Output ERROR_VARIABLE Errors)
if(NOT Result EQUAL 0 OR NOT Output MATCHES "ArticleUpPass")
	message(FATAL_ERROR "the article's plugin does not run (${Result}): ${Output}${Errors}")
endif()
message(STATUS "the article's plugin: ${Output}")

# Last, since it changes the installation's shaders: a frame shows an edit of any of them. EditedShaderTest.cpp
# compiles the same, so that the tests' cache may be used.
find_program(Python python3)
if(Python)
	run_step("edits of shaders" ${CMAKE_COMMAND} -E env "DRYDOCK_CACHE_DIR=${BUILD}/cache" ${Python}
		"${SOURCE}/EditedShaders.py" "${WORK}/prefix" "${SOURCE}/../.." "${WORK}/edited")
else()
	message(STATUS "edits of shaders: skipped, there is no python3")
endif()
