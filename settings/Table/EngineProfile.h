// Lists the differences between the versions of engine 5: one row of data for each version that drydock knows. A
// config's `engine` chooses the row of a run, and the whole row goes to whatever obeys it. Extensions/EngineHooks.h
// lists the hooks and insertion points of each version, by the same numbers. Source: engine 5.3 and 5.4, as far as they
// are described publicly; sources for the others stand beside the field.
#pragma once

#include "CoreMinimal.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FEngineProfile
{
	/** Engine 5.Minor. */
	int32 Minor = 4;

	/** The start of LocalExposureShadowContrastScale is r.DefaultFeature.LocalExposure.HighlightContrastScale in place
	 * of the shadows' own variable: a mistake of 5.3. It is not known of others, which therefore lack it. */
	bool bShadowContrastOfHighlights = false;

	/** In bloom's setup pass the ramp saturate((luminance - BloomThreshold) / 2) acts at a threshold of -1 and below as
	 * well: so in 5.3 and before, as in engine 4. From 5.4 there is no ramp then. */
	bool bBloomRampWithoutThreshold = false;

	/** LocalExposureHighlightThreshold and LocalExposureShadowThreshold act: from 5.4. Before, there are no such
	 * settings. */
	bool bLocalExposureThresholds = true;

	/** A shader that reads a uniform buffer which its parameter struct lacks ends the run: in 5.2 and before. From 5.3
	 * the engine reports it by ensureMsgf and goes on. Two public copies of 5.x go on, older ones of 4.25 to 5.0 end;
	 * it is not known which of them 5.1 and 5.2 are like. */
	bool bUnboundBufferEnds = false;

	/** "5.4". */
	DRYDOCK_API std::string GetVersion() const;
};

/** Ascending, without gaps. */
DRYDOCK_API const std::vector<FEngineProfile>& GetEngineProfiles();

/** Null when there is no row for 5.Minor. */
DRYDOCK_API const FEngineProfile* FindEngineProfile(int32 Minor);

/** The row of 5.Minor, or of the oldest or newest version that there is one of. */
DRYDOCK_API const FEngineProfile& GetNearestEngineProfile(int32 Minor);

/** Version: "5.4". Null when there is no such row. */
DRYDOCK_API const FEngineProfile* FindEngineProfile(const std::string& Version);

/** The row of 5.4: of configs that name no version. */
DRYDOCK_API const FEngineProfile& GetDefaultEngineProfile();

/** The versions of all rows, with Separator between them. */
DRYDOCK_API std::string ListEngineVersions(const char* Separator);

} // namespace Drydock
