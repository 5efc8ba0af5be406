// The engine overlays of a run: reads their folders, checks what they fill, builds their code, and makes them act for
// the run's length.
#pragma once

#include "Config/Config.h"
#include "Overlay/OverlayFolder.h"
#include "PassFunctions.h"
#include "PostProcessSettingsReflection.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The overlays of a config in the order in which they stack: a later one stands over the earlier ones. */
struct FOverlaysOfRun
{
	std::vector<FOverlayFolder> Folders;
};

/** Reads the folders of Config.Overlays and builds their libraries below build/ in the working folder. A mistake is an
 * error in Diagnostics, and then nothing is built. bRefuseCode: an overlay with C++ is an error. */
DRYDOCK_API FOverlaysOfRun PrepareOverlays(
	const FConfig& Config, bool bRefuseCode, std::vector<FDiagnostic>& Diagnostics);

/** Appends a note on each overlay: what it stands in for, by what shader classes name and by what its library has
 * registered, which must be loaded (LoadPlugins). A function of a pass's name that does not fill the pass's place is an
 * error. */
DRYDOCK_API void ReportOverlays(
	const FConfig& Config, const FOverlaysOfRun& Overlays, std::vector<FDiagnostic>& Diagnostics);

/** While it lives, the overlays act: their shaders stand before drydock's, their functions in the table. The libraries
 * must be loaded (LoadPlugins). */
class DRYDOCK_API FScopedOverlays : private FNoncopyable
{
public:
	explicit FScopedOverlays(const FOverlaysOfRun& Overlays);
	~FScopedOverlays();

private:
	std::vector<std::string> ShadersBefore;
	FScopedPassReplacements Replacements;
	std::vector<std::pair<std::string, FSettingValue>> DefaultsBefore;
};

} // namespace Drydock
