// Source: drydock.
#include "RunDump.h"

#include "ConfigErrors.h"
#include "ConfigReader.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace Drydock
{

namespace
{

std::string Sanitize(const std::string& Name)
{
	std::string Clean = Name;
	std::replace_if(
		Clean.begin(), Clean.end(),
		[](char Character)
		{ return !std::isalnum(static_cast<unsigned char>(Character)) && Character != '_' && Character != '-'; },
		'_');
	return Clean;
}

/** Names that a pattern could have meant. */
std::vector<std::string> GetDumpCandidates(const FRDGCompiledGraph& Graph)
{
	std::vector<std::string> Names;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		Names.push_back(GetShortPassName(Pass.Name));
	}
	for (const FRDGCompiledResource& Resource : Graph.Resources)
	{
		Names.push_back(Resource.Name);
	}
	return Names;
}

/** The first culled pass that a pattern fits, or null. */
const FRDGCompiledPass* FindCulledMatch(const std::string& Pattern, const FRDGCompiledGraph& Graph)
{
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		if (!Pass.bCulled)
		{
			continue;
		}
		for (const FRDGUse& Use : Pass.Uses)
		{
			const std::string& Resource = Graph.Resources[static_cast<size_t>(Use.Resource)].Name;
			if (Use.IsWrite() && IsDumped({{Pattern, {}}}, Pass.Name, Resource))
			{
				return &Pass;
			}
		}
	}
	return nullptr;
}

} // namespace

bool MatchesPattern(const std::string& Pattern, const std::string& Text)
{
	// The last star takes one character more whenever what follows it does not fit.
	size_t P = 0;
	size_t T = 0;
	size_t Star = std::string::npos;
	size_t StarText = 0;
	while (T < Text.size())
	{
		if (P < Pattern.size() && Pattern[P] == '*')
		{
			Star = P++;
			StarText = T;
		}
		else if (P < Pattern.size() && (Pattern[P] == '?' || Pattern[P] == Text[T]))
		{
			++P;
			++T;
		}
		else if (Star != std::string::npos)
		{
			P = Star + 1;
			T = ++StarText;
		}
		else
		{
			return false;
		}
	}
	return Pattern.find_first_not_of('*', P) == std::string::npos;
}

std::string GetShortPassName(const std::string& Pass)
{
	return Pass.substr(0, Pass.find_first_of(" ("));
}

bool IsDumped(
	const std::vector<TConfigValue<std::string>>& Patterns, const std::string& Pass, const std::string& Resource)
{
	const std::string Short = GetShortPassName(Pass);
	return std::any_of(Patterns.begin(), Patterns.end(),
		[&](const TConfigValue<std::string>& Pattern)
		{
			const auto Fits = [&](const std::string& Name)
			{
				return MatchesPattern(Pattern.Value, Name);
			};
			return Fits(Pass) || Fits(Short) || Fits(Resource) || Fits(Pass + "." + Resource) ||
				   Fits(Short + "." + Resource);
		});
}

std::string GetDumpFileName(const FRunDump& Dump)
{
	char Number[16];
	std::snprintf(Number, sizeof(Number), "%03d", Dump.PassIndex);
	return std::string(Number) + "." + Sanitize(GetShortPassName(Dump.Pass)) + "." + Sanitize(Dump.Resource) +
		   (Dump.Mip >= 0 ? ".mip" + std::to_string(Dump.Mip) : "");
}

FImage ReadTexture(FRHITexture& Texture, int Mip)
{
	const FIntVector Size = Texture.GetMipDimensions(static_cast<uint8>(Mip));
	FImage Image;
	Image.Width = Size.X;
	Image.Height = Size.Y;
	Image.NumChannels = std::clamp(GPixelFormats[Texture.GetFormat()].NumComponents, 1, 4);
	Image.Values.resize(
		static_cast<size_t>(Size.X) * static_cast<size_t>(Size.Y) * static_cast<size_t>(Image.NumChannels));
	Texture.EnsureMemory();
	ForEachTile(FKernelTile{0, 0, 0, Size.X, Size.Y, 1}, FIntPoint(Size.X, 16),
		[&](const FKernelTile& Tile)
		{
			double* Out = Image.Values.data() + static_cast<size_t>(Tile.MinY) * static_cast<size_t>(Size.X) *
													static_cast<size_t>(Image.NumChannels);
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				for (int32 X = 0; X < Size.X; ++X)
				{
					const FVector4 Texel = Texture.ReadTexelDouble(X, Y, Mip);
					const double Components[4] = {Texel.X, Texel.Y, Texel.Z, Texel.W};
					Out = std::copy(Components, Components + Image.NumChannels, Out);
				}
			}
		});
	return Image;
}

FImage CropToRgba(const FImage& Image, const FIntRect& Rect)
{
	FImage Crop;
	Crop.Width = Rect.Width();
	Crop.Height = Rect.Height();
	Crop.NumChannels = 4;
	Crop.Values.reserve(static_cast<size_t>(Crop.Width) * static_cast<size_t>(Crop.Height) * 4);
	for (int Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		for (int X = Rect.Min.X; X < Rect.Max.X; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				Crop.Values.push_back(Channel < Image.NumChannels ? Image.Get(X, Y, Channel)
									  : Channel == 3              ? 1.0
																  : 0.0);
			}
		}
	}
	return Crop;
}

std::vector<std::string> GetChannelNames(int NumChannels)
{
	const std::vector<std::string> Names = {"R", "G", "B", "A"};
	return std::vector<std::string>(Names.begin(), Names.begin() + NumChannels);
}

std::vector<FDiagnostic> CheckDumpPatterns(
	const std::vector<TConfigValue<std::string>>& Patterns, const FRunResult& Result)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfigMessages Messages(Result.Config.File, Diagnostics);
	for (const TConfigValue<std::string>& Pattern : Patterns)
	{
		const bool bUsed = std::any_of(Result.Dumps.begin(), Result.Dumps.end(),
			[&](const FRunDump& Dump) { return IsDumped({Pattern}, Dump.Pass, Dump.Resource); });
		if (bUsed)
		{
			continue;
		}
		const FRDGCompiledPass* Culled = FindCulledMatch(Pattern.Value, Result.Graph);
		const std::string Why =
			Culled != nullptr
				? "fits only culled passes: " + Culled->Name + " (" + Culled->Reason + ")"
				: "fits no pass and no resource" + Suggest(Pattern.Value, GetDumpCandidates(Result.Graph));
		Messages.Warn(WarnNothingDumped, Pattern.Place, "dump pattern \"" + Pattern.Value + "\" " + Why);
	}
	return Diagnostics;
}

} // namespace Drydock
