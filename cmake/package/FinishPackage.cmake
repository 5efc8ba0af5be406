# Completes what cpack is about to pack. Folders can be read by everybody. The Debian package gets copyright, changelog and
# lintian's overrides, its manual page is compressed, and zsh's completion goes where Debian's zsh looks.

# The folder that is packed. A script that ran without it would change the machine's own files.
set(Staged ${CPACK_TEMPORARY_DIRECTORY})
if(NOT Staged MATCHES "/_CPack_Packages/" OR NOT IS_DIRECTORY ${Staged})
	message(FATAL_ERROR "\"${Staged}\" is not a folder that cpack packs")
endif()
set(FolderPermissions OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
file(CHMOD_RECURSE ${Staged} DIRECTORY_PERMISSIONS ${FolderPermissions})
if(NOT CPACK_GENERATOR STREQUAL "DEB")
	return()
endif()

set(Share ${Staged}/usr/share)
set(Documents ${Share}/doc/drydock)

# compress(FILE): into FILE.gz, always the same bytes for the same file.
function(compress File)
	execute_process(COMMAND gzip --best --no-name --force ${File} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ ${CMAKE_CURRENT_LIST_DIR}/changelog Changelog)
string(FIND "${Changelog}" "drydock (${CPACK_PACKAGE_VERSION}) " Entry)
if(NOT Entry EQUAL 0)
	message(FATAL_ERROR "cmake/package/changelog does not begin with an entry of version ${CPACK_PACKAGE_VERSION}")
endif()

# add(FILE FOLDER): a copy that everybody may read. file(INSTALL) would put DESTDIR before the folder.
function(add File Folder)
	file(COPY ${CMAKE_CURRENT_LIST_DIR}/${File} DESTINATION ${Folder}
		FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
		DIRECTORY_PERMISSIONS ${FolderPermissions})
endfunction()

add(copyright ${Documents})
add(changelog ${Documents})
add(lintian-overrides ${Share}/lintian/overrides)
file(RENAME ${Share}/lintian/overrides/lintian-overrides ${Share}/lintian/overrides/drydock)
compress(${Documents}/changelog)
compress(${Share}/man/man1/drydock.1)
file(MAKE_DIRECTORY ${Share}/zsh/vendor-completions)
file(RENAME ${Share}/zsh/site-functions/_drydock ${Share}/zsh/vendor-completions/_drydock)
file(REMOVE_RECURSE ${Share}/zsh/site-functions)
file(CHMOD_RECURSE ${Share} DIRECTORY_PERMISSIONS ${FolderPermissions})
