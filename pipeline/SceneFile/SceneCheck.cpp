// Opens headers and holds against them what the config says.
#include "SceneFile/SceneCheck.h"

#include "Config/ConfigReader.h"
#include "Config/FrameSequence.h"
#include "Picture/ImageFile.h"
#include "RangeTools.h"
#include "SceneFile/SceneErrors.h"
#include "SceneFile/SceneTexturePacking.h"

namespace Drydock
{

namespace
{

void CheckRect(const FConfigView& View, const FImageFile& File, FConfigMessages& Messages)
{
	const std::array<int, 4>& Corners = View.Rect.Value;
	if (View.Rect.IsSet() && (Corners[2] > File.GetWidth() || Corners[3] > File.GetHeight()))
	{
		Messages.Error(ErrorBadValue, View.Rect.Place,
			"the rect leaves the scene, which is " + std::to_string(File.GetWidth()) + " x " +
				std::to_string(File.GetHeight()) + " pixels");
	}
}

/** A file of several layers, as Movie Render Queue and Blender write them, of which drydock would read no layer but the
 * picture. */
void CheckLayers(const FConfig& Config, const FImageFile& File, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<std::string> Unknown;
	bool bKnown = !Config.Scene.Channels.empty() || !Config.Scene.Textures.empty();
	for (const FImagePart& Part : File.GetParts())
	{
		for (const std::string& Channel : Part.Channels)
		{
			const bool bLayer = Channel.find('.') != std::string::npos || &Part != File.GetParts().data();
			bKnown = bKnown || (bLayer && Contains(GetSceneChannelNames(), Channel));
			if (bLayer)
			{
				Unknown.push_back(Channel);
			}
		}
	}
	if (!bKnown && !Unknown.empty())
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnRawRender,
			.Message = "the scene has layers that no pass knows by these names, such as \"" + Unknown.front() +
					   "\": the run has no depth and no G-buffer. drydock import " + File.GetPath() +
					   " makes a scene and a config of the file",
			.File = File.GetPath()});
	}
}

void CheckFile(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const FImageFile File(Config.Resolve(Config.Scene.File.Value), EImageExtent::Display);
	if (const std::string Extent = File.DescribeExtent(); !Extent.empty())
	{
		Diagnostics.push_back(
			{.Severity = ESeverity::Note, .Code = NoteDisplayWindow, .Message = Extent, .File = File.GetPath()});
	}
	CheckSceneChannels(Config, &File, Diagnostics);
	CheckLayers(Config, File, Diagnostics);
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const FConfigView& View : Config.Views)
	{
		CheckRect(View, File, Messages);
	}
	if (Config.Views.empty())
	{
		CheckRect(Config.View, File, Messages);
	}
}

} // namespace

FDiagnostic DescribeMissingScene(const FConfig& Config)
{
	return {.Code = ErrorMissingKey,
		.Message = "the config names no scene: \"scene\": {\"file\": \"...\"}",
		.File = Config.File,
		.Where = "/scene/file"};
}

void CheckSceneChannels(const FConfig& Config, const FImageFile* File, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	const auto CheckKnown = [&](const std::string& Name, const FConfigPlace& Place)
	{
		const std::vector<std::string>& Known = GetSceneChannelNames();
		if (!Contains(Known, Name))
		{
			Messages.Error(
				ErrorUnknownValue, Place, "no pass knows a channel \"" + Name + "\"" + Messages.Suggest(Name, Known));
		}
	};
	for (const auto& [Name, Channel] : Config.Scene.Channels)
	{
		CheckKnown(Name, Channel.Place);
		if (File != nullptr && File->FindChannel(Channel.Value) < 0)
		{
			Messages.Error(ErrorUnknownValue, Channel.Place,
				File->GetPath() + " has no channel \"" + Channel.Value + "\"" +
					Messages.Suggest(Channel.Value, File->GetChannels()));
		}
	}
	for (const auto& [Name, Names] : Config.Scene.Textures)
	{
		constexpr size_t MostChannels = 4;
		const std::vector<std::string> Channels = SplitChannelNames(Names.Value);
		if (FindScenePacking(Name) != nullptr)
		{
			Messages.Error(ErrorBadValue, Names.Place, "drydock has a scene texture " + Name + "; choose another name");
		}
		if (Channels.empty() || Channels.size() > MostChannels)
		{
			Messages.Error(ErrorBadValue, Names.Place,
				"a texture must have 1 to 4 channels, but " + Name + " has " + std::to_string(Channels.size()));
		}
		for (const std::string& Channel : Channels)
		{
			if (File != nullptr && File->FindChannel(Channel) < 0)
			{
				Messages.Error(ErrorUnknownValue, Names.Place,
					File->GetPath() + " has no channel \"" + Channel + "\"" +
						Messages.Suggest(Channel, File->GetChannels()));
			}
		}
	}
	for (const auto& [Name, Default] : Config.Scene.Defaults)
	{
		CheckKnown(Name, Default.Place);
	}
}

void CheckScene(const FConfig& Config, ESceneNeed Need, std::vector<FDiagnostic>& Diagnostics)
{
	if (Need == ESceneNeed::None)
	{
		return;
	}
	if (!Config.Scene.File.IsSet() || IsFrameSequence(Config.Scene.File.Value))
	{
		CheckSceneChannels(Config, nullptr, Diagnostics);
		if (!Config.Scene.File.IsSet() && Need == ESceneNeed::Required)
		{
			Diagnostics.push_back(DescribeMissingScene(Config));
		}
		return;
	}
	try
	{
		CheckFile(Config, Diagnostics);
	}
	catch (const FError& Error)
	{
		CheckSceneChannels(Config, nullptr, Diagnostics);
		Diagnostics.insert(Diagnostics.end(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
	}
}

} // namespace Drydock
