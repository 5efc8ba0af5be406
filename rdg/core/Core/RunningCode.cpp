// Keeps for each thread whose code runs on it, and where plugins lie in memory.
#include "RunningCode.h"

#include "PrintText.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <link.h>
#include <utility>

namespace Drydock
{

namespace
{

thread_local const FCodeOwner* GOwner = nullptr;
thread_local FRunningWords GWords;

void SetWords(const FCodeOwner* Owner)
{
	const std::string Text = Owner != nullptr ? Owner->Describe() : "";
	const size_t Length = std::min(Text.size(), sizeof(GWords.Text) - 1);
	GWords.Text[0] = '\0'; // a handler may read it at any moment
	GWords.bForeign = Owner != nullptr && Owner->IsForeign();
	if (Length > 0)
	{
		std::memcpy(GWords.Text + 1, Text.data() + 1, Length - 1);
		GWords.Text[Length] = '\0';
		GWords.Text[0] = Text[0];
	}
}

/** The addresses of one plugin. End is written last, so that a handler never sees half a range. */
struct FPluginRange
{
	std::atomic<uintptr_t> Begin{0};
	std::atomic<uintptr_t> End{0};
	char Name[128] = "";
};

constexpr size_t MaxPluginRanges = 64; // more are not found by address, only by their scopes
FPluginRange GPluginRanges[MaxPluginRanges];

struct FWantedObject
{
	uintptr_t Address;
	uintptr_t Begin = 0;
	uintptr_t End = 0;
};

int FindObject(dl_phdr_info* Info, size_t, void* Data)
{
	auto& Wanted = *static_cast<FWantedObject*>(Data);
	uintptr_t Begin = UINTPTR_MAX;
	uintptr_t End = 0;
	for (int Index = 0; Index < Info->dlpi_phnum; ++Index)
	{
		const auto& Segment = Info->dlpi_phdr[Index];
		if (Segment.p_type == PT_LOAD)
		{
			Begin = std::min<uintptr_t>(Begin, Info->dlpi_addr + Segment.p_vaddr);
			End = std::max<uintptr_t>(End, Info->dlpi_addr + Segment.p_vaddr + Segment.p_memsz);
		}
	}
	if (Wanted.Address < Begin || Wanted.Address >= End)
	{
		return 0;
	}
	Wanted.Begin = Begin;
	Wanted.End = End;
	return 1;
}

} // namespace

std::string FCodeOwner::Describe() const
{
	std::string Text = Plugin.empty() ? "" : "plugin " + Plugin;
	Text += (Text.empty() || Callback.empty() ? "" : ", ") + Callback;
	return MakePrintable(
		Text + (Text.empty() || Pass.empty() ? "" : ", ") + (Pass.empty() ? "" : "pass " + Pass), false);
}

const FCodeOwner* GetRunningCode()
{
	return GOwner;
}

bool IsForeignCodeRunning()
{
	return GOwner != nullptr && GOwner->IsForeign();
}

FCodeOwner MakeCodeOwner(const std::string& Callback)
{
	return {GOwner != nullptr ? GOwner->Plugin : "", Callback, {}, {}, 0};
}

const FCodeOwner* ExchangeRunningCode(const FCodeOwner* Owner)
{
	SetWords(Owner);
	return std::exchange(GOwner, Owner);
}

const FRunningWords& GetRunningWords()
{
	return GWords;
}

FBorrowedCode::FBorrowedCode(const FCodeOwner* Owner, const FRunningWords& Words)
	: OwnerBefore(std::exchange(GOwner, Owner))
	, WordsBefore(GWords)
{
	GWords = Words;
}

FBorrowedCode::~FBorrowedCode()
{
	GWords = WordsBefore;
	GOwner = OwnerBefore;
}

void NotePluginCode(const std::string& Plugin, const void* Anything)
{
	FWantedObject Wanted{reinterpret_cast<uintptr_t>(Anything)};
	dl_iterate_phdr(FindObject, &Wanted);
	for (FPluginRange& Range : GPluginRanges)
	{
		if (Range.End == 0 && Wanted.End != 0)
		{
			std::snprintf(Range.Name, sizeof(Range.Name), "%s", Plugin.c_str());
			Range.Begin = Wanted.Begin;
			Range.End = Wanted.End;
			return;
		}
	}
}

void ForgetPluginCode(const std::string& Plugin)
{
	for (FPluginRange& Range : GPluginRanges)
	{
		if (Plugin == Range.Name)
		{
			Range.End = 0;
		}
	}
}

const char* FindPluginCode(const void* Address, uint64& OutOffset)
{
	const uintptr_t Wanted = reinterpret_cast<uintptr_t>(Address);
	for (const FPluginRange& Range : GPluginRanges)
	{
		if (Wanted < Range.End && Wanted >= Range.Begin)
		{
			OutOffset = Wanted - Range.Begin;
			return Range.Name;
		}
	}
	return nullptr;
}

} // namespace Drydock
