// Source: drydock.
#include "Scene.h"

#include "ConfigReader.h"
#include "NonFinite.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneLight.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

std::string ResolveSceneFile(const FConfig& Config)
{
	if (!Config.Scene.File.IsSet())
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorMissingKey;
		Diagnostic.File = Config.File;
		Diagnostic.Where = "/scene/file";
		Diagnostic.Message = "the config names no scene: \"scene\": {\"file\": \"...\"}";
		throw FError(Diagnostic, ExitUsage);
	}
	return Config.Resolve(Config.Scene.File.Value);
}

} // namespace

FScene::FScene(const FConfig& InConfig)
	: Config(InConfig.Scene)
	, File(ResolveSceneFile(InConfig))
	, Camera(ReadSceneCamera(File.GetAttribute("drydock:camera_json")))
	, LightColor(
		  ReadSceneLightColor(File.GetAttribute("drydock:camera_json")).value_or(FLinearColor(1.0f, 1.0f, 1.0f, 1.0f)))
{
	for (const std::string& Name : File.GetChannels())
	{
		Channels.push_back({Name, false});
	}
	CheckNames(InConfig);
}

FIntPoint FScene::GetExtent() const
{
	const FConfigPadding& Padding = Config.Padding;
	return FIntPoint(Padding.Left + File.GetWidth() + Padding.Right, Padding.Top + File.GetHeight() + Padding.Bottom);
}

FIntRect FScene::GetPictureRect() const
{
	const FIntPoint Min(Config.Padding.Left, Config.Padding.Top);
	return FIntRect(Min, Min + FIntPoint(File.GetWidth(), File.GetHeight()));
}

void FScene::CheckNames(const FConfig& InConfig) const
{
	std::vector<FDiagnostic> Diagnostics;
	FConfigMessages Messages(InConfig.File, Diagnostics);
	const auto CheckKnown = [&](const std::string& Name, const FConfigPlace& Place)
	{
		const std::vector<std::string>& Known = GetSceneChannelNames();
		if (std::find(Known.begin(), Known.end(), Name) == Known.end())
		{
			Messages.Error(ErrorUnknownValue, Place, "no pass knows a channel \"" + Name + "\"" + Suggest(Name, Known));
		}
	};
	for (const auto& [Name, Channel] : Config.Channels)
	{
		CheckKnown(Name, Channel.Place);
		if (File.FindChannel(Channel.Value) < 0)
		{
			Messages.Error(ErrorUnknownValue, Channel.Place,
				File.GetPath() + " has no channel \"" + Channel.Value + "\"" +
					Suggest(Channel.Value, File.GetChannels()));
		}
	}
	for (const auto& [Name, Default] : Config.Defaults)
	{
		CheckKnown(Name, Default.Place);
	}
	if (!Diagnostics.empty())
	{
		throw FError(Diagnostics, ExitUsage);
	}
}

FSceneTextures FScene::RegisterTextures(FRDGBuilder& GraphBuilder)
{
	FSceneTextures Registered;
	Registered.Config.Extent = GetExtent();
	for (const FScenePacking& Packing : GetScenePackings())
	{
		const FRHITextureDesc Desc =
			FRHITextureDesc::Create2D(GetExtent(), Packing.Format, FClearValueBinding::Black, Packing.Flags);
		TRefCountPtr<FRHITexture>& Texture = Textures[Packing.Name];
		Texture = new FRHITexture(Desc, Packing.Name);
		Registered.*Packing.Texture =
			GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Packing.Name), Packing.Name);
	}
	return Registered;
}

FRHITexture* FScene::GetTexture(const std::string& Name) const
{
	const auto Found = Textures.find(Name);
	return Found == Textures.end() ? nullptr : Found->second.GetReference();
}

std::optional<FScene::FSource> FScene::FindSource(const FScenePackChannel& Channel) const
{
	const auto Mapped = Config.Channels.find(Channel.Name);
	const int FileChannel = File.FindChannel(Mapped != Config.Channels.end() ? Mapped->second.Value : Channel.Name);
	if (FileChannel >= 0)
	{
		return FSource{FileChannel, 0.0f};
	}
	const auto Default = Config.Defaults.find(Channel.Name);
	if (Default != Config.Defaults.end())
	{
		return FSource{-1, static_cast<float>(Default->second.Value)};
	}
	return Channel.Default ? std::optional(FSource{-1, *Channel.Default}) : std::nullopt;
}

FError FScene::MakeMissingChannel(const std::string& Channel, const FNeededSceneTexture& Needed) const
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = ErrorChannelMissing;
	Diagnostic.File = File.GetPath();
	Diagnostic.Message = "there is no channel \"" + Channel + "\", which pass " + Needed.Pass + " needs for " +
						 Needed.Texture + Suggest(Channel, File.GetChannels()) + "; map it in scene.channels ({\"" +
						 Channel + "\": \"name in the file\"}) or give it a value in scene.defaults ({\"" + Channel +
						 "\": 0})";
	return FError(Diagnostic, ExitFiles);
}

