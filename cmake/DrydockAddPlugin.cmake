# drydock_add_plugin(NAME [FOLDER folder] [SOURCES file...] [SHADERS file...] [EXCLUDE pattern...] [UNITY])
#
# A plugin as Unreal has it: a shared library lib<NAME>.so whose extensions and shaders register themselves when it is
# loaded ("plugins": ["path/libNAME.so"] in a config, or linked to a program).
#
# FOLDER   The plugin's folder, where its .uplugin is; by default that of the CMakeLists.txt.
# SOURCES  C++ files, in one folder or in the engine's layout (Source/MODULE/Public and Private). Without SOURCES they are
#          found: those of the modules that the .uplugin and the .Build.cs files name, without modules of the editor and
#          without files that include its headers or Slate's; each that is left out is named. Definitions and folders of
#          the .Build.cs files count. Plugins that the .uplugin needs and that lie beside it are built and linked too.
#          Headers of a module are found as in the engine. A header with `#include "X.generated.h"` gets that file made
#          here, and its UCLASSes are registered, so that subsystems start by themselves; it is made again whenever the
#          header changes.
# SHADERS  .usf and .ush files; without SOURCES and SHADERS those below folders named Shaders. The virtual path
#          "/Plugin/<NAME>" means the plugin's folder Shaders where they lie in it, else their common folder, and so does
#          that of the .uplugin's name; the files are read in place, so that an edit is seen by the next run.
# EXCLUDE  What does not belong to it: paths from the plugin's folder on (a folder means all below it), names of files or of
#          modules, with * and ?. Headers too: their classes are not registered then.
# UNITY    The sources as one file, in the order of their names. The engine's build does so, and some published files lack
#          an include that another one before them has.
#
# Every file begins with what the engine's shared precompiled header brings (EngineSharedPCH.h), which is precompiled once
# for the plugin.
#
# IPluginManager::Get().FindPlugin(TEXT("<NAME>"))->GetBaseDir() is the folder of the nearest .uplugin file, else the one
# that holds Source or Shaders, else the folder of the CMakeLists.txt. It has the name of the .uplugin as well.

include("${CMAKE_CURRENT_LIST_DIR}/DrydockPluginSources.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/DrydockReflection.cmake")

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

