// The tables of hooks and insertion points, and what is asked of them.
#include "Extensions/EngineHooks.h"

#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr const char* HooksText =
#include "EngineHooks.txt"
	;

std::vector<FHookVersions> ReadHooks()
{
	const std::vector<FEngineProfile>& Engines = GetEngineProfiles();
	std::vector<FHookVersions> Hooks;
	for (std::vector<std::string>& Columns : SplitRows(HooksText))
	{
		check(Columns.size() == 5);
		std::ranges::replace(Columns, "-", "");
		const int32 First = Columns[1].empty() ? Engines.front().Minor : std::stoi(Columns[1]);
		const int32 Last = Columns[2].empty() ? Engines.back().Minor : std::stoi(Columns[2]);
		Hooks.push_back({EExtensionHook(Hooks.size()), Columns[0], First, Last, Columns[3], Columns[4]});
	}
	return Hooks;
}

} // namespace

const std::vector<FHookVersions>& GetHookVersions()
{
	static const std::vector<FHookVersions> Versions = ReadHooks();
	return Versions;
}

const FHookVersions& GetHookVersions(EExtensionHook Hook)
{
	return GetHookVersions()[static_cast<size_t>(Hook)];
}

std::string GetHookName(EExtensionHook Hook)
{
	const std::string& Signature = GetHookVersions(Hook).Signature;
	const std::string Name = Signature.substr(0, Signature.find('('));
	return Name.substr(0, Name.find("_RenderThread"));
}

bool IsHookCalled(EExtensionHook Hook, int32 EngineMinor)
{
	const FHookVersions& Versions = GetHookVersions(Hook);
	return EngineMinor >= Versions.First && EngineMinor <= Versions.Last;
}

const char* ToString(EColorSpace Space)
{
	return Space == EColorSpace::LinearHDR ? "linear HDR, pre-exposed" : "display-encoded";
}

const std::vector<FInsertionPoint>& GetInsertionPoints()
{
	using enum ISceneViewExtension::EPostProcessingPass;
	constexpr EColorSpace Linear = EColorSpace::LinearHDR;
	constexpr EColorSpace Display = EColorSpace::DisplayEncoded;
	// clang-format off
	static const std::vector<FInsertionPoint> Points = {
		{BeforeDOF, Linear, 5, "before depth of field"},
		{AfterDOF, Linear, 5, "after depth of field"},
		{TranslucencyAfterDOF, Linear, 5, "the separate translucency, alpha = transmittance"},
		{SSRInput, Linear, 1, "what the next frame's screen-space reflections read; the picture goes on unmodified"},
		{MotionBlur, Linear, 1, "after motion blur; exposure and bloom see the result"},
		{ReplacingTonemapper, Linear, 5, "in place of the tonemapper: reads colour and bloom, writes display-encoded"},
		{Tonemap, Display, 1, "after the tonemapper"},
		{FXAA, Display, 1, "after antialiasing"},
		{SMAA, Display, 7, "after the antialiasing of that name, which is not simulated: the pass is never enabled"},
		{VisualizeDepthOfField, Display, 1, "the last one"},
	};
	// clang-format on
	return Points;
}

const FInsertionPoint& GetInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass)
{
	const FInsertionPoint* const Found = FindItem(GetInsertionPoints(), Pass, &FInsertionPoint::Pass);
	check(Found != nullptr);
	return *Found;
}

bool HasInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass, int32 EngineMinor)
{
	return EngineMinor >= GetInsertionPoint(Pass).First;
}

std::string GetEngineVersionText(int32 EngineMinor)
{
	return FEngineProfile{.Minor = EngineMinor}.GetVersion();
}

} // namespace Drydock