/** Empty when there is nothing to do. */
std::optional<FScene::FFill> FScene::PlanFill(const FNeededSceneTexture& Needed) const
{
	FFill Fill{FindScenePacking(Needed.Texture), GetTexture(Needed.Texture), {}};
	const auto Known = Filled.find(Needed.Texture);
	if (Fill.Packing == nullptr || Fill.Texture == nullptr || (Known != Filled.end() && Known->second))
	{
		return std::nullopt;
	}
	for (const FScenePackChannel& Channel : Fill.Packing->Channels)
	{
		if (Channel.Name == nullptr)
		{
			break;
		}
		const std::optional<FSource> Source = FindSource(Channel);
		if (!Source && Needed.bIsRead)
		{
			throw MakeMissingChannel(Channel.Name, Needed);
		}
		if (!Source)
		{
			return std::nullopt;
		}
		Fill.Sources.push_back(*Source);
	}
	return Fill;
}

FScene::FPlanes FScene::ReadPlanes(const std::vector<FFill>& Fills)
{
	FPlanes Planes;
	for (const FFill& Fill : Fills)
	{
		for (const FSource& Source : Fill.Sources)
		{
			if (Source.FileChannel >= 0)
			{
				Planes[Source.FileChannel];
			}
		}
	}
	std::vector<int> Indices;
	for (const auto& [Index, Plane] : Planes)
	{
		Indices.push_back(Index);
	}
	std::vector<std::vector<float>> Values = File.Read(Indices);
	for (size_t Index = 0; Index < Indices.size(); ++Index)
	{
		Planes[Indices[Index]] = std::move(Values[Index]);
	}
	return Planes;
}

/** What is not filled yet; counts as filled from now on, and its channels as decoded. */
std::vector<FScene::FFill> FScene::PlanFills(const std::vector<FNeededSceneTexture>& Needed)
{
	std::vector<FFill> Fills;
	for (const FNeededSceneTexture& Texture : Needed)
	{
		if (std::optional<FFill> Fill = PlanFill(Texture))
		{
			Filled[Texture.Texture] = true;
			for (const FSource& Source : Fill->Sources)
			{
				if (Source.FileChannel >= 0)
				{
					Channels[static_cast<size_t>(Source.FileChannel)].bDecoded = true;
				}
			}
			Fills.push_back(std::move(*Fill));
		}
	}
	return Fills;
}

void FScene::Plan(const std::vector<FNeededSceneTexture>& Needed)
{
	PlanFills(Needed);
}

void FScene::Load(const std::vector<FNeededSceneTexture>& Needed, const FScenePackContext& Context)
{
	const std::vector<FFill> Fills = PlanFills(Needed);
	if (!Fills.empty())
	{
		const FPlanes Planes = ReadPlanes(Fills);
		for (const FFill& One : Fills)
		{
			Fill(One, Planes, Context);
		}
	}
}

void FScene::Fill(const FFill& Fill, const FPlanes& Planes, const FScenePackContext& Context)
{
	const FIntRect Picture = GetPictureRect();
	const FIntPoint Extent = GetExtent();
	const bool bZero = GetNonFinitePolicy() == ENonFinitePolicy::Zero;
	const std::vector<FSource>& Sources = Fill.Sources;
	std::vector<const float*> Data;
	for (const FSource& Source : Sources)
	{
		Data.push_back(Source.FileChannel >= 0 ? Planes.at(Source.FileChannel).data() : nullptr);
	}
	std::vector<FNonFiniteCount> RowCounts(static_cast<size_t>(Extent.Y));
	const auto GetValues = [&](int32 X, int32 Y, FNonFiniteCount& Count)
	{
		const size_t Pixel = static_cast<size_t>(Y) * static_cast<size_t>(Picture.Width()) + static_cast<size_t>(X);
		FScenePackValues Values = {};
		for (size_t Slot = 0; Slot < Sources.size(); ++Slot)
		{
			Values[Slot] = Data[Slot] != nullptr ? Data[Slot][Pixel] : Sources[Slot].Default;
			if (!std::isfinite(Values[Slot]))
			{
				Count = Count.Count++ == 0 ? FNonFiniteCount{1, X, Y} : Count;
				Values[Slot] = bZero ? 0.0f : Values[Slot];
			}
		}
		return Values;
	};

	Fill.Texture->EnsureMemory();
	ForEachTile(FKernelTile{0, 0, 0, Extent.X, Extent.Y, 1}, FIntPoint(Extent.X, 16),
		[&](const FKernelTile& Tile)
		{
			TArray<FLinearColor> Row;
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				Row.Init(Fill.Packing->Outside, Extent.X);
				const bool bInside = Y >= Picture.Min.Y && Y < Picture.Max.Y;
				for (int32 X = Picture.Min.X; bInside && X < Picture.Max.X; ++X)
				{
					Row[X] = Fill.Packing->Pack(
						GetValues(X - Picture.Min.X, Y - Picture.Min.Y, RowCounts[static_cast<size_t>(Y)]), Context);
				}
				Fill.Texture->WriteRow(0, Y, Row);
			}
		});
	if (Fill.Packing->Texture != &FSceneTextures::Color)
	{
		return;
	}
	for (const FNonFiniteCount& Count : RowCounts)
	{
		NonFinite = NonFinite.Count == 0
						? Count
						: FNonFiniteCount{NonFinite.Count + Count.Count, NonFinite.FirstX, NonFinite.FirstY};
	}
}

} // namespace Drydock
