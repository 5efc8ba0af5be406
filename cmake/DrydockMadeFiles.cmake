# Folders whose files are made when CMake configures.

# Removes every file below Folder that begins as made files do and is not among the files named after it: it was made
# earlier, and is not made now.
function(_drydock_remove_files_no_longer_made Folder)
	file(GLOB_RECURSE Present "${Folder}/*")
	list(REMOVE_ITEM Present ${ARGN})
	foreach(File IN LISTS Present)
		file(READ "${File}" Head LIMIT 80)
		if(Head MATCHES "^// (Made by drydock_add_plugin|The engine's name for what lies elsewhere in drydock)[:.]")
			file(REMOVE "${File}")
		endif()
	endforeach()
endfunction()
