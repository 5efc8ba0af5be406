// Makes the table row by row; a row that all versions agree on is left out.
#include "VersionTable.h"

#include "ExtensionFactory.h"
#include "Extensions/EngineHooks.h"
#include "Patch/EngineApi.h"

#include <algorithm>
#include <vector>

namespace Drydock
{

namespace
{

struct FVersionRow
{
	std::string What;
	std::vector<bool> Holds; // by version, as GetEngineProfiles
};

FVersionRow MakeProfileRow(const std::string& What, bool FEngineProfile::*Member)
{
	FVersionRow Row{What, {}};
	for (const FEngineProfile& Profile : GetEngineProfiles())
	{
		Row.Holds.push_back(Profile.*Member);
	}
	return Row;
}

/** In a function of its own, so that a new member of the profile does not compile until it is listed here. */
std::vector<FVersionRow> MakeMathsRows()
{
	const auto& [Minor, bShadowContrast, bRamp, bThresholds, bUnbound] = GetDefaultEngineProfile();
	static_cast<void>(Minor);
	static_cast<void>(bShadowContrast);
	static_cast<void>(bRamp);
	static_cast<void>(bThresholds);
	static_cast<void>(bUnbound);
	return {
		MakeProfileRow("maths: `LocalExposureShadowContrastScale` starts at the highlights' console variable",
			&FEngineProfile::bShadowContrastOfHighlights),
		MakeProfileRow("maths: bloom's setup ramps at a `BloomThreshold` of -1 and below too",
			&FEngineProfile::bBloomRampWithoutThreshold),
		MakeProfileRow("settings: `LocalExposureHighlightThreshold` and `LocalExposureShadowThreshold` act",
			&FEngineProfile::bLocalExposureThresholds),
		MakeProfileRow("shaders: one that reads `View` without having it in its parameters ends the run (5.1 and 5.2 "
					   "are uncertain)",
			&FEngineProfile::bUnboundBufferEnds),
	};
}

std::vector<FVersionRow> MakeHookRows()
{
	std::vector<FVersionRow> Rows;
	for (const FHookVersions& Hook : GetHookVersions())
	{
		FVersionRow Row{std::string("hook `") + Hook.Signature + "`", {}};
		for (const FEngineProfile& Profile : GetEngineProfiles())
		{
			Row.Holds.push_back(IsHookCalled(Hook.Hook, Profile.Minor));
		}
		Rows.push_back(Row);
	}
	return Rows;
}

std::vector<FVersionRow> MakePointRows()
{
	std::vector<FVersionRow> Rows;
	for (const FInsertionPoint& Point : GetInsertionPoints())
	{
		FVersionRow Row{"insertion point `" + std::string(GetPassName(Point.Pass)) + "`: " + Point.Doc, {}};
		for (const FEngineProfile& Profile : GetEngineProfiles())
		{
			Row.Holds.push_back(HasInsertionPoint(Point.Pass, Profile.Minor));
		}
		Rows.push_back(Row);
	}
	return Rows;
}

} // namespace

std::string MakeVersionTable()
{
	std::string Head = "| what |";
	std::string Rule = "|---|";
	for (const FEngineProfile& Profile : GetEngineProfiles())
	{
		Head += " " + Profile.GetVersion() + " |";
		Rule += "---|";
	}
	std::string Table = Head + "\n" + Rule + "\n";
	for (const std::vector<FVersionRow>& Rows : {MakeHookRows(), MakePointRows(), MakeMathsRows()})
	{
		for (const FVersionRow& Row : Rows)
		{
			const auto NumHolding = std::count(Row.Holds.begin(), Row.Holds.end(), true);
			if (NumHolding == 0 || NumHolding == static_cast<std::ptrdiff_t>(Row.Holds.size()))
			{
				continue;
			}
			Table += "| " + Row.What + " |";
			for (const bool bHolds : Row.Holds)
			{
				Table += bHolds ? " yes |" : " |";
			}
			Table += "\n";
		}
	}
	for (const FEngineApiRow& Row : GetEngineApi())
	{
		const std::string Kind = Row.Kind;
		Table += "| name `" + std::string(Row.Name) + "`" +
				 (std::string(Row.Certainty) == "Uncertain" ? " (uncertain)" : "") +
				 (Kind == "deprecated" ? ": use `" + std::string(Row.Instead) + "`" : "") + " |";
		for (const FEngineProfile& Profile : GetEngineProfiles())
		{
			const bool bBefore = Profile.Minor < Row.Minor;
			const bool bThere = Kind == "from" ? !bBefore : Profile.Minor <= Row.Minor;
			Table += Kind == "deprecated" ? (bBefore ? " yes |" : " deprecated |") : bThere ? " yes |" : " |";
		}
		Table += "\n";
	}
	return Table;
}

} // namespace Drydock
