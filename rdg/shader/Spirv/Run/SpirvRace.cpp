// Remembers of each number who touched it last since the last barrier.
#include "SpirvRace.h"

namespace Drydock
{

using namespace Spirv;

void FRaceFinder::Begin(size_t NumWords)
{
	Words.assign(NumWords, FWord());
	Races.clear();
	Reads.clear();
	Known.clear();
	Epoch = 1;
}

void FRaceFinder::Touch(
	uint32_t Thread, uint32_t WordIndex, const FSpirvStep& Step, ESharedAccess Access, uint64_t Value)
{
	FWord& Word = Words.at(WordIndex);
	if (Thread == Followed && Access == ESharedAccess::Read)
	{
		const FTouch& Changer = Word.Changers.Touches[0];
		const FTouch& Last = Changer.Step && Changer.Epoch >= Word.Writer.Epoch ? Changer : Word.Writer;
		Reads.push_back({&Step, Last.Thread, Last.Step});
	}
	const auto Meet = [&](const FTouch& Other, ESharedAccess AccessBefore)
	{
		const bool bSameValue =
			Access == ESharedAccess::Write && AccessBefore == ESharedAccess::Write && Other.Value == Value;
		if (Other.Epoch == Epoch && Other.Thread != Thread && !bSameValue &&
			Known.insert({&Step, Other.Step, Thread}).second)
		{
			Races.push_back({&Step, Other.Step, Thread, Other.Thread, WordIndex, Access, AccessBefore});
		}
	};
	const auto MeetBoth = [&Meet](const FLastTwo& Others, ESharedAccess AccessBefore)
	{
		Meet(Others.Touches[0], AccessBefore);
		Meet(Others.Touches[1], AccessBefore);
	};
	Meet(Word.Writer, ESharedAccess::Write);
	if (Access != ESharedAccess::Atomic)
	{
		MeetBoth(Word.Changers, ESharedAccess::Atomic);
	}
	// Who writes what was written already changes nothing for those that read it.
	const bool bChanges = Access == ESharedAccess::Atomic || Word.Writer.Epoch != Epoch || Word.Writer.Value != Value;
	if (Access != ESharedAccess::Read && bChanges)
	{
		MeetBoth(Word.Readers, ESharedAccess::Read);
	}
	const FTouch New = {Epoch, Thread, &Step, Value};
	switch (Access)
	{
	case ESharedAccess::Read:
		Word.Readers.Add(New);
		break;
	case ESharedAccess::Write:
		Word.Writer = New;
		break;
	case ESharedAccess::Atomic:
		Word.Changers.Add(New);
		break;
	}
}

std::string DescribeRace(const FSpirvProgram& Program, const FSpirvRace& Race, const std::string& ThreadBefore)
{
	const FSpirvModule& Module = Program.Module;
	std::string Place = "groupshared memory";
	for (size_t i = 0; i < Module.Variables.size(); ++i)
	{
		const FSpirvMemory& Memory = Program.Memory[i];
		const uint32_t Word = Program.Groupshared.First + Race.Word;
		if (Module.Variables[i].Storage != StorageWorkgroup || Word < Memory.First ||
			Word >= Memory.First + Memory.Size)
		{
			continue;
		}
		const FSpirvType& Type = Module.GetType(Module.Variables[i].Type);
		const uint32_t Size = Type.Kind == ESpirvType::Array ? Module.GetType(Type.Element).NumScalars : 0;
		Place = Module.Variables[i].Name +
				(Size ? "[" + std::to_string((Word - Memory.First) / Size) + "]" : std::string());
	}
	const auto Verb = [](ESharedAccess Access, const char* Read, const char* Write, const char* Atomic)
	{
		return Access == ESharedAccess::Read ? Read : Access == ESharedAccess::Write ? Write : Atomic;
	};
	return std::string(Verb(Race.Access, "a read of ", "a write to ", "an atomic operation on ")) + Place +
		   ", which thread " + ThreadBefore + Verb(Race.AccessBefore, " reads", " writes", " changes atomically") +
		   " in line " + std::to_string(Race.Before->I->Line) + ": no barrier is between";
}

} // namespace Drydock
