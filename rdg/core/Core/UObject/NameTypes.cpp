// Keeps the table of all names that FName's numbers stand for.
#include "UObject/NameTypes.h"

#include "Containers/Map.h"

#include <deque>
#include <mutex>

namespace
{

class FNameTable
{
public:
	static FNameTable& Get()
	{
		static FNameTable Table;
		return Table;
	}

	uint32 FindOrAdd(const TCHAR* Text, EFindName FindType)
	{
		std::lock_guard Lock(Mutex);
		const FString Key(Text);
		if (const uint32* Found = Indices.Find(Key))
		{
			return *Found;
		}
		if (FindType == FNAME_Find)
		{
			return 0;
		}
		const uint32 Index = static_cast<uint32>(Names.size());
		Names.push_back(Key);
		Indices.Add(Key, Index);
		return Index;
	}

	/** Stays valid: a deque does not move its elements. */
	const FString& GetText(uint32 Index)
	{
		std::lock_guard Lock(Mutex);
		return Names[Index];
	}

private:
	FNameTable()
	{
		Names.push_back("None");
		Indices.Add("None", 0u);
		Indices.Add("", 0u);
	}

	std::mutex Mutex;
	std::deque<FString> Names;
	TMap<FString, uint32> Indices; // FString keys ignore case, as names do
};

} // namespace

FName::FName(const TCHAR* Text, EFindName FindType)
	: Index(Text != nullptr ? FNameTable::Get().FindOrAdd(Text, FindType) : 0)
{
}

FString FName::ToString() const
{
	return FNameTable::Get().GetText(Index);
}

int32 FName::Compare(const FName& Other) const
{
	return ToString().Compare(Other.ToString(), ESearchCase::IgnoreCase);
}

bool FName::operator==(const TCHAR* Text) const
{
	return ToString() == Text || (IsNone() && *Text == '\0');
}
