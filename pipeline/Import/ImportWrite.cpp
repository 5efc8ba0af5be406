// Writes scene and config.
#include "Import/ImportWrite.h"

#include "Import/ImportErrors.h"
#include "Picture/ExrWriter.h"
#include "Text/AsideFile.h"
#include "Text/JsonWriter.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** By which a scene of import's is known again. */
constexpr const char* ImportMark = "drydock:imported";

bool IsImportedScene(const std::string& Path)
{
	try
	{
		return !FImageFile(Path).GetAttribute(ImportMark).empty();
	}
	catch (const FError&)
	{
		return false;
	}
}

/** Text that may stand in a comment of one line. */
std::string ForComment(std::string Text)
{
	std::replace_if(
		Text.begin(), Text.end(), [](unsigned char Character) { return Character < 0x20 || Character == 0x7F; }, '?');
	return Text;
}

/** Values that stand for "nothing of that kind" over the whole frame. */
const std::vector<std::pair<const char*, const char*>>& GetHarmlessDefaults()
{
	static const std::vector<std::pair<const char*, const char*>> Defaults = {
		{"velocity.X", "0"}, {"velocity.Y", "0"}, {"shadingmodel.ID", "1"}, {"custommask.B", "0"}};
	return Defaults;
}

} // namespace

void CheckImportTarget(const std::string& Path, const std::vector<std::string>& Inputs, bool bForce)
{
	std::error_code Ignored;
	const auto IsSame = [&](const std::string& Input)
	{
		return Files::equivalent(Input, Path, Ignored);
	};
	if (std::any_of(Inputs.begin(), Inputs.end(), IsSame))
	{
		throw FError(
			{.Code = ErrorImportInTheWay,
				.Message = "the scene would overwrite the frame that it is made from; pass another file to --out",
				.File = Path},
			ExitFiles);
	}
	if (!bForce && Files::exists(Path, Ignored) && !IsImportedScene(Path))
	{
		throw FError({.Code = ErrorImportInTheWay,
						 .Message = "already exists, and drydock import did not write it; --force replaces it",
						 .File = Path},
			ExitFiles);
	}
}

void WriteImportedScene(const std::string& Path, const FImportScene& Scene, bool bForce)
{
	CheckImportTarget(Path, {}, bForce);
	std::vector<std::vector<float>> Planes;
	std::vector<std::string> Names;
	for (const FImportChannelPlane& Channel : Scene.Channels)
	{
		Planes.push_back(Channel.Values);
		Names.push_back(Channel.Name);
	}
	std::map<std::string, std::string> Attributes = {{ImportMark, GetVersion()}};
	if (!Scene.CameraJson.empty())
	{
		Attributes["drydock:camera_json"] = Scene.CameraJson;
	}
	FAsideFile Aside(Path);
	WriteExrPlanes(Aside.GetPath().string(), Scene.Width, Scene.Height, Planes, Names, Attributes);
	Aside.PutInPlace();
}

std::vector<std::string> FindMissingChannels(const FImportScene& Scene)
{
	std::vector<std::string> Missing;
	for (const char* const Name :
		{"depth.Z", "normal.X", "velocity.X", "basecolor.R", "shadingmodel.ID", "custommask.B"})
	{
		if (Scene.Find(Name) == nullptr)
		{
			Missing.emplace_back(Name);
		}
	}
	return Missing;
}

std::string MakeImportConfig(
	const std::string& SceneFile, const FImportScene& Scene, const std::vector<std::string>& Inputs)
{
	std::string Defaults;
	for (const auto& [Name, Value] : GetHarmlessDefaults())
	{
		if (Scene.Find(Name) == nullptr)
		{
			Defaults += (Defaults.empty() ? "" : ", ") + FJsonWriter::Quote(Name) + ": " + Value;
		}
	}
	std::string From =
		JoinText(Inputs, ", ", [&](const std::string& Input) { return Files::path(Input).filename().string(); });
	std::string Text = "// Toon bloom on a frame of your own: " + ForComment(From) + ". drydock run " +
					   ForComment(Files::path(GetImportConfigPath(SceneFile)).filename().string()) + "\n{\n";
	Text += "  \"$schema\": \"" + std::string(ImportSchemaName) + "\",\n\n";
	Text += "  \"scene\": {\n    \"file\": " + FJsonWriter::Quote(Files::path(SceneFile).filename().string());
	if (!Defaults.empty())
	{
		Text += ",\n\n    // No layer was given for these: nothing moves, all is default lit, nothing is marked.\n"
				"    \"defaults\": { " +
				Defaults + " }";
	}
	Text += "\n  },\n\n";
	Text += "  \"volumes\": [\n    {\n      \"name\": \"Base\",\n      \"bUnbound\": true,\n      \"Settings\": {\n"
			"        \"BloomIntensity\": 1.5,\n        \"BloomThreshold\": -1,\n"
			"        \"BloomToonIntensity\": 0.1    // pixels of shading model 8 bloom at a tenth\n"
			"      }\n    }\n  ]\n}\n";
	return Text;
}

std::string GetImportConfigPath(const std::string& SceneFile)
{
	std::string Name = Files::path(SceneFile).stem().string();
	Name.erase(std::remove(Name.begin(), Name.end(), '#'), Name.end());
	while (!Name.empty() && (Name.back() == '.' || Name.back() == '_' || Name.back() == '-'))
	{
		Name.pop_back();
	}
	return (Files::path(SceneFile).parent_path() / ((Name.empty() ? "scene" : Name) + ".json")).string();
}

} // namespace Drydock
