// Lists an overlay's files by their places in the engine's tree, and finds in them what stands in for drydock's.
#include "Overlay/OverlayFolder.h"

#include "Overlay/CppText.h"
#include "Overlay/OverlayErrors.h"
#include "Patch/PluginErrors.h"
#include "TextTools.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string ShaderRoot = "Engine/Shaders/";
const std::string RendererRoot = "Engine/Source/Runtime/Renderer/";
const std::string ChainFile = RendererRoot + "Private/PostProcess/PostProcessing.cpp";
const std::string SettingsHeader = "Engine/Source/Runtime/Engine/Classes/Engine/Scene.h";
const std::string SettingsSource = "Engine/Source/Runtime/Engine/Private/Scene.cpp";
const std::string SettingsView = "Engine/Source/Runtime/Engine/Private/SceneView.cpp";
constexpr size_t MaxFiles = 5000; // somebody may name a whole engine

/** Files of the folder, from it on, sorted. Nothing where there are more than MaxFiles. */
std::optional<std::vector<std::string>> ListFiles(const std::string& Folder)
{
	std::vector<std::string> Found;
	std::error_code Error;
	Files::recursive_directory_iterator At(Folder, Files::directory_options::skip_permission_denied, Error);
	for (const Files::recursive_directory_iterator End; !Error && At != End; At.increment(Error))
	{
		if (At->is_directory(Error) || At->path().filename().string().starts_with('.'))
		{
			continue;
		}
		Found.push_back(At->path().lexically_relative(Folder).generic_string());
		if (Found.size() > MaxFiles)
		{
			return std::nullopt;
		}
	}
	std::sort(Found.begin(), Found.end());
	return Found;
}

bool HasExtension(const std::string& File, std::initializer_list<std::string_view> Extensions)
{
	return std::any_of(
		Extensions.begin(), Extensions.end(), [&](std::string_view Extension) { return File.ends_with(Extension); });
}

/** Reads one overlay's folder. */
class FOverlayReader
{
public:
	FOverlayReader(const std::string& Path, std::vector<FDiagnostic>& InDiagnostics)
		: Diagnostics(InDiagnostics)
	{
		Folder.Path = (Files::absolute(Path) / ".").lexically_normal().parent_path().string();
		Folder.Name = Files::path(Folder.Path).filename().string();
	}

	FOverlayFolder Run()
	{
		std::error_code Error;
		if (!Files::is_directory(Folder.Path, Error))
		{
			Fail(ErrorOverlayFolder, Folder.Path, 0,
				"is not a folder; expected an overlay, with the folder Engine in it");
			return std::move(Folder);
		}
		const std::optional<std::vector<std::string>> Listed = ListFiles(Folder.Path + "/Engine");
		if (!Listed || Listed->empty())
		{
			Fail(ErrorOverlayFolder, Folder.Path, 0,
				Listed ? "has no file in a folder Engine; expected Engine/Shaders/Private/X.usf or Engine/Source/..."
					   : "has more than " + std::to_string(MaxFiles) +
							 " files below Engine; an overlay holds the edited files alone");
			return std::move(Folder);
		}
		for (const std::string& File : *Listed)
		{
			Take("Engine/" + File);
		}
		TakePasses();
		TakePlaces();
		TakeSettings();
		if (Folder.Shaders.empty() && !Folder.HasCode() && !HasErrors())
		{
			Fail(ErrorOverlayFolder, Folder.Path, 0,
				"replaces nothing: it has no shader, no pass function and no setting that drydock knows");
		}
		return std::move(Folder);
	}

private:
	bool HasErrors() const { return NumErrors > 0; }

	void Fail(EOverlayError Code, const std::string& File, int Line, const std::string& Message)
	{
		++NumErrors;
		Diagnostics.push_back({.Code = Code, .Message = Message, .File = File, .Line = Line});
	}

	std::string Absolute(const std::string& File) const { return Folder.Path + "/" + File; }

