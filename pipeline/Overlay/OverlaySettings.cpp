// Finds added settings in the text of Scene.h, and reads their types, defaults, ranges and rules.
#include "Overlay/OverlaySettings.h"

#include "Overlay/CppText.h"
#include "Overlay/OverlayErrors.h"
#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

namespace Drydock
{

namespace
{

const std::string OverrideBit = "bOverride_";

/** Names whose override bits the header declares, in their order. */
std::vector<std::string> FindOverriddenNames(const std::string& Blanked)
{
	std::vector<std::string> Names;
	for (size_t At = Blanked.find(OverrideBit); At != Blanked.npos; At = Blanked.find(OverrideBit, At + 1))
	{
		size_t End = At + OverrideBit.size();
		while (End < Blanked.size() && IsWordCharacter(Blanked[End]))
		{
			++End;
		}
		const std::string Name = Blanked.substr(At + OverrideBit.size(), End - At - OverrideBit.size());
		const size_t Colon = SkipBlanks(Blanked, End);
		if (!Name.empty() && Colon < Blanked.size() && Blanked[Colon] == ':' && !Contains(Names, Name))
		{
			Names.push_back(Name);
		}
	}
	return Names;
}

/** A member's declaration: UPROPERTY's arguments, type and initialiser. */
struct FDeclaration
{
	std::string Arguments;
	std::string Type;
	std::string Initializer;
	int Line = 0;
};

std::optional<FDeclaration> FindDeclaration(
	const std::string& Text, const std::string& Blanked, const std::string& Name)
{
	for (const size_t Property : FindWord(Blanked, "UPROPERTY"))
	{
		const size_t Open = SkipBlanks(Blanked, Property + std::string_view("UPROPERTY").size());
		const std::optional<size_t> Close =
			Open < Blanked.size() && Blanked[Open] == '(' ? FindClosing(Blanked, Open) : std::nullopt;
		const size_t End = Close ? Blanked.find(';', *Close) : Blanked.npos;
		if (End == Blanked.npos)
		{
			continue;
		}
		const std::string Member = Blanked.substr(*Close, End - *Close);
		const std::vector<size_t> Places = FindWord(Member, Name);
		const size_t Equals = Member.find('=');
		if (Places.empty() || Places.front() > Equals)
		{
			continue;
		}
		FDeclaration Found;
		Found.Arguments = Text.substr(Open, *Close - Open);
		Found.Type = Trim(Member.substr(0, Places.front()));
		Found.Initializer = Equals == Member.npos ? std::string() : Trim(Member.substr(Equals + 1));
		const bool bBit = Trim(Member.substr(Places.front() + Name.size(), Equals)).starts_with(':');
		Found.Type = bBit ? "bool" : Found.Type;
		Found.Line = GetLineOf(Blanked, *Close + Places.front());
		return Found;
	}
	return std::nullopt;
}

/** The text of `Key = "VALUE"` or `Key = VALUE` among UPROPERTY's arguments. */
std::string FindArgument(const std::string& Arguments, const std::string& Key)
{
	for (const size_t At : FindWord(Arguments, Key))
	{
		size_t Begin = SkipBlanks(Arguments, At + Key.size());
		if (Begin >= Arguments.size() || Arguments[Begin] != '=')
		{
			continue;
		}
		Begin = SkipBlanks(Arguments, Begin + 1);
		const bool bQuoted = Begin < Arguments.size() && Arguments[Begin] == '"';
		Begin += bQuoted ? 1 : 0;
		const size_t End = std::min(Arguments.find_first_of(bQuoted ? "\"" : ",)", Begin), Arguments.size());
		return Trim(Arguments.substr(Begin, End - Begin));
	}
	return "";
}

std::string FindNumber(const std::string& Arguments, const char* Key, const char* Other)
{
	std::string Text = FindArgument(Arguments, Key);
	Text = Text.empty() ? FindArgument(Arguments, Other) : Text;
	char* End = nullptr;
	std::strtod(Text.c_str(), &End);
	return !Text.empty() && *End == '\0' ? Text : std::string();
}

/** `TEnumAsByte<enum E>` and `enum E` are E. */
std::string StripEnum(std::string Type)
{
	if (Type.starts_with("TEnumAsByte"))
	{
		const size_t Open = Type.find('<');
		const size_t Close = Type.rfind('>');
		Type = Open < Close && Close != Type.npos ? Trim(Type.substr(Open + 1, Close - Open - 1)) : Type;
	}
	for (const std::string_view Word : {"enum ", "class "})
	{
		Type = Type.starts_with(Word) ? Trim(Type.substr(Word.size())) : Type;
	}
	return Type;
}

/** The definition of an enum without the macros of reflection, and its names but those that end in MAX. */
struct FEnumDefinition
{
	std::string Text;
	std::vector<std::string> Names;
	bool bScoped = false;
};

std::optional<FEnumDefinition> FindEnum(const std::string& Blanked, const std::string& Name)
{
	for (const size_t At : FindWord(Blanked, Name))
	{
		const size_t LineBegin = Blanked.rfind('\n', At) + 1;
		const std::string Before = Trim(Blanked.substr(LineBegin, At - LineBegin));
		const size_t Open = Blanked.find_first_of(";{", At);
		if ((Before != "enum" && Before != "enum class") || Open == Blanked.npos || Blanked[Open] != '{')
		{
			continue;
		}
		const std::optional<size_t> Close = FindClosing(Blanked, Open);
		if (!Close)
		{
			continue;
		}
		FEnumDefinition Found;
		Found.bScoped = Before == "enum class";
		Found.Text = Before + " " + Blanked.substr(At, Open - At) + "{ ";
		size_t Begin = Open + 1;
		while (Begin < *Close)
		{
			size_t End = std::min(Blanked.find_first_of(",(}", Begin), *Close);
			std::string Entry = Trim(Blanked.substr(Begin, End - Begin));
			if (const size_t Meta = Entry.find("UMETA"); Meta != Entry.npos)
			{
				Entry = Trim(Entry.substr(0, Meta));
			}
			if (End < *Close && Blanked[End] == '(')
			{
				End = FindClosing(Blanked, End).value_or(*Close);
				End = std::min(Blanked.find_first_of(",}", End), *Close);
			}
			if (!Entry.empty())
			{
				Found.Text += Entry + ", ";
				const std::string EntryName = Trim(Entry.substr(0, Entry.find('=')));
				if (!EntryName.ends_with("MAX"))
				{
					Found.Names.push_back(EntryName);
				}
			}
			Begin = End + 1;
		}
		Found.Text += "};";
		return Found;
	}
	return std::nullopt;
}

/** The value that a line `Name = VALUE;` gives in a constructor; a member of another object is left alone. */
std::string FindAssignment(const std::string& Blanked, const std::string& Name, size_t* OutPlace = nullptr)
{
	for (const size_t At : FindWord(Blanked, Name))
	{
		const size_t Equals = SkipBlanks(Blanked, At + Name.size());
		const bool bMember = At > 0 && (Blanked[At - 1] == '.' || Blanked[At - 1] == '>');
		const size_t End = Blanked.find(';', Equals);
		if (!bMember && End != Blanked.npos && Blanked[Equals] == '=' && Blanked[Equals + 1] != '=')
		{
			if (OutPlace != nullptr)
			{
				*OutPlace = At;
			}
			return Trim(Blanked.substr(Equals + 1, End - Equals - 1));
		}
	}
	return "";
}

/** The rule by which SceneView.cpp blends it. */
std::string FindBlend(const std::string& Blanked, const std::string& Name)
{
	constexpr std::pair<std::string_view, const char*> Rules[] = {
		{"LERP_PP", "Lerp"}, {"SET_PP", "Set"}, {"IF_PP", "SetIfNonZero"}};
	for (const auto& [Macro, Rule] : Rules)
	{
		for (const size_t At : FindWord(Blanked, Macro))
		{
			const size_t Open = SkipBlanks(Blanked, At + Macro.size());
			const size_t Begin = SkipBlanks(Blanked, Open + 1);
			if (Open < Blanked.size() && Blanked[Open] == '(' && Blanked.compare(Begin, Name.size(), Name) == 0 &&
				!IsWordCharacter(Blanked[std::min(Begin + Name.size(), Blanked.size() - 1)]))
			{
				return Rule;
			}
		}
	}
	return "";
}

/** Names each UPROPERTY of the struct FPostProcessSettings that has no override bit and is unknown to drydock. */
void NotePropertiesWithoutBit(
	const std::string& File, const std::string& Blanked, std::vector<FDiagnostic>& Diagnostics)
{
	const std::vector<size_t> Structs = FindWord(Blanked, "FPostProcessSettings");
	const size_t Open = Structs.empty() ? Blanked.npos : Blanked.find('{', Structs.front());
	const size_t End = Open == Blanked.npos ? 0 : FindClosing(Blanked, Open).value_or(Blanked.size());
	const std::vector<std::string> Overridden = FindOverriddenNames(Blanked);
	for (const size_t At : FindWord(Blanked, "UPROPERTY"))
	{
		const bool bInside = At > Open && At < End;
		const size_t Close = bInside ? FindClosing(Blanked, At).value_or(Blanked.size()) : Blanked.size();
		const std::string Member = Blanked.substr(Close, Blanked.find_first_of("=;:[", Close) - Close);
		const std::string Declaration = Trim(Member);
		const std::string Plain = Declaration.substr(Declaration.find_last_of(" \t\n") + 1);
		if (!Plain.empty() && !Plain.starts_with(OverrideBit) && !Plain.ends_with("_DEPRECATED") &&
			Plain != "WeightedBlendables" && FindSettingField(Plain) == nullptr && !Contains(Overridden, Plain))
		{
			Diagnostics.push_back({.Severity = ESeverity::Note,
				.Code = ErrorOverlaySetting,
				.Message = Plain + " becomes no setting: it has no bit " + OverrideBit + Plain,
				.File = File,
				.Line = GetLineOf(Blanked, Close)});
		}
	}
}

/** Whether a plain number or word says the field's default. */
bool IsDefault(const FSettingField& Field, std::string Value)
{
	const bool bFloat = Value.ends_with('f') && Value.find_first_not_of("0123456789.+-ef") == Value.npos;
	Value = bFloat ? Value.substr(0, Value.size() - 1) : Value.substr(std::min(Value.rfind(':') + 1, Value.size()));
	FSettingValue Read;
	std::string Ignored;
	return SettingFromText(Field, Value == "nullptr" ? "None" : Value, Read, Ignored) && Read == Field.Default;
}

} // namespace

std::vector<FOverlayDefault> ReadOverlayDefaults(const FOverlayText& Source)
{
	std::vector<FOverlayDefault> Found;
	const std::string Blanked = BlankComments(Source.Text);
	for (const FSettingField& Field : GetSettingFields())
	{
		size_t Place = 0;
		const std::string Value = FindAssignment(Blanked, Field.Name, &Place);
		if (Field.AddedId == 0 && !Value.empty() && !IsDefault(Field, Value))
		{
			Found.push_back({Field.Name, Value, Source.File, GetLineOf(Blanked, Place)});
		}
	}
	return Found;
}

FOverlaySettings ReadOverlaySettings(const FOverlayText& Header, const FOverlayText& Source, const FOverlayText& View,
	std::vector<FDiagnostic>& Diagnostics)
{
	const std::set<std::string> Plain = {"float", "bool", "int32", "FLinearColor", "FVector2D", "FVector4"};
	const std::string Blanked = BlankComments(Header.Text);
	const std::string BlankedSource = BlankComments(Source.Text);
	const std::string BlankedView = BlankComments(View.Text);
	FOverlaySettings Found;
	NotePropertiesWithoutBit(Header.File, Blanked, Diagnostics);
	for (const std::string& Name : FindOverriddenNames(Blanked))
	{
		const FSettingField* const Known = FindSettingField(Name);
		if (Known != nullptr && Known->AddedId == 0)
		{
			continue;
		}
		const std::optional<FDeclaration> Declared = FindDeclaration(Header.Text, Blanked, Name);
		if (!Declared)
		{
			Diagnostics.push_back({.Code = ErrorOverlaySetting,
				.Message = OverrideBit + Name + " has no UPROPERTY " + Name + " beside it",
				.File = Header.File,
				.Line = GetLineOf(Blanked, Blanked.find(OverrideBit + Name))});
			continue;
		}
		FOverlaySetting Setting;
		Setting.Name = Name;
		Setting.Type = StripEnum(Declared->Type == "int" ? "int32" : Declared->Type);
		if (!Plain.contains(Setting.Type))
		{
			const std::optional<FEnumDefinition> Enum = FindEnum(Blanked, Setting.Type);
			if (!Enum || Enum->Names.empty())
			{
				Diagnostics.push_back({.Code = ErrorOverlaySetting,
					.Message = "the type of " + Name + " must be one of " + JoinText(Plain) +
							   ", or an enum that this file defines, but is \"" + Setting.Type + "\"",
					.File = Header.File,
					.Line = Declared->Line});
				continue;
			}
			Setting.EnumNames = Enum->Names;
			AddUnique(Found.EnumTexts, Enum->Text);
		}
		Setting.Default = FindAssignment(BlankedSource, Name);
		Setting.Default = Setting.Default.empty() ? Declared->Initializer : Setting.Default;
		Setting.Min = FindNumber(Declared->Arguments, "ClampMin", "UIMin");
		Setting.Max = FindNumber(Declared->Arguments, "ClampMax", "UIMax");
		Setting.Category = FindArgument(Declared->Arguments, "Category");
		Setting.Doc = FindArgument(Declared->Arguments, "DisplayName");
		Setting.Blend = FindBlend(BlankedView, Name);
		Found.Settings.push_back(std::move(Setting));
	}
	return Found;
}

} // namespace Drydock
