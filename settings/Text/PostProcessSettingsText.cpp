// Reads pasted settings: fields by name, array elements, and the text that no field is for.
#include "PostProcessSettingsText.h"

#include "DiagnosticList.h"
#include "PostProcessSettingsTextNames.h"
#include "PostProcessSettingsTextScan.h"
#include "PostProcessSettingsTextValue.h"
#include "TextTools.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace Drydock
{

namespace
{

/** The meaning of a name of the text, in any letter case. */
struct FTextName
{
	const FSettingField* Field = nullptr;
	bool bOverride = false;
	bool bBlendables = false;
};

FTextName FindTextName(const std::string& Name)
{
	// Indices, as plugins that come and go move the list; theirs stand behind those of the table, and are few.
	struct FIndexedName
	{
		size_t Index = 0;
		bool bOverride = false;
	};
	static const std::unordered_map<std::string, FIndexedName> Names = []
	{
		std::unordered_map<std::string, FIndexedName> ByName;
		for (size_t Index = 0; Index < GetNumTableSettings(); ++Index)
		{
			const FSettingField& Field = GetSettingFields()[Index];
			ByName[ToLowerCase(Field.Name)] = {Index, false};
			ByName[ToLowerCase(Field.OverrideName)] = {Index, true};
		}
		return ByName;
	}();
	const std::string Lower = ToLowerCase(Name);
	const std::vector<FSettingField>& Fields = GetSettingFields();
	if (const auto Found = Names.find(Lower); Found != Names.end())
	{
		return {&Fields[Found->second.Index], Found->second.bOverride, false};
	}
	for (size_t Index = Fields.size(); Index > 0 && Fields[Index - 1].AddedId != 0; --Index)
	{
		const FSettingField& Field = Fields[Index - 1];
		const bool bOverride = Lower == ToLowerCase(Field.OverrideName);
		if (bOverride || Lower == ToLowerCase(Field.Name))
		{
			return {&Field, bOverride, false};
		}
	}
	return {nullptr, false, Lower == ToLowerCase(BlendablesName)};
}

/** Whether only a stretch of two letters differs. */
bool IsNearly(const std::string& A, const std::string& B)
{
	if (std::max(A.size(), B.size()) - std::min(A.size(), B.size()) > 2)
	{
		return false;
	}
	const std::string LowerA = ToLowerCase(A);
	const std::string LowerB = ToLowerCase(B);
	const size_t Shorter = std::min(A.size(), B.size());
	size_t Prefix = 0;
	while (Prefix < Shorter && LowerA[Prefix] == LowerB[Prefix])
	{
		++Prefix;
	}
	size_t Suffix = 0;
	while (Suffix < Shorter - Prefix && LowerA[A.size() - 1 - Suffix] == LowerB[B.size() - 1 - Suffix])
	{
		++Suffix;
	}
	return std::max(A.size(), B.size()) - Prefix - Suffix <= 2;
}

/** Cheaper than FindNearestName and stricter: names of other engine versions are not mistakes. */
std::string FindNearlySameName(const std::string& Name)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	const auto Found = std::find_if(
		Fields.begin(), Fields.end(), [&](const FSettingField& Field) { return IsNearly(Name, Field.Name); });
	return Found == Fields.end() ? "" : Found->Name;
}

class FStructReader
{
public:
	FStructReader(const std::string& InWhere, FSettingsTextMessages& InMessages)
		: Where(InWhere)
		, Messages(InMessages)
	{
	}

	FSettingsText Read(const FEngineTextValue& Struct)
	{
		for (const FEngineTextItem& Item : Struct.Items)
		{
			ReadItem(Item);
		}
		if (NumErrors > MaxDiagnostics)
		{
			Messages.Error(ErrorTextGivenTwice, Struct.Offset, Where + "Settings",
				"and " + std::to_string(NumErrors - MaxDiagnostics) + " more fields are wrong");
		}
		ReportPairs();
		return std::move(Result);
	}

private:
	/** Whether this mistake is one of the first. Each looks for its place in the text, which may be one long line. */
	bool CountError() { return ++NumErrors <= MaxDiagnostics; }

	void ReadItem(const FEngineTextItem& Item)
	{
		if (Item.Name.empty() && CountError())
		{
			Messages.Error(ErrorTextSyntax, Item.Offset, "", "expected NAME=VALUE, found " + Item.Value.Describe());
		}
		if (Item.Name.empty())
		{
			return;
		}
		const FTextName Name = FindTextName(Item.Name);
		const std::string Spelling = Name.bBlendables        ? BlendablesName
									 : Name.Field == nullptr ? Item.Name
									 : Name.bOverride        ? Name.Field->OverrideName
															 : Name.Field->Name;
		const std::string Key = FEngineTextItem{Spelling, Item.Index, {}, 0}.GetKey();
		const auto [First, bNew] = Given.emplace(Name.Field == nullptr ? ToLowerCase(Key) : Key, Item.Offset);
		if (!bNew && CountError())
		{
			Messages.Error(ErrorTextGivenTwice, Item.Offset, Where + Key,
				Key + " is given twice, first at " + Messages.Place(First->second));
		}
		if (!bNew)
		{
			return;
		}
		if (Name.Field == nullptr && !Name.bBlendables)
		{
			Result.Unknown.push_back({Key, ToEngineText(Item.Value), LastKnown});
			UnknownOffsets.push_back(Item.Offset);
			return;
		}
		LastKnown = Key;
		FSettingTextProblem Problem;
		const bool bRead = Name.bOverride     ? ReadOverride(*Name.Field, Item, Problem)
						   : Name.bBlendables ? ReadBlendables(Item, Problem)
											  : ReadValue(*Name.Field, Item, Problem);
		if (!bRead && CountError())
		{
			Messages.Error(Problem.Code, Problem.Offset, Where + Key, Problem.Message);
		}
	}

	bool ReadOverride(const FSettingField& Field, const FEngineTextItem& Item, FSettingTextProblem& OutProblem)
	{
		const FEngineTextValue& Value = Item.Value;
		const bool bDigit = Value.Kind == EEngineTextKind::Number && (Value.Number == 0.0 || Value.Number == 1.0);
		if (Item.Index >= 0)
		{
			OutProblem = {
				ErrorTextIndex, Item.Offset, std::string(Field.OverrideName) + " is not an array and has no index"};
			return false;
		}
		if (Value.Kind != EEngineTextKind::Bool && !bDigit)
		{
			OutProblem = {ErrorTextWrongType, Value.Offset, "expected True or False, found " + Value.Describe()};
			return false;
		}
		Field.SetOverridden(Result.Settings, bDigit ? Value.Number == 1.0 : Value.Bool);
		BitOffsets[&Field] = Item.Offset;
		return true;
	}

	bool ReadBlendables(const FEngineTextItem& Item, FSettingTextProblem& OutProblem)
	{
		if (Item.Index >= 0)
		{
			OutProblem = {ErrorTextIndex, Item.Offset,
				std::string(BlendablesName) + " is written (Array=(..)), without an index"};
			return false;
		}
		return ReadBlendablesText(Item.Value, Result.Settings.WeightedBlendables, OutProblem);
	}

	bool ReadValue(const FSettingField& Field, const FEngineTextItem& Item, FSettingTextProblem& OutProblem)
	{
		ValueOffsets.emplace(&Field, Item.Offset);
		FSettingValue Value = Field.Get(Result.Settings);
		if (Item.Index >= 0 ? !ReadSettingTextElement(Field, Item.Index, Item.Value, Value, OutProblem)
							: !ReadSettingText(Field, Item.Value, Value, OutProblem))
		{
			return false;
		}
		if (!Field.IsInRange(Value))
		{
			Messages.Warn(WarnTextOutOfRange, Item.Value.Offset, Where + Field.Name,
				std::string(Field.Name) + " is outside its range; it is used as it is");
		}
		Field.Set(Result.Settings, Value);
		return true;
	}

	/** Reports conflicts between values and override bits, and unknown names. */
	void ReportPairs()
	{
		FSettingNameList Inert;
		FSettingNameList WithoutValue;
		for (const FSettingField& Field : GetSettingFields())
		{
			const auto Value = ValueOffsets.find(&Field);
			const auto Bit = BitOffsets.find(&Field);
			const bool bOverridden = Field.IsOverridden(Result.Settings);
			if (Value != ValueOffsets.end() && !bOverridden && !(Field.Get(Result.Settings) == Field.Default))
			{
				Inert.Add(Field.Name, Value->second);
			}
			if (Value == ValueOffsets.end() && bOverridden)
			{
				WithoutValue.Add(Field.Name, Bit->second);
			}
		}
		if (Inert.GetNum() > 0)
		{
			Messages.Warn(WarnTextInert, Inert.GetOffset(), Where + "Settings",
				"kept, but without effect, for the override bit is off: " + Inert.GetText());
		}
		if (WithoutValue.GetNum() > 0)
		{
			Messages.Note(NoteTextBitWithoutValue, WithoutValue.GetOffset(), Where + "Settings",
				"overridden without a value, so with the default: " + WithoutValue.GetText());
		}
		ReportUnknown();
	}

	void ReportUnknown()
	{
		FSettingNameList List;
		for (size_t Index = 0; Index < Result.Unknown.size(); ++Index)
		{
			const std::string& Key = Result.Unknown[Index].Key;
			const std::string Nearest = List.GetNum() < FSettingNameList::MaxListed ? FindNearlySameName(Key) : "";
			List.Add(Key + (Nearest.empty() ? "" : " (did you mean " + Nearest + "?)"), UnknownOffsets[Index]);
		}
		if (List.GetNum() > 0)
		{
			Messages.Warn(WarnTextUnknownFields, List.GetOffset(), Where + "Settings",
				"no settings of drydock's, kept as text: " + List.GetText());
		}
	}

	const std::string& Where;
	FSettingsTextMessages& Messages;
	FSettingsText Result;
	std::map<std::string, size_t> Given; // by key; unknown ones in lower case
	std::map<const FSettingField*, size_t> ValueOffsets;
	std::map<const FSettingField*, size_t> BitOffsets;
	std::vector<size_t> UnknownOffsets;
	size_t NumErrors = 0;
	std::string LastKnown;
};

} // namespace

