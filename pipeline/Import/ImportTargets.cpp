// The table of layer names. Sources: "Cinematic Render Passes" (Epic: World Depth, Motion Vectors, Object Ids), the
// names that Unreal's buffer visualisation has for its materials, "Passes" (Blender manual) and the names by which
// Blender writes them.
#include "Import/ImportTargets.h"

#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace Drydock
{

namespace
{

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
	constexpr const char* Display = "is encoded for a display";
	constexpr const char* Denoiser = "is made for a denoiser";
	constexpr const char* Crypto = "holds object ids: --toon and --stencil choose objects of it by name";
	static const std::vector<FImportNameRule> Rules = {
		{"scenecolor", "color", 5},
		{"pretonemaphdrcolor", "color", 6},
		{"combined", "color", 4},
		{"beauty", "color", 4},
		{"finalimage", "color", 3},
		{"rgba", "color", 4, true},
		{"rgb", "color", 3, true},
		{"color", "color", 3, true},
		{"colour", "color", 3, true},
		{"worlddepth", "depth", 6},
		{"scenedepthworldunits", "depth", 6},
		{"depth", "depth", 5},
		{"z", "depth", 5, true},
		{"scenedepth", "depth", 2, false, "may be scaled for a display: SceneDepthWorldUnits and WorldDepth are not"},
		{"mist", "depth", 1, true, "needs --mist START,DEPTH"},
		{"worldnormal", "normal", 6},
		{"normal", "normal", 5},
		{"normals", "normal", 5},
		{"n", "normal", 4, true},
		{"cameranormal", "normal", 3, false, "in the camera's space"},
		{"viewnormal", "normal", 3, false, "in the camera's space"},
		{"normalcamera", "normal", 3, false, "in the camera's space"},
		{"normalview", "normal", 3, false, "in the camera's space"},
		{"motionvectors", "velocity", 6},
		{"motionvector", "velocity", 6},
		{"velocity", "velocity", 5},
		{"vector", "velocity", 5, true},
		{"motion", "velocity", 4, true},
		{"mv", "velocity", 4, true},
		{"basecolor", "basecolor", 6},
		{"albedo", "basecolor", 5},
		{"diffcol", "basecolor", 4},
		{"diffusecolor", "basecolor", 4},
		{"shadingmodelid", "shadingmodel", 6},
		{"shadingmodel", "shadingmodel", 5},
		{"indexma", "shadingmodel", 3},
		{"materialindex", "shadingmodel", 3},
		{"matid", "shadingmodel", 3},
		{"custommask", "custommask", 6},
		{"toonmask", "custommask", 5},
		{"outlineid", "custommask", 5},
		{"shadow", "shadow", 5, true},
		{"customdepth", "customdepth", 6},
		{"customstencil", "customstencil", 6},
		{"stencil", "customstencil", 5, true},
		{"indexob", "customstencil", 3},
		{"objectindex", "customstencil", 3},
		{"objectid", "customstencil", 3},
		{"id", "customstencil", 2, true},
		{"ids", "customstencil", 2, true},
		{"separatetranslucency", "translucency", 6},
		{"separatetranslucencyrgb", "translucency", 6},
		{"separatetranslucencya", "translucency", 6},
		{"translucency", "translucency", 5, true},
		{"metallic", "metallic", 5},
		{"metalness", "metallic", 5},
		{"specular", "specular", 5, true},
		{"roughness", "roughness", 5},
		{"ambientocclusion", "ambientocclusion", 5},
		{"materialao", "ambientocclusion", 6},
		{"ao", "ambientocclusion", 4, true},
		{"drydockids", "ids", 6},
		{"posttonemaphdrcolor", "", 0, false, Display},
		{"noisyimage", "", 0, false, "is the colour before a denoiser"},
		{"denoisingnormal", "", 0, false, Denoiser},
		{"denoisingalbedo", "", 0, false, Denoiser},
		{"denoisingdepth", "", 0, false, Denoiser},
		{"actorhitproxymask", "", 0, false, Crypto},
		{"cryptoobject", "", 0, false, Crypto},
		{"cryptomaterial", "", 0, false, Crypto},
		{"cryptoasset", "", 0, false, Crypto},
		{"cryptomatte", "", 0, false, Crypto},
	};
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
		return std::ranges::find(Words, Keyword) != Words.end() ? 2 : 0;
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
	const auto Found = std::ranges::find(Targets, Group, &FImportTarget::Group);
	return Found == Targets.end() ? nullptr : &*Found;
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
