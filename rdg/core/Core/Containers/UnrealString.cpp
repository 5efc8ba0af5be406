// Implements the operations of FString. Source: interface of the engine's Containers/UnrealString.h.
#include "Containers/UnrealString.h"

#include "Misc/AssertionMacros.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace
{

// The locale must not change results, so letters are ASCII here.
TCHAR ToLowerAscii(TCHAR Character)
{
	return Character >= 'A' && Character <= 'Z' ? static_cast<TCHAR>(Character - 'A' + 'a') : Character;
}

TCHAR ToUpperAscii(TCHAR Character)
{
	return Character >= 'a' && Character <= 'z' ? static_cast<TCHAR>(Character - 'a' + 'A') : Character;
}

bool IsSpace(TCHAR Character)
{
	return Character == ' ' || (Character >= '\t' && Character <= '\r');
}

bool EqualCharacters(TCHAR A, TCHAR B, ESearchCase::Type SearchCase)
{
	return SearchCase == ESearchCase::CaseSensitive ? A == B : ToLowerAscii(A) == ToLowerAscii(B);
}

/** Whether Part stands at Position of Text. */
bool IsAt(const FString& Text, const FString& Part, int32 Position, ESearchCase::Type SearchCase)
{
	if (Position < 0 || Position + Part.Len() > Text.Len())
	{
		return false;
	}
	return std::equal(Part.begin(), Part.end(), Text.begin() + Position,
		[SearchCase](TCHAR A, TCHAR B) { return EqualCharacters(A, B, SearchCase); });
}

std::string FormatList(const TCHAR* Format, va_list Arguments)
{
	va_list Copy;
	va_copy(Copy, Arguments);
	const int Length = std::vsnprintf(nullptr, 0, Format, Copy);
	va_end(Copy);
	check(Length >= 0);
	std::string Text(static_cast<SIZE_T>(Length) + 1, '\0');
	std::vsnprintf(Text.data(), Text.size(), Format, Arguments);
	Text.pop_back();
	return Text;
}

bool MatchWildcard(const TCHAR* Text, const TCHAR* Pattern, ESearchCase::Type SearchCase)
{
	// On a mismatch the last star takes one character more: linear memory, no recursion.
	const TCHAR* Star = nullptr;
	const TCHAR* StarText = nullptr;
	while (*Text != '\0')
	{
		if (*Pattern == '*')
		{
			Star = Pattern++;
			StarText = Text;
		}
		else if (*Pattern != '\0' && (*Pattern == '?' || EqualCharacters(*Pattern, *Text, SearchCase)))
		{
			++Pattern;
			++Text;
		}
		else if (Star != nullptr)
		{
			Pattern = Star + 1;
			Text = ++StarText;
		}
		else
		{
			return false;
		}
	}
	while (*Pattern == '*')
	{
		++Pattern;
	}
	return *Pattern == '\0';
}

} // namespace

FString FString::Printf(const TCHAR* Format, ...)
{
	va_list Arguments;
	va_start(Arguments, Format);
	FString Result(FormatList(Format, Arguments));
	va_end(Arguments);
	return Result;
}

FString& FString::Appendf(const TCHAR* Format, ...)
{
	va_list Arguments;
	va_start(Arguments, Format);
	Data += FormatList(Format, Arguments);
	va_end(Arguments);
	return *this;
}

void FString::Empty(int32 Slack)
{
	Data.clear();
	Data.reserve(Slack);
}

TCHAR& FString::operator[](int32 Index)
{
	checkf(IsValidIndex(Index), "String index out of bounds: Index %d from a string with a length of %d", Index, Len());
	return Data[Index];
}

const TCHAR& FString::operator[](int32 Index) const
{
	checkf(IsValidIndex(Index), "String index out of bounds: Index %d from a string with a length of %d", Index, Len());
	return Data[Index];
}

FString& FString::Append(const TCHAR* Text)
{
	Data += Text;
	return *this;
}

FString& FString::Append(const TCHAR* Text, int32 Count)
{
	Data.append(Text, static_cast<SIZE_T>(Count));
	return *this;
}

FString& FString::AppendChar(TCHAR Character)
{
	Data += Character;
	return *this;
}

