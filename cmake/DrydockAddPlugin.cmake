# drydock_add_plugin(NAME SOURCES file... [SHADERS file...])
#
# A plugin as Unreal has it: a shared library lib<NAME>.so whose extensions and shaders register themselves when it is
# loaded ("plugins": ["path/libNAME.so"] in a config, or linked to a program).
#
# SOURCES  C++ files, in one folder or in the engine's layout (Source/MODULE/Public and Private). Headers of the module
#          are found as in the engine. A header with `#include "X.generated.h"` gets that file made here, and its UCLASSes
#          are registered, so that subsystems start by themselves; it is made again whenever the header changes.
# SHADERS  .usf and .ush files. The virtual path "/Plugin/<NAME>" means the plugin's folder Shaders where they lie in it,
#          else their common folder; the files are read in place, so that an edit is seen by the next run.
#
# IPluginManager::Get().FindPlugin(TEXT("<NAME>"))->GetBaseDir() is the folder of the nearest .uplugin file, else the one
# that holds Source or Shaders, else the folder of the CMakeLists.txt.

# Folder of the plugin that Source belongs to.
function(_drydock_plugin_folder Source ShaderFolder OutVariable)
	cmake_path(GET Source PARENT_PATH Folder)
	foreach(Level RANGE 8)
		file(GLOB Descriptions "${Folder}/*.uplugin")
		cmake_path(GET Folder FILENAME Name)
		cmake_path(GET Folder PARENT_PATH Parent)
		if(Descriptions)
			set(${OutVariable} "${Folder}" PARENT_SCOPE)
			return()
		elseif(Name STREQUAL "Source")
			set(${OutVariable} "${Parent}" PARENT_SCOPE)
			return()
		endif()
		if(Folder STREQUAL CMAKE_CURRENT_SOURCE_DIR)
			break()
		endif()
		set(Folder "${Parent}")
	endforeach()
	cmake_path(GET ShaderFolder FILENAME Name)
	if(Name STREQUAL "Shaders")
		cmake_path(GET ShaderFolder PARENT_PATH Parent)
		set(${OutVariable} "${Parent}" PARENT_SCOPE)
	else()
		set(${OutVariable} "${CMAKE_CURRENT_SOURCE_DIR}" PARENT_SCOPE)
	endif()
endfunction()

