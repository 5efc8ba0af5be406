# drydock_add_plugin(NAME SOURCES file... [SHADERS file...])
#
# A plugin as Unreal has it: a shared library lib<NAME>.so whose extensions and shaders register themselves when it is
# loaded ("plugins": ["path/libNAME.so"] in a config, or linked to a program).
#
# SOURCES  C++ files. An `#include "X.generated.h"` in them, or in headers beside them, finds an empty header made here.
# SHADERS  .usf and .ush files. Their common folder is what the virtual path "/Plugin/<NAME>" means; the files are read
#          in place, so that an edit is seen by the next run.

function(drydock_add_plugin Name)
	cmake_parse_arguments(PARSE_ARGV 1 Arg "" "" "SOURCES;SHADERS")
	if(Arg_UNPARSED_ARGUMENTS)
		message(FATAL_ERROR "drydock_add_plugin(${Name}): unknown arguments ${Arg_UNPARSED_ARGUMENTS}; "
			"expected SOURCES and SHADERS")
	endif()
	if(NOT Arg_SOURCES)
		message(FATAL_ERROR "drydock_add_plugin(${Name}): no SOURCES given")
	endif()

	set(GeneratedFolder "${CMAKE_CURRENT_BINARY_DIR}/${Name}.generated")
	file(MAKE_DIRECTORY "${GeneratedFolder}")
	set(Folders "")
	set(SourceFiles "")
	foreach(Source IN LISTS Arg_SOURCES)
		cmake_path(ABSOLUTE_PATH Source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
		if(NOT EXISTS "${Source}")
			message(FATAL_ERROR "drydock_add_plugin(${Name}): source file ${Source} does not exist")
		endif()
		cmake_path(GET Source PARENT_PATH Folder)
		list(APPEND Folders "${Folder}")
		list(APPEND SourceFiles "${Source}")
	endforeach()
	list(REMOVE_DUPLICATES Folders)

	# Unreal's header tool writes one X.generated.h per header; here it has nothing to say.
	foreach(Folder IN LISTS Folders)
		file(GLOB Headers CONFIGURE_DEPENDS "${Folder}/*.h" "${Folder}/*.cpp")
		foreach(Header IN LISTS Headers)
			file(STRINGS "${Header}" Includes REGEX "#[ \t]*include[ \t]*\"[^\"]*\\.generated\\.h\"")
			foreach(Include IN LISTS Includes)
				string(REGEX REPLACE ".*\"([^\"]*)\".*" "\\1" GeneratedName "${Include}")
				if(NOT EXISTS "${GeneratedFolder}/${GeneratedName}")
					file(WRITE "${GeneratedFolder}/${GeneratedName}" "#pragma once\n")
				endif()
			endforeach()
		endforeach()
	endforeach()

	if(Arg_SHADERS)
		set(ShaderFolder "")
		foreach(Shader IN LISTS Arg_SHADERS)
			cmake_path(ABSOLUTE_PATH Shader BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
			if(NOT EXISTS "${Shader}")
				message(FATAL_ERROR "drydock_add_plugin(${Name}): shader file ${Shader} does not exist")
			endif()
			cmake_path(GET Shader PARENT_PATH Folder)
			if(NOT ShaderFolder)
				set(ShaderFolder "${Folder}")
			endif()
			cmake_path(IS_PREFIX ShaderFolder "${Folder}" NORMALIZE bInside)
			while(NOT bInside)
				cmake_path(GET ShaderFolder PARENT_PATH ShaderFolder)
				cmake_path(IS_PREFIX ShaderFolder "${Folder}" NORMALIZE bInside)
			endwhile()
		endforeach()
		set(MappingFile "${GeneratedFolder}/${Name}ShaderDirectory.cpp")
		file(CONFIGURE OUTPUT "${MappingFile}" @ONLY CONTENT
"// Made by drydock_add_plugin: where the plugin and its shaders are.
#include \"Interfaces/IPluginManager.h\"
#include \"ShaderCore.h\"

namespace
{
const bool bMapped = (AddShaderSourceDirectoryMapping(TEXT(\"/Plugin/@Name@\"), TEXT(\"@ShaderFolder@\")), true);
const bool bRegistered = (IPluginManager::Get().RegisterPlugin(TEXT(\"@Name@\"), TEXT(\"@CMAKE_CURRENT_SOURCE_DIR@\")), true);
}
")
		list(APPEND SourceFiles "${MappingFile}")
	endif()

	add_library(${Name} SHARED ${SourceFiles})
	target_include_directories(${Name} PUBLIC ${Folders} PRIVATE "${GeneratedFolder}")
	target_link_libraries(${Name} PUBLIC drydock::drydock)
	target_compile_features(${Name} PUBLIC cxx_std_20)
	if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
		# A library with unique symbols stays in memory: a rebuilt plugin could not take its place in `run --watch`.
		target_compile_options(${Name} PRIVATE -fno-gnu-unique)
	endif()
endfunction()
