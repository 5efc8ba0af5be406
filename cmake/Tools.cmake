# Tools: the verbs that no first run waits for, with the rooms that serve them alone. `./dev run` leaves them out
# (DRYDOCK_TOOLS=OFF) and compiles a fifth less; the first call of one of them adds them all. The file of a verb stands here
# where its row in VerbTable.inl is DRYDOCK_TOOL. The test of recipes builds without tools, and so finds a file that is missing.

option(DRYDOCK_TOOLS "Build the tools too: the rows DRYDOCK_TOOL of pipeline/Program/VerbTable.inl" ON)

# The files of tools, by their paths from the root.
set(DRYDOCK_TOOL_ROOMS Flicker Hazards Import Live Matrix Prove Scenes Study Sweep)
set(DRYDOCK_TOOL_VERBS Bless Build Diff Flicker Hazards Import Lint Live Matrix New Overlay Prove Scene Settings SettingsCube
	SettingsPlan Sheet Study Sweep Vet)
set(DRYDOCK_TOOL_PARTS Overlay/OverlayFiles Patch/PatchTemplate Report/DiffPage Report/MatrixPage Report/StudyPage)
list(JOIN DRYDOCK_TOOL_ROOMS "|" Rooms)
list(JOIN DRYDOCK_TOOL_VERBS "|" Verbs)
list(JOIN DRYDOCK_TOOL_PARTS "|" Parts)
set(DRYDOCK_TOOL_FILES "^pipeline/((${Rooms})/.*|Program/Verb(${Verbs})|${Parts})\\.cpp$")

# drydock_leave_out_tools(SOURCES): removes the tools from a list of files where nobody asked for them.
function(drydock_leave_out_tools OutSources)
	if(NOT DRYDOCK_TOOLS)
		set(Kept "")
		foreach(Source IN LISTS ${OutSources})
			cmake_path(RELATIVE_PATH Source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE File)
			if(NOT File MATCHES "${DRYDOCK_TOOL_FILES}")
				list(APPEND Kept ${Source})
			endif()
		endforeach()
		set(${OutSources} ${Kept} PARENT_SCOPE)
	endif()
endfunction()
