// FString: a UTF-8 string with the engine's interface over std::string. Comparison with == and use as a key ignore case
// (ASCII letters), as in the engine; Equals compares with case. Lengths and positions count bytes.
// Source: engine Containers/UnrealString.h.
#pragma once

#include "CoreTypes.h"
#include "Containers/Array.h"
#include "Misc/CString.h"
#include "Templates/TypeHash.h"

#include <string>
#include <string_view>

namespace ESearchCase
{
enum Type
{
	CaseSensitive,
	IgnoreCase,
};
} // namespace ESearchCase

namespace ESearchDir
{
enum Type
{
	FromStart,
	FromEnd,
};
} // namespace ESearchDir

class DRYDOCK_API FString
{
public:
	using ElementType = TCHAR;

	FString() = default;
	FString(const TCHAR* Text)
		: Data(Text != nullptr ? Text : "")
	{
	}
	/** The first Count characters of Text. */
	FString(int32 Count, const TCHAR* Text)
		: Data(Text, static_cast<SIZE_T>(Count))
	{
	}
	explicit FString(std::string Text)
		: Data(std::move(Text))
	{
	}
	explicit FString(std::string_view Text)
		: Data(Text)
	{
	}

	/** printf-style; %s takes const TCHAR*, so a FString argument is written *String. */
	static FString Printf(const TCHAR* Format, ...) __attribute__((format(printf, 1, 2)));
	static FString FromInt(int64 Value) { return FString(std::to_string(Value)); }
	/** The shortest text that reads back as Value, with at least so many digits behind the point: 1.0, 0.25. */
	static FString SanitizeFloat(double Value, int32 MinFractionalDigits = 1);
	static FString Chr(TCHAR Character) { return FString(std::string(1, Character)); }
	static FString ChrN(int32 Count, TCHAR Character) { return FString(std::string(Count, Character)); }
	static FString ConstructFromPtrSize(const TCHAR* Text, int32 Count) { return FString(Count, Text); }
	/** "A, B, C" from the elements of a range. */
	template<typename RangeType>
	static FString Join(const RangeType& Range, const TCHAR* Separator);

	const TCHAR* operator*() const { return Data.c_str(); }
	/** The std::string underneath: for code of ours that talks to the standard library. */
	const std::string& ToStdString() const { return Data; }

