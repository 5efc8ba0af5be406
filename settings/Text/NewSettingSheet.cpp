// Fills SettingPlaces.txt in for some settings.
#include "NewSettingSheet.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace Drydock
{

namespace
{

constexpr const char* PlacesText =
#include "SettingPlaces.txt"
#include "TextTools.h"
	;

/** A struct that holds a family of settings a second time, under names of its own. */
struct FTwinStruct
{
	const char* Prefix;
	const char* Struct;
	bool bChecked; // the editor stops at its start where a member is missing
};

constexpr FTwinStruct TwinStructs[] = {
	{"BloomConvolution", "FConvolutionBloomSettings", true},
	{"BloomDirtMask", "FLensImperfectionSettings", true},
	{"Bloom", "FGaussianSumBloomSettings", true},
	{"FilmGrain", "FFilmGrainSettings", false},
	{"Film", "FFilmStockSettings", false},
	{"AutoExposure", "FCameraExposureSettings", false},
};

const FTwinStruct* FindTwinStruct(const std::string& Name)
{
	const auto Found = std::find_if(std::begin(TwinStructs), std::end(TwinStructs),
		[&](const FTwinStruct& Twin) { return Name.starts_with(Twin.Prefix) && Name != Twin.Prefix; });
	return Found == std::end(TwinStructs) ? nullptr : Found;
}

/** "ToonIntensity" of BloomToonIntensity, "Filter1Size" of Bloom1Size. */
std::string GetTwinName(const std::string& Name, const FTwinStruct& Twin)
{
	const bool bImperfection = std::string(Twin.Prefix) == "BloomDirtMask"; // its members keep DirtMask
	const std::string Rest = Name.substr(std::string(bImperfection ? "Bloom" : Twin.Prefix).size());
	return Rest[0] >= '0' && Rest[0] <= '9' ? "Filter" + Rest : Rest;
}

/** "Toon Intensity" */
std::string GetDisplayName(const std::string& Name)
{
	std::string Text;
	for (const char Character : Name)
	{
		const bool bUpper = Character >= 'A' && Character <= 'Z';
		const bool bWasLower = !Text.empty() && !(Text.back() >= 'A' && Text.back() <= 'Z');
		Text += std::string(bUpper && bWasLower ? " " : "") + Character;
	}
	return Text;
}

std::string DeclareMember(const FNewSetting& Setting, const std::string& Name)
{
	if (Setting.Type == "bool")
	{
		return "uint8 " + Name + ":1;";
	}
	return Setting.Type + " " + Name +
		   (Setting.NumElements > 1 ? "[" + std::to_string(Setting.NumElements) + "];" : ";");
}

/** UPROPERTY's meta of the range, with a comma behind each entry. */
std::string FormatMeta(const FNewSetting& Setting)
{
	std::string Meta = Setting.ClampMin.empty() ? "" : "ClampMin = \"" + Setting.ClampMin + "\", ";
	Meta += Setting.ClampMax.empty() ? "" : "ClampMax = \"" + Setting.ClampMax + "\", ";
	return Meta +
		   (Setting.UIMax.empty() ? "" : "UIMin = \"" + Setting.ClampMin + "\", UIMax = \"" + Setting.UIMax + "\", ");
}

/** The table's description without the remark that drydock added the setting. */
std::string MakeDoc(const std::string& Doc)
{
	const std::string Remark = "drydock: ";
	if (!Doc.starts_with(Remark) || Doc.size() == Remark.size())
	{
		return Doc;
	}
	std::string Text = Doc.substr(Remark.size());
	Text[0] = Text[0] >= 'a' && Text[0] <= 'z' ? static_cast<char>(Text[0] - 'a' + 'A') : Text[0];
	return Text;
}

/** Words for the brackets of the table, and texts for its braces. */
struct FSettingWords
{
	FSettingWords(const FNewSetting& Setting, ESettingPlanForm Form)
	{
		const FTwinStruct* const Twin = FindTwinStruct(Setting.Name);
		// The engine's switches for bloom set to 0 what multiplies the bloom. A strength of bloom that the engine does
		// not have is for something that the G-buffer marks.
		const bool bSwitchedOff = IsBloomStrength(Setting.Name, Setting.Category, Setting.Type == "float");
		const bool bBloom = Setting.Category == "Lens|Bloom";
		const bool bOwn = !Setting.bInTable || Setting.Doc.starts_with("drydock: ");
		const bool bListed = Setting.Blend == ESettingBlend::Accumulate || Setting.Blend == ESettingBlend::LUT;
		Conditions = {bListed ? "Listed" : ToString(Setting.Blend), Setting.NumElements > 1 ? "Array" : "",
			Twin != nullptr ? "Twin" : "", Twin != nullptr && Twin->bChecked ? "CheckedTwin" : "",
			bSwitchedOff ? "SwitchedOff" : "", bBloom ? "Bloom" : "", bBloom && bSwitchedOff && bOwn ? "Marked" : "",
			Form == ESettingPlanForm::Printed ? "Printed" : "Corrected"};
		const std::string TwinName = Twin == nullptr ? Setting.Name : GetTwinName(Setting.Name, *Twin);
		Texts = {{"Name", Setting.Name}, {"Override", Setting.OverrideName}, {"Category", Setting.Category},
			{"Doc", MakeDoc(Setting.Doc)}, {"Meta", FormatMeta(Setting)}, {"Display", GetDisplayName(Setting.Name)},
			{"Declaration", DeclareMember(Setting, Setting.Name)}, {"Default", Setting.Default},
			{"Num", std::to_string(Setting.NumElements)}, {"Last", std::to_string(Setting.NumElements - 1)},
			{"TwinStruct", Twin == nullptr ? "" : Twin->Struct}, {"TwinName", TwinName},
			{"TwinDisplay", GetDisplayName(TwinName)}, {"TwinDeclaration", DeclareMember(Setting, TwinName)},
			{"Short", TwinName}};
		AddPassTypes(Setting, TwinName);
	}

	/** Whether a line with these words in brackets is for the setting: all of them, and none with "!" before it. */
	bool Fit(const std::string& Brackets) const
	{
		std::istringstream Words(Brackets);
		return std::all_of(std::istream_iterator<std::string>(Words), std::istream_iterator<std::string>(),
			[&](const std::string& Word)
			{ return Word[0] == '!' ? Conditions.count(Word.substr(1)) == 0 : Conditions.count(Word) > 0; });
	}

	std::string FillIn(std::string Line) const
	{
		for (size_t Begin = 0; (Begin = Line.find('{', Begin)) != std::string::npos;)
		{
			const size_t End = Line.find('}', Begin);
			const auto Found = Texts.find(End == std::string::npos ? "" : Line.substr(Begin + 1, End - Begin - 1));
			if (Found != Texts.end())
			{
				Line.replace(Begin, End - Begin + 1, Found->second);
			}
			Begin += Found != Texts.end() ? Found->second.size() : 1;
		}
		return Line;
	}

private:
	/** Types and values on the way from the final settings to the shader. */
	void AddPassTypes(const FNewSetting& Setting, const std::string& Short)
	{
		const std::string& Type = Setting.Type;
		const bool bObject = Type.starts_with("TObjectPtr");
		const bool bWide = Type == "FLinearColor" || Type == "FVector4";
		const std::string Cpp = bWide                 ? "FLinearColor"
								: Type == "FVector2D" ? "FVector2f"
								: Type == "float"     ? "float"
								: bObject             ? "FRDGTextureRef"
													  : "int32";
		const std::string Final = "View.FinalPostProcessSettings." + Setting.Name;
		Texts["Cpp"] = Cpp;
		Texts["Initial"] = bObject ? " = nullptr;" : bWide || Cpp == "FVector2f" ? ";" : " = 0;";
		Texts["Parameter"] = bObject
								 ? "SHADER_PARAMETER_RDG_TEXTURE(Texture2D, " + Short + ")"
								 : "SHADER_PARAMETER(" + (Type == "FVector4" ? "FVector4f" : Cpp) + ", " + Short + ")";
		Texts["Value"] = Type == "FVector4"    ? "FLinearColor(" + Final + ")"
						 : Type == "FVector2D" ? "FVector2f(" + Final + ")"
						 : bObject             ? "/* registered texture of */ " + Final
											   : Final;
		Texts["Shader"] = bObject              ? "Texture2D"
						  : bWide              ? "float4"
						  : Cpp == "FVector2f" ? "float2"
						  : Cpp == "float"     ? "float"
											   : "int";
	}

	std::set<std::string> Conditions;
	std::map<std::string, std::string> Texts;
};

/** Places by their number in the table and where they are. */
using FPlacesByNumber = std::map<std::pair<int, std::string>, FSettingPlace>;

/** Adds the text behind a separator, unless the whole has it. */
void AddOnce(std::string& Whole, const std::string& Text, const char* Separator)
{
	Whole += Whole.find(Text) != Whole.npos ? "" : (Whole.empty() ? "" : Separator) + Text;
}

void AddPlaces(const FSettingWords& Words, FPlacesByNumber& Places)
{
	int Number = 0;
	bool bPlaceFits = false;
	std::string File;
	FSettingPlace* Place = nullptr;
	for (std::string Line : SplitText(PlacesText))
	{
		const size_t End = Line.starts_with('[') ? Line.find("] ") : std::string::npos;
		const bool bFits = End == std::string::npos || Words.Fit(Line.substr(1, End - 1));
		Line = End == std::string::npos ? Line : Line.substr(End + 2);
		const std::string Kind = Line.substr(0, Line.find(' '));
		const std::string Text = Words.FillIn(Line.substr(std::min(Kind.size() + 1, Line.size())));
		if (Kind == "file")
		{
			++Number;
			bPlaceFits = bFits;
			File = Text;
		}
		else if (Kind == "where" && bPlaceFits)
		{
			Place = &Places[{Number, Text}];
			Place->File = File;
			Place->Where = Text;
		}
		else if (bPlaceFits && bFits && Kind == "|")
		{
			Place->Text += (Place->Text.empty() ? "" : "\n") + Text;
		}
		else if (bPlaceFits && bFits && !Kind.empty())
		{
			AddOnce(Kind == "why" ? Place->Why : Place->Text, Text, Kind == "why" ? " " : "\n");
		}
	}
}

} // namespace

std::vector<FSettingPlace> MakeSettingPlan(const std::vector<FNewSetting>& Settings, ESettingPlanForm Form)
{
	FPlacesByNumber Places;
	for (const FNewSetting& Setting : Settings)
	{
		AddPlaces(FSettingWords(Setting, Form), Places);
	}
	std::vector<FSettingPlace> Plan;
	for (const auto& Each : Places)
	{
		const FSettingPlace& Place = Each.second;
		const auto Last = std::find_if(
			Plan.rbegin(), Plan.rend(), [&](const FSettingPlace& Other) { return Other.File == Place.File; });
		Plan.insert(Last == Plan.rend() ? Plan.end() : Last.base(), Place);
	}
	return Plan;
}

std::string FormatSettingPlan(const std::vector<FNewSetting>& Settings, ESettingPlanForm Form)
{
	std::string Text;
	std::string TableLines;
	for (const FNewSetting& Setting : Settings)
	{
		Text += Setting.Name + ": " + Setting.Type + ", default " + Setting.Default + ", " + Setting.Category +
				", blends by " + ToString(Setting.Blend) + "\n";
		TableLines += Setting.bInTable ? "" : "    " + MakeTableLine(Setting) + "\n";
	}
	Text += TableLines.empty() ? ""
							   : "In drydock each new setting is one line of settings/Table/"
								 "PostProcessSettingsTable.h:\n\n" +
									 TableLines + "\nIn the engine:\n";
	int Number = 0;
	for (const FSettingPlace& Place : MakeSettingPlan(Settings, Form))
	{
		Text += "\n" + std::to_string(++Number) + ". " + Place.File + "\n   " + Place.Where + "\n";
		Text += Place.Why.empty() ? "" : "   (" + Place.Why + ")\n";
		Text += "\n";
		for (const std::string& Line : SplitText(Place.Text))
		{
			Text += "    " + Line + "\n";
		}
	}
	return Text;
}

} // namespace Drydock
