// FText: a text that is shown. Nothing is translated here: a text is its source string. Source: engine
// Internationalization/Text.h, Internationalization/Internationalization.h.
#pragma once

#include "Containers/Array.h"
#include "UObject/NameTypes.h"

class DRYDOCK_API FText
{
public:
	FText() = default;

	static const FText& GetEmpty();
	static FText FromString(const FString& String) { return FText(String); }
	static FText FromName(const FName& Name) { return FText(Name.ToString()); }
	static FText AsCultureInvariant(const FString& String) { return FText(String); }
	/** In decimal digits: whole numbers without a point, others as printf's %g. The engine groups digits by culture. */
	static FText AsNumber(double Number);
	/** {0}, {1} and so on are replaced by the texts of that place; a backquote takes the next character as it is. */
	template<typename... ArgumentTypes>
	static FText Format(const FText& Pattern, const ArgumentTypes&... Arguments)
	{
		return FormatTexts(Pattern, {ToText(Arguments)...});
	}

	const FString& ToString() const { return Source; }
	bool IsEmpty() const { return Source.IsEmpty(); }
	bool EqualTo(const FText& Other) const { return Source.Equals(Other.Source); }
	int32 CompareTo(const FText& Other) const { return Source.Compare(Other.Source); }

private:
	explicit FText(const FString& InSource)
		: Source(InSource)
	{
	}
	static FText FormatTexts(const FText& Pattern, const TArray<FText>& Arguments);
	static FText ToText(const FText& Text) { return Text; }
	static FText ToText(double Number) { return AsNumber(Number); }

	FString Source;
};

#define INVTEXT(Text) FText::AsCultureInvariant(TEXT(Text))
#define LOCTEXT(Key, Text) FText::FromString(TEXT(Text))
#define NSLOCTEXT(Namespace, Key, Text) FText::FromString(TEXT(Text))
