// The table of engine versions, and its rows by number and by name.
#include "EngineProfile.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

template<class PredicateType>
const FEngineProfile* FindRow(const PredicateType& Predicate)
{
	const std::vector<FEngineProfile>& Rows = GetEngineProfiles();
	const auto Found = std::find_if(Rows.begin(), Rows.end(), Predicate);
	return Found == Rows.end() ? nullptr : &*Found;
}

} // namespace

const std::vector<FEngineProfile>& GetEngineProfiles()
{
	// clang-format off
	static const std::vector<FEngineProfile> Rows = {
		{.Minor = 1, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = true,  .bLocalExposureThresholds = false, .bUnboundBufferEnds = true},
		{.Minor = 2, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = true,  .bLocalExposureThresholds = false, .bUnboundBufferEnds = true},
		{.Minor = 3, .bShadowContrastOfHighlights = true,  .bBloomRampWithoutThreshold = true,  .bLocalExposureThresholds = false, .bUnboundBufferEnds = false},
		{.Minor = 4, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = false, .bLocalExposureThresholds = true,  .bUnboundBufferEnds = false},
		{.Minor = 5, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = false, .bLocalExposureThresholds = true,  .bUnboundBufferEnds = false},
		{.Minor = 6, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = false, .bLocalExposureThresholds = true,  .bUnboundBufferEnds = false},
		{.Minor = 7, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = false, .bLocalExposureThresholds = true,  .bUnboundBufferEnds = false},
		{.Minor = 8, .bShadowContrastOfHighlights = false, .bBloomRampWithoutThreshold = false, .bLocalExposureThresholds = true,  .bUnboundBufferEnds = false},
	};
	// clang-format on
	return Rows;
}

std::string FEngineProfile::GetVersion() const
{
	return "5." + std::to_string(Minor);
}

const FEngineProfile* FindEngineProfile(int32 Minor)
{
	return FindRow([Minor](const FEngineProfile& Row) { return Row.Minor == Minor; });
}

const FEngineProfile* FindEngineProfile(const std::string& Version)
{
	return FindRow([&Version](const FEngineProfile& Row) { return Row.GetVersion() == Version; });
}

const FEngineProfile& GetNearestEngineProfile(int32 Minor)
{
	const std::vector<FEngineProfile>& Rows = GetEngineProfiles();
	return *FindEngineProfile(std::clamp(Minor, Rows.front().Minor, Rows.back().Minor));
}

const FEngineProfile& GetDefaultEngineProfile()
{
	return *FindEngineProfile(FEngineProfile().Minor);
}

std::string ListEngineVersions(const char* Separator)
{
	return JoinText(GetEngineProfiles(), Separator, [&](const FEngineProfile& Row) { return Row.GetVersion(); });
}

} // namespace Drydock