# Does the part of Unreal's header tool that drydock needs, for Header, which is of Module: each UCLASS and USTRUCT gets
# its Super and ThisClass at the line of GENERATED_BODY, and a NAME.gen.cpp registers classes, fields and enums. OutMade
# is set if there is anything to register.
function(_drydock_generate_header Header GeneratedFolder Name Module OutMade)
	file(READ "${Header}" Text)
	string(MAKE_C_IDENTIFIER "FID_${Name}_h" FileId)
	# One list element per line: none empty, and nothing in them that means something to a list.
	string(REGEX REPLACE "\r" "" Text "${Text}")
	string(REGEX REPLACE "//[^\n]*" "" Text "${Text}")
	string(REGEX REPLACE "[][;\\]" " " Text "${Text}")
	string(REPLACE "\n" " ;" Text "${Text}")
	set(Macros "")
	set(Declarations "")
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
			string(APPEND Declarations "${Key} ${Class};\n")
			set(Body "public:")
			if(Base)
				string(APPEND Body " using Super = ${Base};")
			endif()
			string(APPEND Body " using ThisClass = ${Class}; template<typename> friend struct ::Drydock::TReflected;")
			if(Kind STREQUAL "UCLASS" AND Base)
				string(APPEND Body
					" static UClass* StaticClass() { return ::Drydock::FindClass<${Class}>(\"${Class}\", Super::StaticClass()); }")
			endif()
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
@Macros@
@Declarations@")
	set(Registrations "")
	foreach(Class IN LISTS Classes)
		string(APPEND Registrations "const Drydock::TClassRegistration<${Class}> GRegister${Class}(TEXT(\"${Class}\"));\n")
	endforeach()
	_drydock_reflect_header("${Header}" "${Module}" Reflection)
	file(CONFIGURE OUTPUT "${GeneratedFolder}/${Name}.gen.cpp" @ONLY CONTENT
"// Made by drydock_add_plugin: registers classes, fields and enums of @Header@.
#include \"@Header@\"

#include \"Subsystems/Subsystem.h\"
#include \"UObject/ReflectionMake.h\"

namespace
{
@Registrations@} // namespace

@Reflection@")
	set(${OutMade} OFF PARENT_SCOPE)
	if(Classes OR Reflection)
		set(${OutMade} ON PARENT_SCOPE)
	endif()
endfunction()

# Finds what a plugin that does not list its files consists of (_drydock_glob_plugin): its files in OutSources and
# OutShaders, the folders of its modules in OutModules.
function(_drydock_find_plugin_files Name Folder Excludes OutSources OutShaders OutModules)
	if(NOT IS_DIRECTORY "${Folder}")
		message(FATAL_ERROR "drydock_add_plugin(${Name}): there is no folder ${Folder}")
	endif()
	_drydock_find_modules("${Name}" "${Folder}" "${Excludes}" Modules LeftModules)
	set(Files "")
	foreach(Module IN LISTS Modules)
		_drydock_glob_plugin("${Module}" ModuleFiles "*.h" "*.hpp" "*.inl" "*.cpp")
		list(APPEND Files ${ModuleFiles})
	endforeach()
	list(REMOVE_DUPLICATES Files)
	set(Wanted "")
	foreach(File IN LISTS Files)
		_drydock_is_excluded("${File}" "${Folder}" "${Excludes}" Pattern)
		if(NOT Pattern)
			list(APPEND Wanted "${File}")
		elseif(File MATCHES "[.]cpp$")
			file(RELATIVE_PATH Path "${Folder}" "${File}")
			message(STATUS "${Name}: left out ${Path}: EXCLUDE ${Pattern}")
		endif()
	endforeach()
	_drydock_leave_out_tools("${Name}" "${Folder}" Kept ${Wanted})
	list(FILTER Kept INCLUDE REGEX "[.]cpp$")
	if(NOT Kept)
		message(FATAL_ERROR "drydock_add_plugin(${Name}): no sources found in ${Folder}: a plugin has a .uplugin file, and "
			"in Source/MODULE a MODULE.Build.cs beside its .cpp files. ${LeftModules}")
	endif()
	_drydock_glob_plugin("${Folder}" Shaders "*.usf" "*.ush")
	list(FILTER Shaders INCLUDE REGEX "/Shaders/")
	set(${OutSources} "${Kept}" PARENT_SCOPE)
	set(${OutShaders} "${Shaders}" PARENT_SCOPE)
	set(${OutModules} "${Modules}" PARENT_SCOPE)
endfunction()

# Builds the plugins that the one in Folder needs where they lie beside it: those of its .uplugin's "Plugins", and those
# that a Build.cs names as a module.
function(_drydock_add_needed_plugins Name Folder OutTargets)
	set(Plugins "")
	file(GLOB Descriptions "${Folder}/*.uplugin")
	foreach(Description IN LISTS Descriptions)
		_drydock_read_description("${Description}" Modules Plugins)
	endforeach()
	_drydock_glob_plugin("${Folder}" BuildFiles "*.Build.cs")
	file(GLOB Neighbours "${Folder}/../*/*.uplugin")
	foreach(BuildFile IN LISTS BuildFiles)
		file(READ "${BuildFile}" Text)
		foreach(Neighbour IN LISTS Neighbours)
			cmake_path(GET Neighbour STEM Plugin)
			cmake_path(GET Neighbour PARENT_PATH NeighbourFolder)
			cmake_path(NORMAL_PATH NeighbourFolder)
			string(FIND "${Text}" "\"${Plugin}\"" At)
			if(At GREATER_EQUAL 0 AND NOT NeighbourFolder STREQUAL Folder)
				list(APPEND Plugins "${Plugin}")
			endif()
		endforeach()
	endforeach()
	list(REMOVE_DUPLICATES Plugins)
	set(Targets "")
	foreach(Plugin IN LISTS Plugins)
		file(GLOB Found "${Folder}/../*/${Plugin}.uplugin")
		if(Found AND NOT TARGET ${Plugin})
			list(GET Found 0 Found)
			cmake_path(GET Found PARENT_PATH PluginFolder)
			cmake_path(NORMAL_PATH PluginFolder)
			drydock_add_plugin(${Plugin} FOLDER "${PluginFolder}")
			message(STATUS "${Name}: plugin ${Plugin}, which it needs, is built from ${PluginFolder}")
		elseif(NOT Found)
			message(STATUS "${Name}: plugin ${Plugin}, which it names, does not lie beside it")
		endif()
		if(TARGET ${Plugin})
			list(APPEND Targets ${Plugin})
		endif()
	endforeach()
	set(${OutTargets} "${Targets}" PARENT_SCOPE)
endfunction()

# The plugin's files as the compiler takes them: every one begins with the engine's shared header.
function(_drydock_precompile Name)
	if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
		target_compile_options(${Name} PRIVATE "SHELL:-include EngineSharedPCH.h")
	else()
		target_precompile_headers(${Name} PRIVATE <EngineSharedPCH.h>)
	endif()
endfunction()

function(drydock_add_plugin Name)
	cmake_parse_arguments(PARSE_ARGV 1 Arg "UNITY" "FOLDER" "SOURCES;SHADERS;EXCLUDE")
	if(Arg_UNPARSED_ARGUMENTS)
		message(FATAL_ERROR "drydock_add_plugin(${Name}): unknown arguments ${Arg_UNPARSED_ARGUMENTS}; "
			"expected FOLDER, SOURCES, SHADERS, EXCLUDE and UNITY")
	endif()
	set(Root "${CMAKE_CURRENT_SOURCE_DIR}")
	if(Arg_FOLDER)
		cmake_path(ABSOLUTE_PATH Arg_FOLDER BASE_DIRECTORY "${Root}" NORMALIZE OUTPUT_VARIABLE Root)
		string(REGEX REPLACE "/$" "" Root "${Root}")
	endif()
	set(Needed "")
	if(NOT Arg_SOURCES)
		_drydock_require_files("${Name}" "${Root}")
		_drydock_add_needed_plugins("${Name}" "${Root}" Needed)
	endif()
	set_property(GLOBAL PROPERTY DRYDOCK_USED_EXCLUDES "")
	set(FoundModules "")
	if(NOT Arg_SOURCES)
		_drydock_find_plugin_files("${Name}" "${Root}" "${Arg_EXCLUDE}" Arg_SOURCES FoundShaders FoundModules)
		if(NOT Arg_SHADERS)
			set(Arg_SHADERS ${FoundShaders})
		endif()
	endif()

	set(GeneratedFolder "${CMAKE_CURRENT_BINARY_DIR}/${Name}.generated")
	file(MAKE_DIRECTORY "${GeneratedFolder}")
	set(Folders "")       # where `#include` looks
	set(ModuleFolders "") # whose headers are read
	set(ModuleNames "${Name}")
	set(SourceFiles "")
	foreach(Source IN LISTS Arg_SOURCES)
		cmake_path(ABSOLUTE_PATH Source BASE_DIRECTORY "${Root}" NORMALIZE)
		if(NOT EXISTS "${Source}")
			message(FATAL_ERROR "drydock_add_plugin(${Name}): source file ${Source} does not exist")
		endif()
		_drydock_is_excluded("${Source}" "${Root}" "${Arg_EXCLUDE}" Pattern)
		if(Pattern)
			continue()
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
	set(Definitions "")
	foreach(Module IN LISTS FoundModules)
		cmake_path(GET Module FILENAME ModuleName)
		list(APPEND ModuleNames "${ModuleName}")
		list(APPEND ModuleFolders "${Module}")
		_drydock_read_build_file("${Module}" "${Root}" BuildFolders BuildDefinitions)
		# As the engine has it, a header is found from Source on as well: "MyModule/Public/X.h".
		cmake_path(GET Module PARENT_PATH Parent)
		list(APPEND Folders ${BuildFolders} "${Parent}")
		list(APPEND Definitions ${BuildDefinitions})
	endforeach()
	list(REMOVE_DUPLICATES Folders)
	list(REMOVE_DUPLICATES ModuleFolders)
	list(REMOVE_DUPLICATES Definitions)

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
	set(OwnSources "") # those that are left out too
	foreach(Header IN LISTS Headers)
		if(Header MATCHES "[.]cpp$")
			cmake_path(ABSOLUTE_PATH Header NORMALIZE)
			list(APPEND OwnSources "${Header}")
		endif()
	endforeach()
	list(FILTER Headers EXCLUDE REGEX "/(Intermediate|Binaries)/")
	set(Wanted "")
	foreach(Header IN LISTS Headers)
		_drydock_is_excluded("${Header}" "${Root}" "${Arg_EXCLUDE}" Pattern)
		if(NOT Pattern)
			list(APPEND Wanted "${Header}")
		endif()
	endforeach()
	set(Headers ${Wanted})
	if(FoundModules)
		_drydock_leave_out_tools("" "${Root}" Headers ${Headers})
		list(REMOVE_ITEM Headers "")
	endif()
	set(OwnFolders ${Folders})
	foreach(Plugin IN LISTS Needed)
		get_target_property(NeededFolders ${Plugin} INTERFACE_INCLUDE_DIRECTORIES)
		list(APPEND OwnFolders ${NeededFolders})
	endforeach()
	_drydock_make_headers("${Name}" "${GeneratedFolder}" "${OwnFolders}" ${Headers})
	set(DrydockSourceText "") # _drydock_reflect_function looks for definitions
	foreach(Header IN LISTS Headers)
		file(READ "${Header}" Text)
		string(APPEND DrydockSourceText "${Text}")
	endforeach()
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
		set(HeaderModule "${Name}")
		if(Header MATCHES "/Source/([^/]+)/")
			set(HeaderModule "${CMAKE_MATCH_1}")
		endif()
		_drydock_generate_header("${Header}" "${GeneratedFolder}" "${GeneratedName}" "${HeaderModule}" bMade)
		# Nothing is registered for a header whose .cpp file is left out: the .cpp file's definitions are missing.
		cmake_path(GET Header STEM HeaderStem)
		foreach(Source IN LISTS OwnSources)
			if(Source MATCHES "/${HeaderStem}[.]cpp$" AND NOT Source IN_LIST SourceFiles)
				set(bMade OFF)
			endif()
		endforeach()
		if(bMade AND Header MATCHES "\\.h$" AND NOT GeneratedName IN_LIST InlineGenerated)
			list(APPEND SourceFiles "${GeneratedFolder}/${GeneratedName}.gen.cpp")
			set_source_files_properties("${GeneratedFolder}/${GeneratedName}.gen.cpp"
				PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
		endif()
	endforeach()

	set(ShaderFolder "")
	if(Arg_SHADERS)
		foreach(Shader IN LISTS Arg_SHADERS)
			cmake_path(ABSOLUTE_PATH Shader BASE_DIRECTORY "${Root}" NORMALIZE)
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
	endif()
	get_property(UsedExcludes GLOBAL PROPERTY DRYDOCK_USED_EXCLUDES)
	foreach(Pattern IN LISTS Arg_EXCLUDE)
		if(NOT Pattern IN_LIST UsedExcludes)
			message(FATAL_ERROR "drydock_add_plugin(${Name}): EXCLUDE ${Pattern} matches nothing; expected a path from "
				"${Root} on, a file's name or a module's, with * and ? for what differs")
		endif()
	endforeach()
	# The engine knows a plugin by its .uplugin.
	set(PluginNames "${Name}")
	file(GLOB Descriptions CONFIGURE_DEPENDS "${PluginFolder}/*.uplugin")
	foreach(Description IN LISTS Descriptions)
		cmake_path(GET Description STEM PluginName)
		list(APPEND PluginNames "${PluginName}")
	endforeach()
	list(REMOVE_DUPLICATES PluginNames)
	set(Registrations "")
	set(Mapping "")
	foreach(PluginName IN LISTS PluginNames)
		string(MAKE_C_IDENTIFIER "${PluginName}" Identifier)
		string(APPEND Registrations
			"const bool bRegistered_${Identifier} = (IPluginManager::Get().RegisterPlugin(TEXT(\"${PluginName}\"), TEXT(\"${PluginFolder}\")), true);\n")
		if(ShaderFolder)
			string(APPEND Mapping
				"const bool bMapped_${Identifier} = (Drydock::MapPluginShaders(\"/Plugin/${PluginName}\", \"${ShaderFolder}\"), true);\n")
		endif()
	endforeach()
	set(MappingFile "${GeneratedFolder}/${Name}ShaderDirectory.cpp")
	file(CONFIGURE OUTPUT "${MappingFile}" @ONLY CONTENT
"// Made by drydock_add_plugin: where the plugin and its shaders are.
#include \"DrydockHeadersMark.h\"
#include \"Interfaces/IPluginManager.h\"
#include \"ShaderCore.h\"

extern \"C\" const char DRYDOCK_HEADERS_MARK;

namespace
{
[[gnu::used]] const char* const Headers = &DRYDOCK_HEADERS_MARK;
@Mapping@@Registrations@} // namespace
")
	list(APPEND SourceFiles "${MappingFile}")
	set_source_files_properties("${MappingFile}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)

	add_library(${Name} SHARED ${SourceFiles})
	target_include_directories(${Name} PUBLIC ${Folders} "${GeneratedFolder}"
		PRIVATE "${GeneratedFolder}/${_DrydockFolderBelowEngine}")
	# Behind all other folders: a header that a project makes later is not hidden by an empty one.
	target_compile_options(${Name} PRIVATE "SHELL:-idirafter \"${GeneratedFolder}/absent\"")
	target_link_libraries(${Name} PUBLIC drydock::drydock ${Needed})
	target_compile_features(${Name} PUBLIC cxx_std_20)
	target_compile_definitions(${Name} PRIVATE ${Definitions})
	target_compile_options(${Name} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-ferror-limit=0>)
	_drydock_precompile(${Name})
	if(Arg_UNITY)
		set_target_properties(${Name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
	endif()
	# The engine's export macros, one per module: a plugin is one library here. Sources without a Build.cs name theirs.
	list(TRANSFORM ModuleNames TOUPPER)
	list(TRANSFORM ModuleNames APPEND "_API")
	foreach(Header IN LISTS Headers)
		file(STRINGS "${Header}" Lines REGEX "^[ \t]*(class|struct)[ \t]+[A-Z0-9_]+_API[ \t]")
		foreach(Line IN LISTS Lines)
			string(REGEX MATCH "[A-Z0-9_]+_API" Macro "${Line}")
			list(APPEND ModuleNames "${Macro}")
		endforeach()
	endforeach()
	list(REMOVE_DUPLICATES ModuleNames)
	list(REMOVE_ITEM ModuleNames DRYDOCK_API)
	list(TRANSFORM ModuleNames APPEND "=")
	target_compile_definitions(${Name} PUBLIC ${ModuleNames})
	# A plugin's own classes and functions are its own, whatever else in the process bears their names.
	target_link_options(${Name} PRIVATE LINKER:-Bsymbolic)
	if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
		# A library with unique symbols stays in memory: a rebuilt plugin could not take its place in `run --watch`.
		target_compile_options(${Name} PRIVATE -fno-gnu-unique)
	endif()
endfunction()
