# Unity builds by room: a few files of one folder are compiled as one unit, so that the headers which they share are read
# once. Names in anonymous namespaces are therefore distinct within a room. Tools are units of their own (Tools.cmake). The
# preset `debug` compiles each file alone.

# How many files one unit has at most: an edit of one of them compiles them all.
set(DRYDOCK_UNITY_FILES 10)

# drydock_unite_rooms(TARGET): files with compile options or definitions of their own stay alone (CMake sees to it), and so
# does the one that includes CLI11, which takes as long as ten others.
function(drydock_unite_rooms Target)
	if(NOT DRYDOCK_UNITY)
		return()
	endif()
	set_target_properties(${Target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
	set_source_files_properties(${PROJECT_SOURCE_DIR}/pipeline/Program/ArgumentParser.cpp PROPERTIES
		SKIP_UNITY_BUILD_INCLUSION ON)
	get_target_property(Sources ${Target} SOURCES)
	foreach(Source IN LISTS Sources)
		cmake_path(RELATIVE_PATH Source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE Room)
		set(Tools "")
		if(Room MATCHES "${DRYDOCK_TOOL_FILES}")
			set(Tools Tools)
		endif()
		string(REGEX MATCH "^(rdg/(core|graph|shader/Spirv|shader)/[^/.]+/|[^/]+(/[^/.]+/)?)" Room ${Room})
		string(MAKE_C_IDENTIFIER "${Room}${Tools}" Room)
		if(NOT DEFINED Count_${Room})
			set(Count_${Room} 0)
		endif()
		math(EXPR Part "${Count_${Room}} / ${DRYDOCK_UNITY_FILES} + 1")
		math(EXPR Count_${Room} "${Count_${Room}} + 1")
		set_source_files_properties(${Source} PROPERTIES UNITY_GROUP ${Room}_${Part})
	endforeach()
endfunction()
