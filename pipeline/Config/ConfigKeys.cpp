// Lists the keys of a config; configs/README.md describes them.
#include "Config/ConfigKeys.h"

#include "EngineProfile.h"

#include <algorithm>

namespace Drydock
{

const std::vector<FConfigKey>& GetConfigKeys()
{
	using enum EConfigKind;
	constexpr bool Required = true;
	constexpr bool Optional = false;
	static const std::string Engines = ListEngineVersions("|");
	// clang-format off
	static const std::vector<FConfigKey> Keys = {
		{"", "$schema", String, "", 0, Optional, "Path of this schema: gives completion in editors."},
		{"", "engine", String, Engines.c_str(), 0, Optional, "Engine version whose behaviour holds; 5.4 by default."},
		{"", "plugins", StringArray, "", 0, Optional, "Shared objects to load, relative to the config."},
		{"", "overlay", Anything, "", 0, Optional, "Engine overlay: a folder, relative to the config; a list of folders; or {\"folder\": \"B\", \"over\": \"A\"} in a list."},
		{"", "objects", Object, "objects", 0, Optional, "Values for fields (UPROPERTY) of the plugins' classes, by class."},
		{"", "scene", Object, "scene", 0, Optional, "The rendered input frame; required by every verb that builds a frame."},
		{"", "view", Object, "view", 0, Optional, "The camera; without it the scene file's own."},
		{"", "views", ObjectArray, "view", 0, Optional, "Several cameras in one frame, each with its rect; in place of view."},
		{"", "volumes", ObjectArray, "volume=fromScene", 0, Optional, "Post-process volumes, or \"fromScene\": those that the scene file suggests."},
		{"", "camera", Object, "camera", 0, Optional, "The camera's own settings, blended after all volumes."},
		{"", "cvars", Variables, "", 0, Optional, "Console variables by name."},
		{"", "showFlags", ShowFlags, "", 0, Optional, "Show flags by name."},
		{"", "extensions", ObjectArray, "extension", 0, Optional, "View extensions, in order of registration."},
		{"", "passes", ObjectArray, "pass", 0, Optional, "Passes inserted into the chain."},
		{"", "outputs", Object, "outputs", 0, Optional, "Files that a run writes beside the final picture."},
		{"", "budget", Object, "budget", 0, Optional, "The error or time that an approximation may cost."},
		{"", "study", Object, "study", 0, Optional, "A study of accuracy against time."},

		{"objects", "*", Object, "object", 0, Optional, "Fields of a class by name; the class with or without its U."},
		{"object", "*", Anything, "", 0, Optional, "A number, text, true or false, an array, or an object of a struct's fields."},

		{"scene", "file", String, "", 0, Required, "Multi-layer EXR, or an RGB image, relative to the config; with #### in its name a sequence of frames. Formats: .exr, .hdr, .png, .jpg, .jpeg, .tga, .bmp, .tif, .tiff, .dpx."},
		{"scene", "frames", String, "", 0, Optional, "Frames that a run of a sequence renders: \"all\", \"1-8\", \"1-9x2\", \"1,3,5-8\"; the lowest alone by default."},
		{"scene", "fps", Number, "", 0, Optional, "Frames of a sequence in a second; the scene file's by default, else 24."},
		{"scene", "channels", StringMap, "", 0, Optional, "Channel names of this file: {\"depth.Z\": \"Depth.V\"} reads depth.Z from Depth.V."},
		{"scene", "textures", StringMap, "", 0, Optional, "Textures of the file's own channels, up to four each: {\"Wetness\": \"wet.R, wet.G\"}."},
		{"scene", "defaults", NumberMap, "", 0, Optional, "Values for channels that the file lacks: {\"A\": 1}."},
		{"scene", "padding", Padding, "padding", 0, Optional, "Texels around the picture that hold no picture: a number for all sides, or one for each."},
		{"scene", "units", Object, "units", 0, Optional, "Units of the file, where they are not those of configs/scenes/README.md."},
		{"scene", "screenPercentage", Number, "", 0, Optional, "Rendered size in percent of the output's, up to 400; 100 by default."},

		{"padding", "left", Number, "", 0, Optional, "0 by default."},
		{"padding", "top", Number, "", 0, Optional, "0 by default."},
		{"padding", "right", Number, "", 0, Optional, "0 by default."},
		{"padding", "bottom", Number, "", 0, Optional, "0 by default."},

		{"units", "depth", String, "m|cm", 0, Optional, "Unit of depth.Z; m by default."},
		{"units", "velocity", String, "pixels|ndc", 0, Optional, "Unit of velocity.X and Y; pixels (y down) by default; ndc is the engine's screen position, -2 to 2, y up."},
		{"units", "normal", String, "rightHanded|leftHanded", 0, Optional, "Axes of normal.X, Y, Z; rightHanded by default."},

		{"view", "location", Vector3, "", 0, Optional, "Camera position, cm, left-handed, Z up."},
		{"view", "rotation", Rotator, "", 0, Optional, "Pitch, yaw, roll in degrees; the scene file's by default."},
		{"view", "fov", Number, "", 0, Optional, "Horizontal field of view of the whole picture, 1 to 179 degrees; the scene file's by default."},
		{"view", "rect", NumberArray, "", 4, Optional, "MinX, MinY, MaxX, MaxY in pixels of the scene; all of it by default."},
		{"view", "exposure", Number, "=auto", 0, Optional, "Exposure scale at default AutoExposureBias; 1 by default. \"auto\": eye adaptation."},
		{"view", "preExposure", Number, "=auto", 0, Optional, "Scene colour is stored multiplied by this; 1 by default. \"auto\": the exposure of the frame before."},

		{"volume", "name", String, "", 0, Optional, "For messages and reports."},
		{"volume", "bEnabled", Bool, "", 0, Optional, "true by default."},
		{"volume", "bUnbound", Bool, "", 0, Optional, "Applies everywhere; false by default."},
		{"volume", "bounds", Object, "bounds", 0, Optional, "Shape and place of a bounded volume."},
		{"volume", "Priority", Number, "", 0, Optional, "Higher is applied later and wins; 0 by default."},
		{"volume", "BlendRadius", Number, "", 0, Optional, "Distance around the bounds over which the weight falls to 0, cm; 100 by default."},
		{"volume", "BlendWeight", Number, "", 0, Optional, "0 to 1; 1 by default."},
		{"volume", "Settings", Settings, "", 0, Optional, "Naming a setting sets its override bit."},

		{"volume", "unknownSettings", ObjectArray, "unknownSetting", 0, Optional, "Fields of imported engine text that drydock does not have: no effect, written again by drydock settings export."},
		{"unknownSetting", "name", String, "", 0, Required, "As in the engine text, with its index if it has one."},
		{"unknownSetting", "text", String, "", 0, Required, "The value as it was written."},
		{"unknownSetting", "after", String, "", 0, Optional, "The known field that it follows."},

		{"bounds", "type", String, "box|sphere|capsule|convex", 0, Optional, "box by default."},
		{"bounds", "min", Vector3, "", 0, Optional, "Box: least corner, cm."},
		{"bounds", "max", Vector3, "", 0, Optional, "Box: greatest corner, cm."},
		{"bounds", "center", Vector3, "", 0, Optional, "Box, sphere, capsule: centre, cm."},
		{"bounds", "extent", Vector3, "", 0, Optional, "Box: half sizes, cm."},
		{"bounds", "rotation", Rotator, "", 0, Optional, "Box, capsule: pitch, yaw, roll in degrees."},
		{"bounds", "radius", Number, "", 0, Optional, "Sphere, capsule: radius, cm."},
		{"bounds", "halfHeight", Number, "", 0, Optional, "Capsule: half height, caps included, cm."},
		{"bounds", "points", Vector3Array, "", 0, Optional, "Convex: points whose hull it is, cm."},

		{"camera", "PostProcessBlendWeight", Number, "", 0, Optional, "0 to 1; 1 by default."},
		{"camera", "Settings", Settings, "", 0, Optional, "Naming a setting sets its override bit."},

		{"extension", "type", String, "", 0, Required, "Name of the extension."},
		{"extension", "pass", String, "", 0, Optional, "Hook it is given to: after which pass; the type's own by default (drydock list extensions)."},
		{"extension", "*", Anything, "", 0, Optional, "The type's own parameters (drydock list extensions)."},

		{"pass", "type", String, "", 0, Required, "Name of the pass."},
		{"pass", "at", String, "", 0, Required, "Hook at which it is inserted."},
		{"pass", "name", String, "", 0, Optional, "Under which later passes find its result; the type by default."},
		{"pass", "replace", Bool, "", 0, Optional, "The result is the picture from then on; true by default."},
		{"pass", "inputs", StringMap, "", 0, Optional, "Resource for each input: SceneColor, a scene texture, or the name of an earlier pass."},
		{"pass", "parameters", Object, "parameters", 0, Optional, "Values for its parameters."},
		{"parameters", "*", Anything, "", 0, Optional, "A number, an array of numbers, a text or true or false."},

		{"outputs", "write", StringArray, "png|exr|json|dot", 0, Optional, "Kinds of files that a run writes beside run.json: png, exr, json (timing.json, trace.json), dot (the graph); all by default."},
		{"outputs", "report", String, "off|on|full", 0, Optional, "The page report.html: off, on, or full, with the values of all its pictures; on where a person runs a frame at a terminal (docs/report.md)."},
		{"outputs", "dump", StringArray, "", 0, Optional, "Patterns with * and ?: a pass, a resource, or Pass.Resource."},

		{"budget", "metric", String, "", 0, Optional, "Error metric that max refers to: max, rms, relative, psnr or ssim; rms by default."},
		{"budget", "max", Number, "", 0, Optional, "Largest error allowed; of psnr and ssim the least that is wanted."},
		{"budget", "ms", Number, "", 0, Optional, "Longest time allowed, in milliseconds."},
		{"budget", "study", String, "", 0, Optional, "Folder of the study whose choice run takes, relative to the config; by default where drydock study writes."},

		{"study", "axes", ObjectArray, "axis", 0, Required, "The axes of the study: each varies one thing."},
		{"study", "reference", Anything, "", 0, Optional, "Reference for errors: exact (of blurs), double (of frames), or an object of settings for the reference frame."},
		{"study", "metrics", StringArray, "", 0, Optional, "Error metrics: rms, max, relative, psnr, ssim; the first one is drawn and ranks."},
		{"study", "repetitions", Number, "", 0, Optional, "Timed runs per variant; 7 by default."},
		{"study", "region", NumberArray, "", 4, Optional, "MinX, MinY, MaxX, MaxY: the part of the picture where errors are measured; the whole picture is computed."},
		{"study", "measure", String, "", 0, Optional, "Measured picture of frames: final (default), sceneLinear, toonShadow (the blurred one, as it would be displayed), or a resource by name or Pass.Resource."},
		{"study", "passes", String, "", 0, Optional, "Passes of frames whose time, taps and bytes count, by name, with * and ?; all by default."},
		{"study", "current", Anything, "", 0, Optional, "Variant of a study of blurs that is in use now, {axis: value}; for frames it is the config's own."},
		{"axis", "name", String, "", 0, Required, "A setting, a console variable, precision or storage; of blurs algorithm, sigma, input, storage, precision or resolution."},
		{"axis", "values", Anything, "", 0, Required, "The values it takes; {label, set: {name: value}} sets several things at once."},
		{"axis", "each", Bool, "", 0, Optional, "Another job for each value, with its own reference and front; true by default for sigma and input only."},
	};
	// clang-format on
	return Keys;
}

const FConfigKey* FindConfigKey(const std::string& Object, const std::string& Name)
{
	const std::vector<FConfigKey>& Keys = GetConfigKeys();
	const auto Find = [&](const std::string& Wanted)
	{
		const auto Found = std::find_if(Keys.begin(), Keys.end(),
			[&](const FConfigKey& Key) { return Object == Key.Object && Wanted == Key.Name; });
		return Found == Keys.end() ? nullptr : &*Found;
	};
	const FConfigKey* Exact = Find(Name);
	return Exact != nullptr ? Exact : Find("*");
}

std::vector<std::string> SplitAlternatives(const std::string& Text)
{
	std::vector<std::string> Parts;
	for (size_t Begin = 0; Begin < Text.size();)
	{
		const size_t Bar = std::min(Text.find('|', Begin), Text.size());
		Parts.push_back(Text.substr(Begin, Bar - Begin));
		Begin = Bar + 1;
	}
	return Parts;
}

} // namespace Drydock
