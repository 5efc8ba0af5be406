# Test programs with few units: several test files are included by one, each in a namespace of its own, so that the headers
# which they share are read once and their names cannot clash. The preset `debug` compiles each file alone.
#
# As a script (cmake -DUNIT=FILE -DSOURCES=LIST -P TestUnits.cmake) it writes one such unit: first the headers with which the
# test files begin, so that none of them is read inside a namespace, then the files.

if(CMAKE_SCRIPT_MODE_FILE)
	set(Headers "")
	set(Bodies "")
	foreach(Source IN LISTS SOURCES)
		cmake_path(GET Source PARENT_PATH Folder)
		cmake_path(GET Source STEM Name)
		file(READ ${Source} Text)
		# The head: comments, includes and empty lines.
		string(REGEX MATCH "^((//[^\n]*|#include [^\n]*|)\n)*" Head "${Text}")
		string(REGEX MATCHALL "#include [<\"][^\n]+[>\"]" Includes "${Head}")
		foreach(Include IN LISTS Includes)
			string(REGEX REPLACE "#include .(.+)." "\\1" Header "${Include}")
			if(EXISTS ${Folder}/${Header})
				set(Include "#include \"${Folder}/${Header}\"")
			endif()
			list(APPEND Headers ${Include})
		endforeach()
		string(APPEND Bodies "\nnamespace ${Name}Unit\n{\n#include \"${Source}\"\n} // namespace ${Name}Unit\n")
	endforeach()
	# Libraries' headers first, then those of tests, which include libraries too: drydock's headers define the engine's
	# macros, such as check.
	list(REMOVE_DUPLICATES Headers)
	foreach(First IN ITEMS "Test" "<")
		set(Those ${Headers})
		list(FILTER Those INCLUDE REGEX "${First}")
		list(FILTER Headers EXCLUDE REGEX "${First}")
		list(PREPEND Headers ${Those})
	endforeach()
	list(JOIN Headers "\n" Headers)
	file(CONFIGURE OUTPUT ${UNIT} CONTENT "// Written by TestUnits.cmake.\n${Headers}\n${Bodies}" @ONLY)
	return()
endif()

# How many test files one unit has at most: an edit of one of them compiles them all.
set(DRYDOCK_TEST_UNIT_FILES 16)

# drydock_unite_tests(TARGET SOURCES): the list's *Test.cpp become a few units of their folder each; other files, and those
# that write into namespaces of others, stay.
function(drydock_unite_tests Target OutSources)
	if(NOT DRYDOCK_UNITY)
		return()
	endif()
	set(United "")
	set(Folders "")
	foreach(Source IN LISTS ${OutSources})
		file(STRINGS ${Source} Named REGEX "^namespace [A-Za-z_:]+$|^RDG_REGISTER_BLACKBOARD_STRUCT|^DRYDOCK_REFLECT" LIMIT_COUNT 1)
		if(Named OR NOT Source MATCHES "Test\\.cpp$")
			list(APPEND United ${Source})
			continue()
		endif()
		cmake_path(GET Source PARENT_PATH Folder)
		cmake_path(GET Folder FILENAME Folder)
		list(APPEND Folders ${Folder})
		list(APPEND ${Folder}_Files ${Source})
	endforeach()
	list(REMOVE_DUPLICATES Folders)
	foreach(Folder IN LISTS Folders)
		list(LENGTH ${Folder}_Files Count)
		math(EXPR Last "(${Count} - 1) / ${DRYDOCK_TEST_UNIT_FILES}")
		foreach(Part RANGE ${Last})
			math(EXPR Begin "${Part} * ${DRYDOCK_TEST_UNIT_FILES}")
			list(SUBLIST ${Folder}_Files ${Begin} ${DRYDOCK_TEST_UNIT_FILES} Files)
			set(Unit ${CMAKE_CURRENT_BINARY_DIR}/units/${Target}/${Folder}_${Part}.cpp)
			add_custom_command(OUTPUT ${Unit}
				COMMAND ${CMAKE_COMMAND} "-DUNIT=${Unit}" "-DSOURCES=${Files}" -P ${PROJECT_SOURCE_DIR}/cmake/TestUnits.cmake
				DEPENDS ${Files} ${PROJECT_SOURCE_DIR}/cmake/TestUnits.cmake
				COMMENT "" VERBATIM)
			list(APPEND United ${Unit})
		endforeach()
	endforeach()
	set(${OutSources} ${United} PARENT_SCOPE)
endfunction()