	const std::string& Read(const std::string& File)
	{
		const auto [Found, bNew] = Texts.try_emplace(File);
		if (bNew && Files::exists(Absolute(File)))
		{
			const FFileBytes Bytes = ReadRegularFile(Absolute(File));
			if (!Bytes.Bytes)
			{
				Fail(ErrorOverlayFolder, Absolute(File), 0, "cannot be read: " + Bytes.Problem);
			}
			Found->second = Bytes.Bytes.value_or("");
			Folder.Read.push_back(Absolute(File));
			const std::string Code = BlankComments(Found->second);
			if (const std::string Advice = AdviseOnCompositionGraph(Code); !Advice.empty())
			{
				Fail(ErrorOverlayFolder, Absolute(File), GetLineOf(Code, Code.find(Advice.substr(0, Advice.find(' ')))),
					Advice);
			}
		}
		return Found->second;
	}

	void Take(const std::string& File)
	{
		std::error_code Error;
		if (!Files::exists(Absolute(File), Error))
		{
			Fail(ErrorOverlayFolder, Absolute(File), 0, "is a link to a file that does not exist");
		}
		else if (File.starts_with(ShaderRoot) && HasExtension(File, {".usf", ".ush"}))
		{
			Folder.Shaders.push_back("/Engine/" + File.substr(ShaderRoot.size()));
		}
		else if (File == ChainFile || File == SettingsHeader || File == SettingsSource || File == SettingsView)
		{
			Read(File);
		}
		else if (File.starts_with(RendererRoot) && HasExtension(File, {".h", ".inl"}))
		{
			Read(File);
		}
		else if (File.starts_with(RendererRoot + "Private/") && HasExtension(File, {".cpp"}))
		{
			Read(File);
			Folder.Sources.push_back(Absolute(File));
		}
		else
		{
			const bool bCode = HasExtension(File, {".cpp", ".h", ".inl"});
			Folder.Unused.push_back(File + (bCode ? " (C++ is read below " + RendererRoot + "Private)" : ""));
		}
	}

	void TakePasses()
	{
		for (const FPassFunction& Pass : GetPassFunctions())
		{
			for (const std::string& Source : Folder.Sources)
			{
				const std::string Text = BlankComments(Read(Source.substr(Folder.Path.size() + 1)));
				if (const std::optional<size_t> At = FindDefinition(Text, Pass.Name))
				{
					Folder.Passes.push_back({&Pass, Source, GetLineOf(Text, *At)});
					break;
				}
			}
		}
		for (const char* const Include : {"Private", "Private/PostProcess", "Public", "Internal"})
		{
			if (Files::is_directory(Absolute(RendererRoot + Include)))
			{
				Folder.IncludeFolders.push_back(Absolute(RendererRoot + Include));
			}
		}
	}

	/** The blocks `if (CONDITION) { ... }` of PostProcessing.cpp that call what belongs to a place. */
	void TakePlaces()
	{
		const std::string& Text = Read(ChainFile);
		if (Text.empty())
		{
			return;
		}
		const std::string Blanked = BlankComments(Text);
		std::string Expected;
		for (const FChainPlaceOfOverlay& Place : ChainPlacesOfOverlays)
		{
			Expected += (Expected.empty() ? "if (" : ", if (") + std::string(Place.Condition) + ")";
			size_t Count = 0;
			for (const size_t At : FindWord(Blanked, Place.Condition))
			{
				TakeBlock(Place, Text, Blanked, At, Count);
			}
			if (Count > 1)
			{
				Fail(ErrorOverlayPlace, Absolute(ChainFile), Folder.Places.back().Line,
					"has " + std::to_string(Count) + " blocks if (" + Place.Condition + "); expected one");
			}
		}
		if (Folder.Places.empty())
		{
			Fail(ErrorOverlayPlace, Absolute(ChainFile), 0,
				"has no block that a place of the chain takes; expected " + Expected +
					" { ... }, as the engine has it");
		}
	}

