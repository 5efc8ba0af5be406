// Writes settings as text that the engine's editor takes when it is pasted.
#include "PostProcessSettingsText.h"

#include "PostProcessSettingsTextNames.h"
#include "PostProcessSettingsTextValue.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace Drydock
{

namespace
{

/** Sign of zero included. */
bool IsSameNumber(double A, double B)
{
	return A == B && std::signbit(A) == std::signbit(B);
}

/** Whether one element of a field has its default value; Index as in WriteSettingText. */
bool IsDefault(const FSettingField& Field, const FSettingValue& Value, int Index = 0)
{
	const int NumParts = std::max(1, Field.GetNumComponents() / GetNumTextElements(Field));
	const double* const Begin = Value.Components + Index * NumParts;
	return Value.Object == Field.Default.Object &&
		   std::equal(Begin, Begin + NumParts, Field.Default.Components + Index * NumParts, IsSameNumber);
}

/** The key of an element as the table spells it. */
std::string GetElementKey(const FSettingField& Field, int Index)
{
	return GetNumTextElements(Field) == 1 ? Field.Name : std::string(Field.Name) + "[" + std::to_string(Index) + "]";
}

class FStructWriter
{
public:
	FStructWriter(const FSettingsText& InSettings, ESettingsTextForm InForm)
		: Settings(InSettings)
		, Form(InForm)
	{
		for (const FUnknownSetting& Unknown : Settings.Unknown)
		{
			UnknownAfter[Unknown.After].push_back(&Unknown);
		}
	}

	std::string Write()
	{
		AddUnknownAfter("");
		const bool bFull = Form == ESettingsTextForm::Full;
		for (const FSettingField& Field : GetSettingFields())
		{
			const bool bOverridden = Field.IsOverridden(Settings.Settings);
			Add(Field.OverrideName, bOverridden ? "True" : "False", bFull || bOverridden);
		}
		for (const FSettingField& Field : GetSettingFields())
		{
			const FSettingValue Value = Field.Get(Settings.Settings);
			for (int Index = 0; Index < GetNumTextElements(Field); ++Index)
			{
				const bool bWritten = bFull || Field.IsOverridden(Settings.Settings) || !IsDefault(Field, Value, Index);
				Add(GetElementKey(Field, Index), bWritten ? WriteSettingText(Field, Value, Index) : "", bWritten);
			}
			const bool bWritten = bFull || Field.IsOverridden(Settings.Settings) || !IsDefault(Field, Value);
			if (bWritten)
			{
				CheckDecimals(Field, Value);
			}
			AddUnknownAfter(Field.Name); // of an array whose elements have indices: behind the last
		}
		const FWeightedBlendables& Blendables = Settings.Settings.WeightedBlendables;
		Add(BlendablesName, WriteBlendablesText(Blendables), bFull || Blendables.Array.Num() > 0);
		while (!UnknownAfter.empty())
		{
			AddUnknownAfter(std::string(UnknownAfter.begin()->first));
		}
		return "(" + Text + ")";
	}

	const FSettingNameList& GetChanged() const { return Changed; }

private:
	void AddPair(const std::string& Key, const std::string& Value)
	{
		Text += std::string(Text.empty() ? "" : ",") + Key + "=" + Value;
	}

	void Add(const std::string& Key, const std::string& Value, bool bWritten)
	{
		if (bWritten)
		{
			AddPair(Key, Value);
		}
		AddUnknownAfter(Key);
	}

	void AddUnknownAfter(const std::string& Key)
	{
		const auto Found = UnknownAfter.find(Key);
		if (Found == UnknownAfter.end())
		{
			return;
		}
		for (const FUnknownSetting* Unknown : Found->second)
		{
			AddPair(Unknown->Key, Unknown->Text);
		}
		UnknownAfter.erase(Found);
	}

	void CheckDecimals(const FSettingField& Field, const FSettingValue& Value)
	{
		const bool bDouble = Field.Type == ESettingType::Vector2 || Field.Type == ESettingType::Vector4;
		for (int Index = 0; Index < Field.GetNumComponents(); ++Index)
		{
			const double Number = Value.Components[Index];
			const std::string Written = WriteNumberText(Number);
			const double Read = std::strtod(Written.c_str(), nullptr);
			if (!std::isfinite(Number) || (bDouble ? Read : static_cast<double>(static_cast<float>(Read))) != Number)
			{
				Changed.Add(std::string(Field.Name) + " (" + SettingToText(Field, Value) + ")", 0);
				return;
			}
		}
	}

	const FSettingsText& Settings;
	ESettingsTextForm Form;
	std::map<std::string, std::vector<const FUnknownSetting*>> UnknownAfter;
	std::string Text;
	FSettingNameList Changed;
};

} // namespace

std::string WriteSettingsText(
	const FSettingsText& Settings, ESettingsTextForm Form, std::vector<FDiagnostic>& Diagnostics)
{
	FStructWriter Writer(Settings, Form);
	const std::string Text = Writer.Write();
	if (Writer.GetChanged().GetNum() > 0)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Severity = ESeverity::Warning;
		Diagnostic.Code = WarnTextDecimals;
		Diagnostic.Message = "six decimals do not hold these values: " + Writer.GetChanged().GetText();
		Diagnostics.push_back(Diagnostic);
	}
	return Text;
}

} // namespace Drydock
