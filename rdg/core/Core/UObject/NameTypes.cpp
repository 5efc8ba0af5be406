// Keeps the table of all names that FName's numbers stand for.
#include "UObject/NameTypes.h"

#include "Containers/Map.h"
#include "Misc/CString.h"

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

/** The place of the "_" of a number at the end of a name; INDEX_NONE where there is no number, or one that an int32
 * cannot hold. */
int32 FindNumber(const FString& Text)
{
	const int32 End = Text.Len();
	int32 Begin = End;
	while (Begin > 0 && Text[Begin - 1] >= '0' && Text[Begin - 1] <= '9')
	{
		--Begin;
	}
	const int32 Digits = End - Begin;
	const bool bNumber = Digits > 0 && Digits < 10 && (Digits == 1 || Text[Begin] != '0');
	return bNumber && Begin > 1 && Text[Begin - 1] == '_' ? Begin - 1 : INDEX_NONE;
}

FString MakeNumbered(const FString& Plain, int32 Number)
{
	return Number == NAME_NO_NUMBER_INTERNAL
			   ? Plain
			   : FString::Printf(TEXT("%s_%d"), *Plain, NAME_INTERNAL_TO_EXTERNAL(Number));
}

} // namespace

FName::FName(const TCHAR* Text, int32 Number, EFindName FindType)
	: FName(MakeNumbered(Text, Number), FindType)
{
}

FName::FName(const FName& Plain, int32 Number)
	: FName(MakeNumbered(Plain.GetPlainNameString(), Number))
{
}

int32 FName::GetNumber() const
{
	const FString Text = ToString();
	const int32 At = FindNumber(Text);
	return At == INDEX_NONE ? NAME_NO_NUMBER_INTERNAL : NAME_EXTERNAL_TO_INTERNAL(FCString::Atoi(*Text + At + 1));
}

FString FName::GetPlainNameString() const
{
	const FString Text = ToString();
	const int32 At = FindNumber(Text);
	return At == INDEX_NONE ? Text : Text.Left(At);
}

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