	int32 Len() const { return static_cast<int32>(Data.size()); }
	bool IsEmpty() const { return Data.empty(); }
	bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < Len(); }
	void Empty(int32 Slack = 0);
	void Reset(int32 Slack = 0) { Empty(Slack); }
	void Reserve(int32 Count) { Data.reserve(Count); }

	TCHAR& operator[](int32 Index);
	const TCHAR& operator[](int32 Index) const;
	TCHAR* begin() { return Data.data(); }
	const TCHAR* begin() const { return Data.data(); }
	TCHAR* end() { return Data.data() + Data.size(); }
	const TCHAR* end() const { return Data.data() + Data.size(); }

	FString& Append(const TCHAR* Text);
	FString& Append(const TCHAR* Text, int32 Count);
	FString& Append(const FString& Text) { return Append(*Text, Text.Len()); }
	FString& AppendChar(TCHAR Character);
	FString& AppendInt(int64 Value) { return Append(FromInt(Value)); }
	FString& Appendf(const TCHAR* Format, ...) __attribute__((format(printf, 2, 3)));
	FString& operator+=(const TCHAR* Text) { return Append(Text); }
	FString& operator+=(const FString& Text) { return Append(Text); }
	FString& operator+=(TCHAR Character) { return AppendChar(Character); }
	/** Appends with exactly one slash between. */
	FString& operator/=(const TCHAR* Text);
	FString& operator/=(const FString& Text) { return *this /= *Text; }
	void InsertAt(int32 Index, const FString& Text);
	void RemoveAt(int32 Index, int32 Count = 1);
	/** True if the text was at that end and is now gone. */
	bool RemoveFromStart(const FString& Prefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);
	bool RemoveFromEnd(const FString& Suffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);

	bool Equals(const FString& Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const;
	/** Negative, zero or positive, as strcmp. */
	int32 Compare(const FString& Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const;
	bool Contains(const FString& Part, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
	bool StartsWith(const FString& Prefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
	bool EndsWith(const FString& Suffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
	/** `*` stands for any text, `?` for one character. */
	bool MatchesWildcard(const FString& Wildcard, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
	/** Position of Part or INDEX_NONE. StartPosition counts from the start in both directions. */
	int32 Find(const FString& Part, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase,
		ESearchDir::Type SearchDir = ESearchDir::FromStart, int32 StartPosition = INDEX_NONE) const;
	bool FindChar(TCHAR Character, int32& OutIndex) const;
	bool FindLastChar(TCHAR Character, int32& OutIndex) const;
	/** A whole number or a decimal one, without exponent. */
	bool IsNumeric() const;

	FString Left(int32 Count) const;
	FString LeftChop(int32 Count) const { return Left(Len() - Count); }
	FString Right(int32 Count) const;
	FString RightChop(int32 Count) const { return Mid(Count); }
	FString Mid(int32 Start, int32 Count = MAX_int32) const;
	FString ToLower() const;
	FString ToUpper() const;
	FString Replace(const TCHAR* From, const TCHAR* To, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
	int32 ReplaceInline(const TCHAR* From, const TCHAR* To, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);
	FString TrimStart() const;
	FString TrimEnd() const;
	FString TrimStartAndEnd() const { return TrimStart().TrimEnd(); }
	void TrimStartAndEndInline() { *this = TrimStartAndEnd(); }
	FString LeftPad(int32 Length) const;
	FString RightPad(int32 Length) const;
	FString Reverse() const;
	/** Splits at the first (or last) Separator; false leaves the outputs alone. Outputs may be null. */
	bool Split(const FString& Separator, FString* OutLeft, FString* OutRight,
		ESearchCase::Type SearchCase = ESearchCase::IgnoreCase,
		ESearchDir::Type SearchDir = ESearchDir::FromStart) const;
	/** Parts between separators; returns their number. */
	int32 ParseIntoArray(TArray<FString>& OutParts, const TCHAR* Separator, bool bCullEmpty = true) const;
	int32 ParseIntoArrayLines(TArray<FString>& OutLines, bool bCullEmpty = true) const;
	/** true, yes, on or a number other than zero. */
	bool ToBool() const;

	friend FString operator+(FString A, const FString& B) { return MoveString(A.Append(B)); }
	friend FString operator+(FString A, const TCHAR* B) { return MoveString(A.Append(B)); }
	friend FString operator+(const TCHAR* A, const FString& B) { return MoveString(FString(A).Append(B)); }
	friend FString operator+(FString A, TCHAR B) { return MoveString(A.AppendChar(B)); }
	friend FString operator/(FString A, const FString& B) { return MoveString(A /= B); }
	friend FString operator/(FString A, const TCHAR* B) { return MoveString(A /= B); }

	friend bool operator==(const FString& A, const FString& B) { return A.Equals(B, ESearchCase::IgnoreCase); }
	friend bool operator==(const FString& A, const TCHAR* B) { return FCString::Stricmp(*A, B) == 0; }
	friend bool operator==(const TCHAR* A, const FString& B) { return FCString::Stricmp(A, *B) == 0; }
	friend bool operator<(const FString& A, const FString& B) { return A.Compare(B, ESearchCase::IgnoreCase) < 0; }
	friend bool operator>(const FString& A, const FString& B) { return B < A; }
	friend bool operator<=(const FString& A, const FString& B) { return !(B < A); }
	friend bool operator>=(const FString& A, const FString& B) { return !(A < B); }

private:
	static FString MoveString(FString& Text) { return static_cast<FString&&>(Text); }

	std::string Data;
};

/** Hash without regard to case, matching operator==. */
DRYDOCK_API uint32 GetTypeHash(const FString& Text);

template<typename RangeType>
FString FString::Join(const RangeType& Range, const TCHAR* Separator)
{
	FString Result;
	bool bFirst = true;
	for (const auto& Element : Range)
	{
		if (!bFirst)
		{
			Result += Separator;
		}
		bFirst = false;
		Result += Element;
	}
	return Result;
}

inline FString LexToString(const FString& Value)
{
	return Value;
}
inline FString LexToString(const TCHAR* Value)
{
	return FString(Value);
}
inline FString LexToString(bool Value)
{
	return FString(Value ? "true" : "false");
}
template<typename T>
requires(std::is_integral_v<T> && !std::is_same_v<T, bool>) FString LexToString(T Value)
{
	return FString(std::to_string(Value));
}
DRYDOCK_API FString LexToString(float Value);
DRYDOCK_API FString LexToString(double Value);

DRYDOCK_API void LexFromString(int32& OutValue, const TCHAR* Text);
DRYDOCK_API void LexFromString(float& OutValue, const TCHAR* Text);
DRYDOCK_API void LexFromString(double& OutValue, const TCHAR* Text);
DRYDOCK_API void LexFromString(bool& OutValue, const TCHAR* Text);
inline void LexFromString(FString& OutValue, const TCHAR* Text)
{
	OutValue = Text;
}
