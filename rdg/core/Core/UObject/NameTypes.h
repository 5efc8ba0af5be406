// FName: a name that compares as one integer and ignores case. It keeps the spelling it was first made with.
// Source: engine UObject/NameTypes.h, UObject/UnrealNames.h.
#pragma once

#include "Containers/UnrealString.h"

enum EName
{
	NAME_None = 0,
};

// A name with a number is written with "_" and the number less one: FName("Light", 3) is "Light_2", and 0 means none.
#define NAME_NO_NUMBER_INTERNAL 0
#define NAME_INTERNAL_TO_EXTERNAL(Number) ((Number)-1)
#define NAME_EXTERNAL_TO_INTERNAL(Number) ((Number) + 1)

enum EFindName
{
	FNAME_Find, // None if nobody made that name yet
	FNAME_Add,
};

class DRYDOCK_API FName
{
public:
	FName() = default;
	FName(EName) {}
	FName(const TCHAR* Text, EFindName FindType = FNAME_Add);
	explicit FName(const FString& Text, EFindName FindType = FNAME_Add)
		: FName(*Text, FindType)
	{
	}

	/** Number as the engine stores it: one more than is written, or 0 for none. */
	FName(const TCHAR* Text, int32 Number, EFindName FindType = FNAME_Add);
	FName(const FName& Plain, int32 Number);

	/** The number of a name that ends with "_" and a number without leading zeros, plus one; else 0. */
	int32 GetNumber() const;
	bool IsNone() const { return Index == 0; }
	bool IsValid() const { return true; }
	FString ToString() const;
	void ToString(FString& OutText) const { OutText = ToString(); }
	/** Without the number. */
	FString GetPlainNameString() const;
	void AppendString(FString& OutText) const { OutText += ToString(); }
	/** Alphabetical, ignoring case: negative, zero or positive. */
	int32 Compare(const FName& Other) const;
	bool LexicalLess(const FName& Other) const { return Compare(Other) < 0; }
	/** Some order that holds within a process. */
	bool FastLess(const FName& Other) const { return Index < Other.Index; }

	bool operator==(const FName&) const = default;
	bool operator==(EName Name) const { return Index == static_cast<uint32>(Name); }
	bool operator==(const TCHAR* Text) const;
	friend uint32 GetTypeHash(const FName& Name) { return ::GetTypeHash(Name.Index); }

private:
	uint32 Index = 0; // into the table of all names; 0 is None
};

inline FString LexToString(const FName& Name)
{
	return Name.ToString();
}

struct FNameLexicalLess
{
	bool operator()(const FName& A, const FName& B) const { return A.LexicalLess(B); }
};
