// Lists the features that a view shows: one bit per feature. Source: engine ShowFlags.h.
#pragma once

#include "CoreMinimal.h"

enum EShowFlagInitMode
{
	ESFIM_Game,
	ESFIM_Editor,
	ESFIM_VREditing,
	ESFIM_All0,
};

struct FEngineShowFlags
{
#define DRYDOCK_SHOWFLAG(Name, InGame, Doc) \
	uint32 Name : 1; \
	void Set##Name(bool bValue) \
	{ \
		Name = bValue ? 1 : 0; \
	}
#include "ShowFlagsValues.inl"
#undef DRYDOCK_SHOWFLAG

	DRYDOCK_API explicit FEngineShowFlags(EShowFlagInitMode Mode = ESFIM_Game);

	/** Index of a flag by its name, ignoring case; INDEX_NONE when there is none. */
	static DRYDOCK_API int32 FindIndexByName(const TCHAR* Name);

	/** Index: as found by name. */
	DRYDOCK_API bool GetSingleFlag(uint32 Index) const;
	DRYDOCK_API void SetSingleFlag(uint32 Index, bool bSet);
};

namespace Drydock
{

struct FShowFlagInfo
{
	const char* Name;
	bool bInGame;
	const char* Doc;
};

/** All flags, in the order of their indices. */
DRYDOCK_API TConstArrayView<FShowFlagInfo> GetShowFlagInfos();

} // namespace Drydock
