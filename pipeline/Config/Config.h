// A run's configuration as plain data, with the place of every value in its file. See configs/README.md; keys:
// ConfigKeys.txt.
#pragma once

#include "Config/OutputKinds.h"
#include "Config/SceneUnits.h"
#include "Diagnostics.h"
#include "EngineProfile.h"
#include "PostProcessSettings.h"
#include "PostProcessSettingsText.h"
#include "Text/Json.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The place of a value in the text; line 0: the value is a default. */
struct FConfigPlace
{
	int Line = 0;
	int Column = 0;
	std::string Pointer;
};

template<typename T>
struct TConfigValue
{
	T Value{};
	FConfigPlace Place;

	bool IsSet() const { return Place.Line > 0; }
};

using FConfigVector = std::array<double, 3>;

/** Settings of a volume or camera: values with their override bits, and where each one is named. */
struct FConfigSettings
{
	FPostProcessSettings Settings;
	std::map<std::string, FConfigPlace> Places; // of every setting named, inert ones too
};

/** Texels around the picture. */
struct FConfigPadding
{
	int Left = 0;
	int Top = 0;
	int Right = 0;
	int Bottom = 0;
};

struct FConfigScene
{
	TConfigValue<std::string> File;   // as written; see FConfig::Resolve
	std::string Sequence;             // where File was a sequence of frames: as written (see ChooseSceneFrame)
	std::optional<int> Frame;         // of the sequence
	TConfigValue<std::string> Frames; // of the sequence, that a run renders: see FFrameList
	TConfigValue<double> Fps;         // frames per second of the sequence; the scene file's by default
	std::map<std::string, TConfigValue<std::string>> Channels;
	std::map<std::string, TConfigValue<double>> Defaults;
	std::map<std::string, TConfigValue<std::string>> Textures; // "X, Y": channels of the file, by the texture's name
	std::optional<FConfigVector> CameraLocation;               // cm, of the file's header: see CompleteFromScene
	FConfigPadding Padding;
	double ScreenPercentage = 100.0; // rendered size in percent of the output's
	FSceneUnits Units;
};

struct FConfigView
{
	TConfigValue<FConfigVector> Location;  // cm
	TConfigValue<FConfigVector> Rotation;  // pitch, yaw, roll in degrees
	TConfigValue<double> Fov;              // horizontal, of the whole picture, degrees
	TConfigValue<std::array<int, 4>> Rect; // MinX, MinY, MaxX, MaxY
	TConfigValue<double> Exposure{1.0, {}};
	bool bAutoExposure = false; // in place of it
	TConfigValue<double> PreExposure{1.0, {}};
	bool bAutoPreExposure = false; // in place of it: it follows the exposure
};

enum class EConfigShape
{
	Box,
	Sphere,
	Capsule,
	Convex,
};

/** Lengths in cm, rotation pitch, yaw, roll in degrees. */
struct FConfigBounds
{
	EConfigShape Shape = EConfigShape::Box;
	FConfigVector Center = {};
	FConfigVector Extent = {}; // box: half sizes
	FConfigVector Rotation = {};
	double Radius = 0.0;
	double HalfHeight = 0.0;
	std::vector<FConfigVector> Points;
};

struct FConfigVolume
{
	std::string Name;
	bool bEnabled = true;
	bool bUnbound = false;
	std::optional<FConfigBounds> Bounds;
	double Priority = 0.0;
	double BlendRadius = 100.0;
	double BlendWeight = 1.0;
	FConfigSettings Settings;
	std::vector<FUnknownSetting> UnknownSettings; // kept for engine text, without effect here
	FConfigPlace Place;
};

struct FConfigCamera
{
	double PostProcessBlendWeight = 1.0;
	FConfigSettings Settings;
};

/** The source that sets a console variable; a later source beats an earlier one. */
enum class EVariableSource
{
	Config,
	CommandLine, // --set
	Console,     // --exec
};

/** A set; from the console also a command with its arguments, or a variable to print (Value empty or "?"). */
struct FConfigVariable
{
	std::string Name;
	std::string Value;
	FConfigPlace Place;
	EVariableSource Source = EVariableSource::Config;
};

struct FConfigShowFlag
{
	std::string Name;
	bool bValue = true;
	FConfigPlace Place;
};

/** An engine overlay: a folder, as written, and the folders, as written, that it stands over. */
struct FConfigOverlay
{
	TConfigValue<std::string> Folder;
	std::vector<std::string> Over;
};

struct FConfig
{
	DRYDOCK_DECLARE_COPIES(FConfig)

	std::string File; // as given on the command line
	TConfigValue<std::string> Engine{GetDefaultEngineProfile().GetVersion(), {}};
	std::vector<TConfigValue<std::string>> Plugins; // as written; see Resolve
	std::vector<FConfigOverlay> Overlays;
	FJsonValue Objects; // as it stands, null where there is none: see FObjectValues
	FJsonValue Assets;  // as it stands, null where there is none: see BeginAssets
	FConfigScene Scene;
	FConfigView View;                               // the first of Views where these are given
	std::vector<FConfigView> Views;                 // empty: View alone
	std::vector<FConfigVolume> Volumes;             // in the order of the file
	TConfigValue<bool> VolumesFromScene{false, {}}; // "volumes" is "fromScene": see CompleteFromScene
	FConfigCamera Camera;
	FConfigSettings CommandLine;            // --pp: after everything else, at full weight
	std::vector<FConfigVariable> Variables; // in the order in which they are set
	std::vector<FConfigShowFlag> ShowFlags;
	std::vector<FJsonValue> Extensions; // objects, as they stand: see ReadExtensionRequests
	std::vector<FJsonValue> Passes;     // see ReadPassRequests
	FJsonValue Study;                   // as it stands, null where there is none: see ReadStudy
	FJsonValue Budget;                  // as it stands
	std::vector<TConfigValue<std::string>> Dump;
	TConfigValue<std::string> Report;  // "off", "on", "full"; not set: as the program chooses
	std::optional<FOutputKinds> Write; // what of its outputs a run writes; empty: the config does not say
	bool bNoSkip = false;              // of the command line: see FRunOptions

	/** The row of Engine; the default's while the config has a mistake there. */
	DRYDOCK_API const FEngineProfile& GetEngineProfile() const;

	/** A path of the config, relative to the config's own folder, as one relative to the working folder. */
	DRYDOCK_API std::string Resolve(const std::string& Path) const;
};

DRYDOCK_API bool HasErrors(const std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