	void TakeBlock(const FChainPlaceOfOverlay& Place, const std::string& Text, const std::string& Blanked, size_t At,
		size_t& Count)
	{
		const size_t Open = Blanked.find_last_not_of(" \t\r\n", At - 1);
		const size_t If = Open == Blanked.npos || Blanked[Open] != '(' || Open == 0
							  ? Blanked.npos
							  : Blanked.find_last_not_of(" \t\r\n", Open - 1);
		if (If == Blanked.npos || If == 0 || Blanked.substr(If - 1, 2) != "if")
		{
			return;
		}
		const std::optional<size_t> Condition = FindClosing(Blanked, Open);
		const size_t Brace = Condition ? SkipBlanks(Blanked, *Condition) : Blanked.size();
		const std::optional<size_t> End =
			Brace < Blanked.size() && Blanked[Brace] == '{' ? FindClosing(Blanked, Brace) : std::nullopt;
		if (End && !FindWord(Blanked.substr(Brace, *End - Brace), Place.Call).empty())
		{
			++Count;
			Folder.Places.push_back(
				{&Place, Absolute(ChainFile), GetLineOf(Text, If - 1), Text.substr(If - 1, *End - If + 1), "", 0});
			TakeCondition(Text, Blanked.substr(0, If - 1));
		}
	}

	/** The last `bool CONDITION = ...;` before the block. */
	void TakeCondition(const std::string& Text, const std::string& Before)
	{
		FOverlayPlace& Place = Folder.Places.back();
		for (const size_t At : FindWord(Before, Place.Place->Condition))
		{
			const size_t Equals = SkipBlanks(Before, At + std::string_view(Place.Place->Condition).size());
			const size_t End = Before.find(';', Equals);
			const size_t Type = Before.find_last_not_of(" \t\r\n", At - 1);
			if (End != Before.npos && Before[Equals] == '=' && Type >= 3 && Type != Before.npos &&
				Before.compare(Type - 3, 4, "bool") == 0)
			{
				Place.Condition = "const " + Text.substr(Type - 3, End - Type + 4);
				Place.ConditionLine = GetLineOf(Text, Type);
			}
		}
	}

	void TakeSettings()
	{
		Folder.Defaults = ReadOverlayDefaults({Absolute(SettingsSource), Read(SettingsSource)});
		const FOverlayText Header = {Absolute(SettingsHeader), Read(SettingsHeader)};
		if (Header.Text.empty())
		{
			return;
		}
		const size_t Before = Diagnostics.size();
		FOverlaySettings Found = ReadOverlaySettings(Header, {Absolute(SettingsSource), Read(SettingsSource)},
			{Absolute(SettingsView), Read(SettingsView)}, Diagnostics);
		NumErrors += static_cast<size_t>(std::count_if(Diagnostics.begin() + static_cast<std::ptrdiff_t>(Before),
			Diagnostics.end(), [](const FDiagnostic& Each) { return Each.Severity == ESeverity::Error; }));
		Folder.Settings = std::move(Found.Settings);
		Folder.EnumTexts = std::move(Found.EnumTexts);
	}

	FOverlayFolder Folder;
	std::map<std::string, std::string> Texts; // by file, from the folder on
	std::vector<FDiagnostic>& Diagnostics;
	size_t NumErrors = 0;
};

} // namespace

std::string FOverlayFolder::GetShaderFile(const std::string& Shader) const
{
	return Path + "/" + ShaderRoot + Shader.substr(std::string_view("/Engine/").size());
}

std::vector<std::string> FOverlayFolder::ListReplaced() const
{
	std::vector<std::string> Names = Shaders;
	for (const FOverlayPass& Pass : Passes)
	{
		Names.emplace_back(Pass.Function->Name);
	}
	for (const FOverlayPlace& Place : Places)
	{
		Names.emplace_back(Place.Place->Name);
	}
	for (const FOverlaySetting& Setting : Settings)
	{
		Names.push_back(Setting.Name);
	}
	for (const FOverlayDefault& Default : Defaults)
	{
		Names.push_back(Default.GetPlace());
	}
	return Names;
}

FOverlayFolder ReadOverlayFolder(const std::string& Path, std::vector<FDiagnostic>& Diagnostics)
{
	return FOverlayReader(Path, Diagnostics).Run();
}

} // namespace Drydock
