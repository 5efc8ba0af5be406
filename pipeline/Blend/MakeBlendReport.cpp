// Blends a config's settings once more, with the ledger, and lets its view extensions edit them.
#include "Blend/MakeBlendReport.h"

#include "Extensions/ViewExtensions.h"
#include "Run/FinalSettings.h"
#include "Run/RunSetup.h"

namespace Drydock
{

namespace
{

/** View extensions have the last word: what those of the config and its plugins do to the settings in SetupView, on a
 * view that has no frame. */
void AddExtensionEdits(const FRunSetup& Setup, FBlendReport& Report)
{
	FHookLog Log;
	FViewExtensionFrame Extensions(Setup.Config.GetEngineProfile(), Log);
	FSceneViewFamily Family;
	Family.EngineShowFlags = Setup.Settings.ShowFlags;
	Extensions.Gather(Family, Setup.Plugins);
	Extensions.SetupViewFamily(Family);

	FViewInfo View;
	View.Family = &Family;
	View.ViewLocation = Report.Location;
	View.FinalPostProcessSettings = Report.Blended.Settings;
	Family.Views.Add(&View);
	Extensions.SetupView(Family, {&View, ""}, Report.Blended.Gates, &Report.Ledger);
	Report.Blended.Settings = View.FinalPostProcessSettings;
	Report.Diagnostics.insert(Report.Diagnostics.end(), Log.Diagnostics.begin(), Log.Diagnostics.end());
}

} // namespace

FBlendReport MakeBlendReport(const FRunSetup& Setup, const std::string& LocationFrom, bool bExtensions)
{
	const FSettingsBlender Blender = MakeSettingsBlender(Setup.Config);
	FBlendReport Report;
	Report.Config = Setup.Config.File;
	Report.Location = GetViewLocation(Setup.Config);
	Report.LocationFrom = LocationFrom;
	for (const APostProcessVolume& Volume : Blender.GetInputs().Volumes)
	{
		Report.VolumeNames.emplace_back(*Volume.Name);
		Report.VolumeProperties.push_back(Volume.GetProperties());
		Report.VolumeProperties.back().Settings = nullptr; // the blender's, which ends here
	}
	Report.Volumes = Blender.FindVolumes(Report.Location);
	Report.Blended = Blender.At(Report.Location, &Report.Ledger);
	Report.Diagnostics = Setup.Diagnostics;
	if (bExtensions)
	{
		AddExtensionEdits(Setup, Report);
	}
	return Report;
}

} // namespace Drydock
