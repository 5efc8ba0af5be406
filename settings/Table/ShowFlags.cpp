// Names of show flags, and how they are set by name. Source: engine ShowFlags.cpp.
#include "ShowFlags.h"

#include <strings.h>

namespace
{

constexpr Drydock::FShowFlagInfo ShowFlagInfos[] = {
#define DRYDOCK_SHOWFLAG(Name, InGame, Doc) {#Name, InGame, Doc},
#include "ShowFlagsValues.inl"
#undef DRYDOCK_SHOWFLAG
};

constexpr uint32 NumShowFlags = sizeof(ShowFlagInfos) / sizeof(ShowFlagInfos[0]);

} // namespace

FEngineShowFlags::FEngineShowFlags(EShowFlagInitMode Mode)
{
	for (uint32 Index = 0; Index < NumShowFlags; ++Index)
	{
		SetSingleFlag(Index, Mode != ESFIM_All0 && ShowFlagInfos[Index].bInGame);
	}
}

int32 FEngineShowFlags::FindIndexByName(const TCHAR* Name)
{
	for (uint32 Index = 0; Index < NumShowFlags; ++Index)
	{
		if (strcasecmp(ShowFlagInfos[Index].Name, Name) == 0)
		{
			return static_cast<int32>(Index);
		}
	}
	return INDEX_NONE;
}

bool FEngineShowFlags::GetSingleFlag(uint32 Index) const
{
	uint32 Current = 0;
#define DRYDOCK_SHOWFLAG(Name, InGame, Doc) \
	if (Current++ == Index) \
	{ \
		return Name != 0; \
	}
#include "ShowFlagsValues.inl"
#undef DRYDOCK_SHOWFLAG
	checkf(false, TEXT("show flag %u of %u"), Index, Current);
	return false;
}

void FEngineShowFlags::SetSingleFlag(uint32 Index, bool bSet)
{
	uint32 Current = 0;
#define DRYDOCK_SHOWFLAG(Name, InGame, Doc) \
	if (Current++ == Index) \
	{ \
		Name = bSet ? 1 : 0; \
		return; \
	}
#include "ShowFlagsValues.inl"
#undef DRYDOCK_SHOWFLAG
	checkf(false, TEXT("show flag %u of %u"), Index, Current);
}

TConstArrayView<Drydock::FShowFlagInfo> Drydock::GetShowFlagInfos()
{
	return TConstArrayView<FShowFlagInfo>(ShowFlagInfos, static_cast<int32>(NumShowFlags));
}