FSettingsText ReadSettingsStruct(
	const FEngineTextValue& Struct, const std::string& Where, FSettingsTextMessages& Messages)
{
	return FStructReader(Where, Messages).Read(Struct);
}

FSettingsText ReadSettingsText(const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	FSettingsTextMessages Messages(Text, File, Diagnostics);
	size_t Offset = Text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
	FEngineTextValue Struct;
	if (!CheckEngineTextEncoding(Text, Messages) || !ParseEngineText(Text, Offset, "", Struct, Messages))
	{
		return {};
	}
	SkipEngineTextSpace(Text, Offset);
	if (Struct.Kind != EEngineTextKind::Struct)
	{
		Messages.Error(ErrorTextSyntax, Struct.Offset, "", "expected (NAME=VALUE,..), found " + Struct.Describe());
	}
	else if (Offset < Text.size())
	{
		Messages.Error(ErrorTextSyntax, Offset, "",
			"expected the end of the text after the closing ), found " + DescribeEngineTextAt(Text, Offset));
	}
	return ReadSettingsStruct(Struct, "", Messages);
}

std::vector<std::string> UpgradeSettings(FPostProcessSettings& Settings)
{
	std::vector<std::string> Changed;
	if (Settings.BloomMethod != BM_FFT || !(Settings.BloomIntensity > 0.0f))
	{
		return Changed;
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		if (!IsBloomStrength(Field.Name, Field.Category, Field.Type == ESettingType::Float))
		{
			continue;
		}
		FSettingValue Value = Field.Get(Settings);
		const bool bGiven = Field.IsOverridden(Settings) || !(Value == Field.Default);
		if (bGiven && Value.Components[0] != 1.0)
		{
			Value.Components[0] = 1.0;
			Field.Set(Settings, Value);
			Changed.emplace_back(Field.Name);
		}
	}
	return Changed;
}

} // namespace Drydock
