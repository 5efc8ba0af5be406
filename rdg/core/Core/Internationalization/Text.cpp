// Texts that are shown.
#include "Internationalization/Text.h"

#include "Misc/CString.h"

const FText& FText::GetEmpty()
{
	static const FText Empty;
	return Empty;
}

FText FText::AsNumber(double Number)
{
	return FText(FString::Printf(TEXT("%.15g"), Number));
}

FText FText::FormatTexts(const FText& Pattern, const TArray<FText>& Arguments)
{
	FString Result;
	for (const TCHAR* At = *Pattern.Source; *At != '\0'; ++At)
	{
		if (*At == '`' && At[1] != '\0')
		{
			++At;
		}
		else if (*At == '{' && At[1] >= '0' && At[1] <= '9')
		{
			const TCHAR* End = At + 1;
			while (*End >= '0' && *End <= '9')
			{
				++End;
			}
			const int32 Index = FCString::Atoi(At + 1);
			if (*End == '}' && Arguments.IsValidIndex(Index))
			{
				Result += Arguments[Index].Source;
				At = End;
				continue;
			}
		}
		Result += FString::Printf(TEXT("%c"), *At);
	}
	return FText(Result);
}
