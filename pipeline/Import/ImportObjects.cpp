// Reads Cryptomatte's metadata and chooses objects.
#include "Import/ImportObjects.h"

#include "Config/ConfigReader.h"
#include "Import/ImportErrors.h"
#include "Text/GlobPattern.h"
#include "Text/Json.h"
#include "TextTools.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>

namespace Drydock
{

namespace
{

std::optional<uint32_t> ParseHex(const std::string& Text)
{
	uint32_t Number = 0;
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), Number, 16);
	const bool bGood = Result.ec == std::errc() && Result.ptr == Text.data() + Text.size() && !Text.empty();
	return bGood ? std::optional(Number) : std::nullopt;
}

std::optional<int> ParseStencil(const std::string& Text)
{
	const std::optional<int> Number = ParseAll<int>(Text);
	return Number >= 0 && Number <= 255 ? Number : std::nullopt;
}

/** Layer "NAME00", whose first component is an id. */
std::optional<FImportSource> FindFirstRank(const FImportLayers& Layers, size_t File, const std::string& Name)
{
	for (size_t Index = 0; Index < Layers.Layers.size(); ++Index)
	{
		const FImportLayer& Layer = Layers.Layers[Index];
		if (Layer.File == File && Layer.Name == Name + "00" && Layer.Find(0) != nullptr)
		{
			return FImportSource{Index, 0};
		}
	}
	return std::nullopt;
}

std::map<std::string, uint32_t> ReadManifest(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Text, File, Ignored, bSyntaxError);
	std::map<std::string, uint32_t> Objects;
	for (const FJsonMember& Member : Root.Members)
	{
		if (const std::optional<uint32_t> Id = ParseHex(Member.Value.String))
		{
			Objects[Member.Key] = *Id;
		}
	}
	if (bSyntaxError || Objects.empty())
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnImportImplausible,
			.Message = "the header has no list of object names: objects cannot be chosen by name",
			.File = File});
	}
	return Objects;
}

std::vector<std::string> GetNames(const std::vector<FImportMatte>& Mattes)
{
	std::vector<std::string> Names;
	for (const FImportMatte& Matte : Mattes)
	{
		for (const auto& [Name, Id] : Matte.Objects)
		{
			Names.push_back(Name);
		}
	}
	return Names;
}

FImportChoice ChooseByName(const std::string& Pattern, const std::vector<FImportMatte>& Mattes)
{
	FImportChoice Choice;
	Choice.Text = Pattern;
	for (const FImportMatte& Matte : Mattes)
	{
		std::set<uint32_t> Ids;
		for (const auto& [Name, Id] : Matte.Objects)
		{
			if (MatchesPattern(Pattern, Name))
			{
				Ids.insert(Id);
			}
		}
		if (!Ids.empty())
		{
			Choice.NumObjects += Ids.size();
			Choice.Objects.emplace_back(Matte.Ids, std::move(Ids));
		}
	}
	return Choice;
}

FDiagnostic MakeNoObject(const char* Option, const std::string& Pattern, const std::vector<FImportMatte>& Mattes)
{
	const std::vector<std::string> Names = GetNames(Mattes);
	return {.Code = ErrorImportOption,
		.Message = Names.empty() ? "no file has objects with names (Cryptomatte), so none is \"" + Pattern + "\""
								 : "no object is called \"" + Pattern + "\"" + Suggest(Pattern, Names),
		.Where = Option};
}

} // namespace

std::vector<FImportMatte> FindImportMattes(const FImportLayers& Layers, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FImportMatte> Mattes;
	for (size_t File = 0; File < Layers.Files.size(); ++File)
	{
		const std::map<std::string, std::string>& Attributes = Layers.Files[File].Attributes;
		for (const auto& [Key, Name] : Attributes)
		{
			const bool bName = Key.starts_with("cryptomatte/") && Key.ends_with("/name");
			const std::optional<FImportSource> Ids = bName ? FindFirstRank(Layers, File, Name) : std::nullopt;
			if (!Ids)
			{
				continue;
			}
			const auto Manifest = Attributes.find(Key.substr(0, Key.size() - 4) + "manifest");
			if (Manifest != Attributes.end())
			{
				Mattes.push_back({Name, *Ids, ReadManifest(Manifest->second, Layers.Files[File].Path, Diagnostics)});
			}
		}
	}
	return Mattes;
}

std::vector<FImportSource> FImportChoices::GetSources() const
{
	std::vector<FImportSource> Sources;
	for (const std::vector<FImportChoice>* Choices : {&Toon, &Stencil})
	{
		for (const FImportChoice& Choice : *Choices)
		{
			for (const auto& [Source, Ids] : Choice.Objects)
			{
				Sources.push_back(Source);
			}
		}
	}
	return Sources;
}

FImportChoices ChooseImportObjects(
	const FImportAsked& Asked, const std::vector<FImportMatte>& Mattes, std::vector<FDiagnostic>& Errors)
{
	FImportChoices Choices;
	for (const std::string& Text : Asked.Toon)
	{
		FImportChoice Choice = ChooseByName(Text, Mattes);
		const std::optional<int> Value = ParseStencil(Text);
		if (Choice.NumObjects == 0 && Value)
		{
			Choice.StencilValues = {*Value};
		}
		else if (Choice.NumObjects == 0)
		{
			Errors.push_back(MakeNoObject("--toon", Text, Mattes));
		}
		Choices.Toon.push_back(std::move(Choice));
	}
	for (const std::string& Text : Asked.Stencil)
	{
		const size_t Equals = Text.rfind('=');
		const std::optional<int> Value =
			Equals == std::string::npos ? std::nullopt : ParseStencil(Text.substr(Equals + 1));
		if (!Value)
		{
			Errors.push_back({.Code = ErrorImportOption,
				.Message = "\"" + Text + "\": expected OBJECT=VALUE, a value from 0 to 255",
				.Where = "--stencil"});
			continue;
		}
		FImportChoice Choice = ChooseByName(Text.substr(0, Equals), Mattes);
		Choice.Value = *Value;
		if (Choice.NumObjects == 0)
		{
			Errors.push_back(MakeNoObject("--stencil", Text.substr(0, Equals), Mattes));
		}
		Choices.Stencil.push_back(std::move(Choice));
	}
	return Choices;
}

bool IsChosen(const FImportChoice& Choice, const FImportPlanes& Planes, size_t Pixel, int StencilValue)
{
	return Choice.StencilValues.count(StencilValue) > 0 ||
		   std::ranges::any_of(Choice.Objects, [&](const auto& Objects)
			   { return Objects.second.count(std::bit_cast<uint32_t>(Planes.Get(Objects.first)[Pixel])) > 0; });
}

} // namespace Drydock
