// Reads the table of layer names, and finds the row that a layer's name fits.
#include "Import/ImportTargets.h"

#include "RangeTools.h"
#include "TextTools.h"

#include <cctype>
#include <string_view>

namespace Drydock
{

namespace
{

constexpr const char* NamesText =
#include "ImportNames.txt"
	;

std::string KeepLettersAndDigits(std::string_view Name)
{
	std::string Text;
	for (const char Character : Name)
	{
		if (std::isalnum(static_cast<unsigned char>(Character)) != 0)
		{
			Text += ToLowerCase(Character);
		}
	}
	return Text;
}

/** Letters and digits between anything else, in small letters. */
std::vector<std::string> SplitWords(const std::string& Name)
{
	std::vector<std::string> Words(1);
	for (const char Character : Name)
	{
		if (std::isalnum(static_cast<unsigned char>(Character)) == 0)
		{
			Words.emplace_back();
			continue;
		}
		Words.back() += ToLowerCase(Character);
	}
	return Words;
}

/** Without what Unreal puts before every material's name. */
std::string_view StripPrefixes(std::string_view Name)
{
	for (const std::string_view Prefix : {"finalimage", "movierenderqueue"})
	{
		if (Name.size() > Prefix.size() && Name.starts_with(Prefix))
		{
			Name.remove_prefix(Prefix.size());
		}
	}
	return Name;
}

const std::vector<FImportNameRule>& GetNameRules()
{
	static const std::vector<FImportNameRule> Rules = ToVector<FImportNameRule>(SplitRows(NamesText),
		[](const std::vector<std::string>& Columns)
		{
			return FImportNameRule{Columns[0], Columns[1] == "-" ? "" : Columns[1], std::stoi(Columns[2]),
				Columns[3] == "word", Columns.size() > 4 ? Columns[4] : ""};
		});
	return Rules;
}

/** 3 the whole name, 2 its end or a word of it, 1 a part of it, 0 none. */
int GetFit(const FImportNameRule& Rule, std::string_view Name, std::string_view Stripped,
	const std::vector<std::string>& Words)
{
	const std::string_view Keyword = Rule.Keyword;
	if (Name == Keyword || Stripped == Keyword)
	{
		return 3;
	}
	if (Rule.bWord)
	{
		return Contains(Words, Keyword) ? 2 : 0;
	}
	constexpr size_t LongEnough = 5; // shorter ones are parts of other words
	return Name.ends_with(Keyword)                                                            ? 2
		   : Keyword.size() >= LongEnough && Stripped.find(Keyword) != std::string_view::npos ? 1
																							  : 0;
}

} // namespace

const std::vector<FImportTarget>& GetImportTargets()
{
	static const std::vector<FImportTarget> Targets = {
		{"color", {"R", "G", "B", "A"}, EImportKind::Color, 1},
		{"depth", {"depth.Z"}, EImportKind::Depth, 1},
		{"normal", {"normal.X", "normal.Y", "normal.Z"}, EImportKind::Normal, 3},
		{"velocity", {"velocity.X", "velocity.Y"}, EImportKind::Velocity, 2},
		{"basecolor", {"basecolor.R", "basecolor.G", "basecolor.B"}, EImportKind::Part, 3},
		{"shadingmodel", {"shadingmodel.ID"}, EImportKind::Number, 1},
		{"custommask", {"custommask.B"}, EImportKind::Part, 1},
		{"shadow", {"shadow.R", "shadow.G"}, EImportKind::Part, 1},
		{"customdepth", {"customdepth.Z"}, EImportKind::Depth, 1},
		{"customstencil", {"customstencil.ID"}, EImportKind::Number, 1},
		{"translucency", {"translucency.R", "translucency.G", "translucency.B", "translucency.A"}, EImportKind::Part,
			4},
		{"metallic", {"metallic"}, EImportKind::Part, 1},
		{"specular", {"specular"}, EImportKind::Part, 1},
		{"roughness", {"roughness"}, EImportKind::Part, 1},
		{"ambientocclusion", {"ambientocclusion"}, EImportKind::Part, 1},
	};
	return Targets;
}

const FImportTarget* FindImportTarget(const std::string& Group)
{
	const std::vector<FImportTarget>& Targets = GetImportTargets();
	return FindItem(Targets, Group, &FImportTarget::Group);
}

const FImportNameRule* FindImportNameRule(const std::string& Name)
{
	// Blender and others put the view layer before the pass: "ViewLayer.Depth".
	const size_t Dot = Name.rfind('.');
	const std::string Last = Dot == std::string::npos ? Name : Name.substr(Dot + 1);
	const std::string Plain = KeepLettersAndDigits(Last);
	const std::string_view Stripped = StripPrefixes(Plain);
	const std::vector<std::string> Words = SplitWords(Last);
	const FImportNameRule* Best = nullptr;
	std::pair<int, size_t> BestFit = {0, 0};
	for (const FImportNameRule& Rule : GetNameRules())
	{
		const std::pair<int, size_t> Fit = {
			GetFit(Rule, Plain, Stripped, Words), std::string_view(Rule.Keyword).size()};
		if (Fit.first > 0 && Fit > BestFit)
		{
			Best = &Rule;
			BestFit = Fit;
		}
	}
	return Best;
}

} // namespace Drydock