FString& FString::operator/=(const TCHAR* Text)
{
	const bool bStartsWithSlash = *Text == '/';
	if (!Data.empty() && Data.back() != '/' && !bStartsWithSlash)
	{
		Data += '/';
	}
	else if (!Data.empty() && Data.back() == '/' && bStartsWithSlash)
	{
		++Text;
	}
	Data += Text;
	return *this;
}

void FString::InsertAt(int32 Index, const FString& Text)
{
	check(Index >= 0 && Index <= Len());
	Data.insert(static_cast<SIZE_T>(Index), Text.Data);
}

void FString::RemoveAt(int32 Index, int32 Count)
{
	check(Index >= 0 && Count >= 0 && Index + Count <= Len());
	Data.erase(static_cast<SIZE_T>(Index), static_cast<SIZE_T>(Count));
}

bool FString::RemoveFromStart(const FString& Prefix, ESearchCase::Type SearchCase)
{
	if (Prefix.IsEmpty() || !StartsWith(Prefix, SearchCase))
	{
		return false;
	}
	Data.erase(0, Prefix.Data.size());
	return true;
}

bool FString::RemoveFromEnd(const FString& Suffix, ESearchCase::Type SearchCase)
{
	if (Suffix.IsEmpty() || !EndsWith(Suffix, SearchCase))
	{
		return false;
	}
	Data.resize(Data.size() - Suffix.Data.size());
	return true;
}

bool FString::Equals(const FString& Other, ESearchCase::Type SearchCase) const
{
	return Len() == Other.Len() && IsAt(*this, Other, 0, SearchCase);
}

int32 FString::Compare(const FString& Other, ESearchCase::Type SearchCase) const
{
	return SearchCase == ESearchCase::CaseSensitive ? FCString::Strcmp(**this, *Other)
													: FCString::Stricmp(**this, *Other);
}

bool FString::Contains(const FString& Part, ESearchCase::Type SearchCase) const
{
	return Find(Part, SearchCase) != INDEX_NONE;
}

bool FString::StartsWith(const FString& Prefix, ESearchCase::Type SearchCase) const
{
	return IsAt(*this, Prefix, 0, SearchCase);
}

bool FString::EndsWith(const FString& Suffix, ESearchCase::Type SearchCase) const
{
	return IsAt(*this, Suffix, Len() - Suffix.Len(), SearchCase);
}

bool FString::MatchesWildcard(const FString& Wildcard, ESearchCase::Type SearchCase) const
{
	return MatchWildcard(**this, *Wildcard, SearchCase);
}

int32 FString::Find(
	const FString& Part, ESearchCase::Type SearchCase, ESearchDir::Type SearchDir, int32 StartPosition) const
{
	const int32 LastPosition = Len() - Part.Len();
	if (SearchDir == ESearchDir::FromStart)
	{
		for (int32 Position = std::max(StartPosition, 0); Position <= LastPosition; ++Position)
		{
			if (IsAt(*this, Part, Position, SearchCase))
			{
				return Position;
			}
		}
		return INDEX_NONE;
	}
	// Backwards the match has to end before StartPosition.
	const int32 First = StartPosition == INDEX_NONE ? LastPosition : std::min(StartPosition - Part.Len(), LastPosition);
	for (int32 Position = First; Position >= 0; --Position)
	{
		if (IsAt(*this, Part, Position, SearchCase))
		{
			return Position;
		}
	}
	return INDEX_NONE;
}

bool FString::FindChar(TCHAR Character, int32& OutIndex) const
{
	const SIZE_T Position = Data.find(Character);
	OutIndex = Position == std::string::npos ? INDEX_NONE : static_cast<int32>(Position);
	return OutIndex != INDEX_NONE;
}

bool FString::FindLastChar(TCHAR Character, int32& OutIndex) const
{
	const SIZE_T Position = Data.rfind(Character);
	OutIndex = Position == std::string::npos ? INDEX_NONE : static_cast<int32>(Position);
	return OutIndex != INDEX_NONE;
}

FString FString::Left(int32 Count) const
{
	return Mid(0, Count);
}

FString FString::Right(int32 Count) const
{
	return Mid(Len() - std::clamp(Count, 0, Len()));
}