# What Unreal's header tool does, as far as there is something to say here: for each UCLASS and USTRUCT of Header its
# Super and ThisClass at the line of GENERATED_BODY, and a NAME.gen.cpp that registers the classes.
function(_drydock_generate_header Header GeneratedFolder Name OutClasses)
	file(READ "${Header}" Text)
	string(MAKE_C_IDENTIFIER "FID_${Name}_h" FileId)
	# One list element per line: none empty, and nothing in them that means something to a list.
	string(REGEX REPLACE "\r" "" Text "${Text}")
	string(REGEX REPLACE "//[^\n]*" "" Text "${Text}")
	string(REGEX REPLACE "[][;\\]" " " Text "${Text}")
	string(REPLACE "\n" " ;" Text "${Text}")
	set(Macros "")
	set(Classes "")
	set(Kind "")
	set(Head "")
	set(LineNumber 0)
	foreach(Line IN LISTS Text)
		math(EXPR LineNumber "${LineNumber} + 1")
		if(Line MATCHES "^[ \t]*(UCLASS|USTRUCT|UINTERFACE)[ \t]*\\(")
			set(Kind "${CMAKE_MATCH_1}")
			set(Head "")
		endif()
		if(NOT Kind)
			continue()
		endif()
		string(APPEND Head " ${Line}")
		if(NOT Line MATCHES "GENERATED_[A-Z]*_?BODY[ \t]*\\(")
			continue()
		endif()
		if(Head MATCHES
			"(class|struct)[ \t]+([A-Z0-9_]+_API[ \t]+)?([A-Za-z0-9_]+)[ \t]*(final[ \t]*)?(:[ \t]*(public[ \t]+)?([A-Za-z0-9_:]+)|{)")
			set(Class "${CMAKE_MATCH_3}")
			set(Key "${CMAKE_MATCH_1}")
			set(Base "${CMAKE_MATCH_7}")
			set(Body "public:")
			if(Base)
				string(APPEND Body " using Super = ${Base};")
			endif()
			string(APPEND Body " using ThisClass = ${Class};")
			if(Line MATCHES "GENERATED_UCLASS_BODY")
				string(APPEND Body " ${Class}(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());")
			elseif(Key STREQUAL "class")
				string(APPEND Body " private:")
			endif()
			string(APPEND Macros "#define ${FileId}_${LineNumber}_GENERATED_BODY , ${Body}\n")
			if(Kind STREQUAL "UCLASS")
				list(APPEND Classes "${Class}")
			endif()
		endif()
		set(Kind "")
	endforeach()
	file(CONFIGURE OUTPUT "${GeneratedFolder}/${Name}.generated.h" @ONLY CONTENT
"// Made by drydock_add_plugin from @Header@.
#pragma once

#include \"UObject/ObjectMacros.h\"

#undef CURRENT_FILE_ID
#define CURRENT_FILE_ID @FileId@
@Macros@")
	set(Registrations "")
	foreach(Class IN LISTS Classes)
		string(APPEND Registrations "const Drydock::TClassRegistration<${Class}> GRegister${Class}(TEXT(\"${Class}\"));\n")
	endforeach()
	file(CONFIGURE OUTPUT "${GeneratedFolder}/${Name}.gen.cpp" @ONLY CONTENT
"// Made by drydock_add_plugin: registers the classes of @Header@.
#include \"@Header@\"

#include \"Subsystems/Subsystem.h\"

namespace
{
@Registrations@} // namespace
")
	set(${OutClasses} "${Classes}" PARENT_SCOPE)
endfunction()

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
	set(Folders "")       # where `#include` looks
	set(ModuleFolders "") # whose headers are read
	set(ModuleNames "${Name}")
	set(SourceFiles "")
	foreach(Source IN LISTS Arg_SOURCES)
		cmake_path(ABSOLUTE_PATH Source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
		if(NOT EXISTS "${Source}")
			message(FATAL_ERROR "drydock_add_plugin(${Name}): source file ${Source} does not exist")
		endif()
		cmake_path(GET Source PARENT_PATH Folder)
		list(APPEND Folders "${Folder}")
		list(APPEND SourceFiles "${Source}")
		if(Source MATCHES "^(.*)/(Public|Private|Classes)/")
			set(Module "${CMAKE_MATCH_1}")
			cmake_path(GET Module FILENAME ModuleName)
			list(APPEND ModuleNames "${ModuleName}")
			list(APPEND ModuleFolders "${Module}")
			foreach(Part IN ITEMS "" /Public /Private /Classes)
				if(IS_DIRECTORY "${Module}${Part}")
					list(APPEND Folders "${Module}${Part}")
				endif()
			endforeach()
		else()
			list(APPEND ModuleFolders "${Folder}/.")
		endif()
	endforeach()
	list(REMOVE_DUPLICATES Folders)
	list(REMOVE_DUPLICATES ModuleFolders)

	set(Headers "")
	set(InlineGenerated "")
	foreach(Folder IN LISTS ModuleFolders)
		set(Glob GLOB_RECURSE)
		if(Folder MATCHES "/\\.$")
			set(Glob GLOB)
		endif()
		file(${Glob} Files CONFIGURE_DEPENDS "${Folder}/*.h" "${Folder}/*.cpp")
		list(APPEND Headers ${Files})
	endforeach()
	list(REMOVE_DUPLICATES Headers)
	foreach(Header IN LISTS Headers)
		file(STRINGS "${Header}" Inlines REGEX "#[ \t]*include[ \t]*UE_INLINE_GENERATED_CPP_BY_NAME")
		foreach(Inline IN LISTS Inlines)
			string(REGEX REPLACE ".*\\([ \t]*([A-Za-z0-9_]*)[ \t]*\\).*" "\\1" Inline "${Inline}")
			list(APPEND InlineGenerated "${Inline}")
		endforeach()
	endforeach()
	foreach(Header IN LISTS Headers)
		file(STRINGS "${Header}" Include REGEX "#[ \t]*include[ \t]*\"[^\"]*\\.generated\\.h\"" LIMIT_COUNT 1)
		if(NOT Include)
			continue()
		endif()
		cmake_path(ABSOLUTE_PATH Header NORMALIZE)
		set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${Header}")
		string(REGEX REPLACE ".*\"([^\"]*)\\.generated\\.h\".*" "\\1" GeneratedName "${Include}")
		_drydock_generate_header("${Header}" "${GeneratedFolder}" "${GeneratedName}" Classes)
		if(Classes AND Header MATCHES "\\.h$" AND NOT GeneratedName IN_LIST InlineGenerated)
			list(APPEND SourceFiles "${GeneratedFolder}/${GeneratedName}.gen.cpp")
		endif()
	endforeach()

	set(ShaderFolder "")
	set(Mapping "")
	if(Arg_SHADERS)
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
	endif()
	list(GET SourceFiles 0 FirstSource)
	_drydock_plugin_folder("${FirstSource}" "${ShaderFolder}" PluginFolder)
	if(ShaderFolder)
		set(EngineShaderFolder "${PluginFolder}/Shaders")
		cmake_path(IS_PREFIX EngineShaderFolder "${ShaderFolder}" NORMALIZE bInside)
		if(bInside)
			set(ShaderFolder "${EngineShaderFolder}")
		endif()
		set(Mapping
			"const bool bMapped = (AddShaderSourceDirectoryMapping(TEXT(\"/Plugin/${Name}\"), TEXT(\"${ShaderFolder}\")), true);\n")
	endif()
	set(MappingFile "${GeneratedFolder}/${Name}ShaderDirectory.cpp")
	file(CONFIGURE OUTPUT "${MappingFile}" @ONLY CONTENT
"// Made by drydock_add_plugin: where the plugin and its shaders are.
#include \"Interfaces/IPluginManager.h\"
#include \"ShaderCore.h\"

namespace
{
@Mapping@const bool bRegistered = (IPluginManager::Get().RegisterPlugin(TEXT(\"@Name@\"), TEXT(\"@PluginFolder@\")), true);
} // namespace
")
	list(APPEND SourceFiles "${MappingFile}")

	add_library(${Name} SHARED ${SourceFiles})
	target_include_directories(${Name} PUBLIC ${Folders} PRIVATE "${GeneratedFolder}")
	target_link_libraries(${Name} PUBLIC drydock::drydock)
	target_compile_features(${Name} PUBLIC cxx_std_20)
	# The engine's export macros, one per module: a plugin is one library here.
	list(REMOVE_DUPLICATES ModuleNames)
	foreach(ModuleName IN LISTS ModuleNames)
		string(TOUPPER "${ModuleName}" ModuleName)
		target_compile_definitions(${Name} PUBLIC "${ModuleName}_API=")
	endforeach()
	# A plugin's own classes and functions are its own, whatever else in the process bears their names.
	target_link_options(${Name} PRIVATE LINKER:-Bsymbolic)
	if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
		# A library with unique symbols stays in memory: a rebuilt plugin could not take its place in `run --watch`.
		target_compile_options(${Name} PRIVATE -fno-gnu-unique)
	endif()
endfunction()
