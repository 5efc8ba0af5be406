// Lists the files of a run, and tells shaders from all else.
#include "Run/RunFiles.h"

#include "Config/ReadConfig.h"
#include "Extensions/Plugins.h"
#include "Overlay/OverlayFolder.h"
#include "ShaderCompilation.h"

#include <algorithm>
#include <optional>

namespace Drydock
{

namespace
{

/** A library, and the ini files of the plugin, which are known once it is loaded. */
void AddPlugin(const std::string& Path, FWatchedFiles& Files)
{
	Files.AddFile(Path);
	for (const std::string& IniFile : FindPluginIniFiles(Path))
	{
		Files.AddFile(IniFile);
	}
}

/** The files of an overlay that are read. */
void AddOverlay(const std::string& Path, FWatchedFiles& Files)
{
	std::vector<FDiagnostic> Ignored;
	const FOverlayFolder Overlay = ReadOverlayFolder(Path, Ignored);
	for (const std::string& File : Overlay.Read)
	{
		Files.AddFile(File);
	}
	for (const std::string& Shader : Overlay.Shaders)
	{
		Files.AddFile(Overlay.GetShaderFile(Shader));
	}
}

} // namespace

FWatchedFiles FindRunFiles(const FRunOptions& Options)
{
	FWatchedFiles Files;
	Files.AddFile(Options.ConfigFile);
	Files.AddShaders();
	try
	{
		std::vector<FDiagnostic> Ignored;
		const FConfig Config = Options.ConfigText ? ReadConfig(*Options.ConfigText, Options.ConfigFile, Ignored)
												  : LoadConfig(Options.ConfigFile, Ignored);
		if (Config.Scene.File.IsSet())
		{
			Files.AddFile(Config.Resolve(Config.Scene.File.Value));
		}
		for (const TConfigValue<std::string>& Plugin : Config.Plugins)
		{
			AddPlugin(Config.Resolve(Plugin.Value), Files);
		}
		for (const std::string& Plugin : Options.Plugins)
		{
			AddPlugin(Plugin, Files);
		}
		for (const FConfigOverlay& Overlay : Config.Overlays)
		{
			AddOverlay(Config.Resolve(Overlay.Folder.Value), Files);
		}
		for (const std::string& Overlay : Options.Overlays)
		{
			AddOverlay(Overlay, Files);
		}
	}
	catch (const FError&)
	{
		// The config itself is watched: it may come back.
	}
	return Files;
}

void ForgetEdited(const FWatchedFiles& Before, const FWatchedFiles& After)
{
	const std::optional<std::vector<std::string>> Edited = After.FindEdited(Before);
	const auto IsShader = [](const std::string& Path)
	{
		return Path.ends_with(".usf") || Path.ends_with(".ush") || Path.ends_with(".spv");
	};
	if (Edited && std::all_of(Edited->begin(), Edited->end(), IsShader))
	{
		ForgetShadersOf(*Edited);
	}
	else
	{
		ForgetShaders();
	}
}

} // namespace Drydock
