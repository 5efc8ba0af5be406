# Lane code: built once for each instruction set, and chosen at run time (rdg/shader/Lanes/LanesDispatch.h).

# The widest float lanes of the CPU that builds: 4, 8 or 16.
function(drydock_find_native_lanes OutLanes)
	file(WRITE ${PROJECT_BINARY_DIR}/NativeLanes.cpp
		"#include \"${PROJECT_SOURCE_DIR}/rdg/shader/Lanes/CpuLanes.h\"\nint main() { return Drydock::GetCpuLanes(); }\n")
	try_run(NATIVE_LANES bCompiled ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}/NativeLanes.cpp)
	set(${OutLanes} ${NATIVE_LANES} PARENT_SCOPE)
endfunction()

# The float lanes that code is built for. On other processors than x86-64 there is one instruction set, which has them all.
set(DRYDOCK_BUILT_LANES 4 8 16)
if(NOT DRYDOCK_INSTRUCTION_SETS MATCHES "^(native|all)$")
	message(FATAL_ERROR "DRYDOCK_INSTRUCTION_SETS is ${DRYDOCK_INSTRUCTION_SETS}; expected native or all")
endif()
if(DRYDOCK_INSTRUCTION_SETS STREQUAL "native" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
	drydock_find_native_lanes(DRYDOCK_BUILT_LANES)
	message(STATUS "Lane code is built for this CPU alone: ${DRYDOCK_BUILT_LANES} float lanes")
endif()

# The kernels of passes/Native with lanes: XLanes.inl has Drydock::TXLanes, which is made once for each number of lanes.
set(DRYDOCK_NATIVE_LANES BloomSetup BoxSum TapSum TexelSum Tonemap)

# drydock_add_native_lanes(SOURCES): writes the files that make them, and adds them to a list with passes/Native in it.
function(drydock_add_native_lanes OutSources)
	set(Sources ${${OutSources}})
	if(Sources MATCHES "/passes/Native/")
		foreach(Kernel IN LISTS DRYDOCK_NATIVE_LANES)
			foreach(Level IN ITEMS "sse;4" "avx2;8" "avx512;16")
				list(GET Level 0 Name)
				list(GET Level 1 Lanes)
				set(File ${PROJECT_BINARY_DIR}/lanes/${Kernel}_${Name}.cpp)
				file(CONFIGURE OUTPUT ${File} CONTENT
					"#include \"Native/${Kernel}Lanes.inl\"\n\ntemplate struct Drydock::T${Kernel}Lanes<${Lanes}>;\n")
				list(APPEND Sources ${File})
			endforeach()
		endforeach()
	endif()
	set(${OutSources} ${Sources} PARENT_SCOPE)
endfunction()

# drydock_set_instruction_sets(SOURCES): gives *_sse.cpp, *_avx2.cpp and *_avx512.cpp of the list their instruction set, and
# removes those for which nothing is built. *Sampling_sse.cpp stays: the interpreter's one lane is in it.
function(drydock_set_instruction_sets OutSources)
	if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
		return()
	endif()
	set(Sources ${${OutSources}})
	foreach(Level IN ITEMS "sse;x86-64-v2;4" "avx2;x86-64-v3;8" "avx512;x86-64-v4;16")
		list(GET Level 0 Name)
		list(GET Level 1 Arch)
		list(GET Level 2 Lanes)
		set(OfLevel ${Sources})
		list(FILTER OfLevel INCLUDE REGEX "_${Name}\\.cpp$")
		set_source_files_properties(${OfLevel} PROPERTIES COMPILE_OPTIONS "-march=${Arch}" SKIP_PRECOMPILE_HEADERS ON)
		if(NOT Lanes IN_LIST DRYDOCK_BUILT_LANES)
			list(FILTER OfLevel EXCLUDE REGEX "Sampling_sse\\.cpp$")
			list(REMOVE_ITEM Sources ${OfLevel})
		endif()
	endforeach()
	set(${OutSources} ${Sources} PARENT_SCOPE)
endfunction()
