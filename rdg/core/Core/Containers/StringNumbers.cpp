// Writes numbers as text and reads them back. Source: interface of the engine's Containers/UnrealString.h.
#include "Containers/UnrealString.h"

#include <charconv>
#include <cmath>

namespace
{

template<typename T>
FString ShortestText(T Value)
{
	char Buffer[512]; // longest fixed form of a double: 309 digits
	const auto Result = std::to_chars(Buffer, Buffer + sizeof(Buffer), Value, std::chars_format::fixed);
	return FString(std::string(Buffer, Result.ptr));
}

} // namespace

FString FString::SanitizeFloat(double Value, int32 MinFractionalDigits)
{
	FString Result = ShortestText(Value);
	if (std::isfinite(Value) && MinFractionalDigits > 0)
	{
		int32 Point = INDEX_NONE;
		if (!Result.FindChar('.', Point))
		{
			Point = Result.Len();
			Result += '.';
		}
		while (Result.Len() - Point - 1 < MinFractionalDigits)
		{
			Result += '0';
		}
	}
	return Result;
}

bool FString::IsNumeric() const
{
	const TCHAR* Text = **this;
	if (*Text == '-' || *Text == '+')
	{
		++Text;
	}
	bool bDigit = false;
	bool bPoint = false;
	for (; *Text != '\0'; ++Text)
	{
		if (*Text == '.' && !bPoint)
		{
			bPoint = true;
		}
		else if (*Text >= '0' && *Text <= '9')
		{
			bDigit = true;
		}
		else
		{
			return false;
		}
	}
	return bDigit;
}

bool FString::ToBool() const
{
	return *this == "true" || *this == "yes" || *this == "on" || FCString::Atoi(**this) != 0;
}

FString LexToString(float Value)
{
	return ShortestText(Value);
}

FString LexToString(double Value)
{
	return ShortestText(Value);
}

void LexFromString(int32& OutValue, const TCHAR* Text)
{
	OutValue = FCString::Atoi(Text);
}

void LexFromString(float& OutValue, const TCHAR* Text)
{
	OutValue = FCString::Atof(Text);
}

void LexFromString(double& OutValue, const TCHAR* Text)
{
	OutValue = FCString::Atod(Text);
}

void LexFromString(bool& OutValue, const TCHAR* Text)
{
	OutValue = FString(Text).ToBool();
}
