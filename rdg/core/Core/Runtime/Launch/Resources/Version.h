// The engine version that `#if` code sees. 5.4 unless the command line says otherwise (-DENGINE_MINOR_VERSION=6).
// Source: engine Runtime/Launch/Resources/Version.h.
#pragma once

#ifndef ENGINE_MAJOR_VERSION
#define ENGINE_MAJOR_VERSION 5
#endif
#ifndef ENGINE_MINOR_VERSION
#define ENGINE_MINOR_VERSION 4
#endif
#ifndef ENGINE_PATCH_VERSION
#define ENGINE_PATCH_VERSION 0
#endif

/** True if the engine is older than Major.Minor.Patch. */
#define UE_VERSION_OLDER_THAN(Major, Minor, Patch) \
	(ENGINE_MAJOR_VERSION < (Major) || \
		(ENGINE_MAJOR_VERSION == (Major) && \
			(ENGINE_MINOR_VERSION < (Minor) || (ENGINE_MINOR_VERSION == (Minor) && ENGINE_PATCH_VERSION < (Patch)))))

/** True if the engine is Major.Minor.Patch or newer. */
#define UE_VERSION_NEWER_THAN_OR_EQUAL(Major, Minor, Patch) (!UE_VERSION_OLDER_THAN(Major, Minor, Patch))
