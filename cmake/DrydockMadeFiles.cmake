# Folders whose files are all made when CMake configures.

# Removes every file below Folder that is none of the files named after it: what was made earlier and no more.
function(_drydock_remove_files_no_longer_made Folder)
	file(GLOB_RECURSE Present "${Folder}/*")
	list(REMOVE_ITEM Present ${ARGN})
	if(Present)
		file(REMOVE ${Present})
	endif()
endfunction()