FString FString::Mid(int32 Start, int32 Count) const
{
	// A negative start takes away from the count, as in the engine.
	const int64 End = std::clamp<int64>(static_cast<int64>(Start) + std::max(Count, 0), 0, Len());
	const int64 Begin = std::clamp<int64>(Start, 0, End);
	return FString(Data.substr(Begin, End - Begin));
}

FString FString::ToLower() const
{
	FString Result = *this;
	std::transform(Result.begin(), Result.end(), Result.begin(), ToLowerAscii);
	return Result;
}

FString FString::ToUpper() const
{
	FString Result = *this;
	std::transform(Result.begin(), Result.end(), Result.begin(), ToUpperAscii);
	return Result;
}

FString FString::Replace(const TCHAR* From, const TCHAR* To, ESearchCase::Type SearchCase) const
{
	FString Result = *this;
	Result.ReplaceInline(From, To, SearchCase);
	return Result;
}

int32 FString::ReplaceInline(const TCHAR* From, const TCHAR* To, ESearchCase::Type SearchCase)
{
	const FString Part(From);
	if (Part.IsEmpty())
	{
		return 0;
	}
	std::string Result;
	int32 Replaced = 0;
	int32 Done = 0;
	for (int32 Found = Find(Part, SearchCase); Found != INDEX_NONE;
		 Found = Find(Part, SearchCase, ESearchDir::FromStart, Done))
	{
		Result.append(Data, Done, Found - Done);
		Result += To;
		Done = Found + Part.Len();
		++Replaced;
	}
	Result.append(Data, Done);
	Data = std::move(Result);
	return Replaced;
}

FString FString::TrimStart() const
{
	return FString(std::string(std::find_if_not(Data.begin(), Data.end(), IsSpace), Data.end()));
}

FString FString::TrimEnd() const
{
	return FString(std::string(Data.begin(), std::find_if_not(Data.rbegin(), Data.rend(), IsSpace).base()));
}

FString FString::LeftPad(int32 Length) const
{
	return ChrN(std::max(Length - Len(), 0), ' ') + *this;
}

FString FString::RightPad(int32 Length) const
{
	return *this + ChrN(std::max(Length - Len(), 0), ' ');
}

FString FString::Reverse() const
{
	return FString(std::string(Data.rbegin(), Data.rend()));
}

bool FString::Split(const FString& Separator, FString* OutLeft, FString* OutRight, ESearchCase::Type SearchCase,
	ESearchDir::Type SearchDir) const
{
	const int32 Position = Find(Separator, SearchCase, SearchDir);
	if (Position == INDEX_NONE)
	{
		return false;
	}
	// Either output may be this string.
	FString LeftPart = Left(Position);
	FString RightPart = Mid(Position + Separator.Len());
	if (OutLeft != nullptr)
	{
		*OutLeft = std::move(LeftPart);
	}
	if (OutRight != nullptr)
	{
		*OutRight = std::move(RightPart);
	}
	return true;
}

int32 FString::ParseIntoArray(TArray<FString>& OutParts, const TCHAR* Separator, bool bCullEmpty) const
{
	OutParts.Reset();
	const FString Mark(Separator);
	check(!Mark.IsEmpty());
	int32 Start = 0;
	while (Start <= Len())
	{
		const int32 Found = Find(Mark, ESearchCase::CaseSensitive, ESearchDir::FromStart, Start);
		const int32 End = Found == INDEX_NONE ? Len() : Found;
		// The empty text behind the last separator is not a part.
		if (End > Start || (!bCullEmpty && Found != INDEX_NONE))
		{
			OutParts.Add(Mid(Start, End - Start));
		}
		Start = End + Mark.Len();
	}
	return OutParts.Num();
}

int32 FString::ParseIntoArrayLines(TArray<FString>& OutLines, bool bCullEmpty) const
{
	return Replace("\r\n", "\n").Replace("\r", "\n").ParseIntoArray(OutLines, "\n", bCullEmpty);
}

uint32 GetTypeHash(const FString& Text)
{
	// FNV-1a over lower-case letters.
	uint32 Hash = 2166136261u;
	for (const TCHAR Character : Text)
	{
		Hash = (Hash ^ static_cast<uint8>(ToLowerAscii(Character))) * 16777619u;
	}
	return Hash;
}
