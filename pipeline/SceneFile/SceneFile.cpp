// Registers a scene's channels and loads those that surviving passes read.
#include "SceneFile/SceneFile.h"

#include "Config/ConfigReader.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneCheck.h"
#include "SceneFile/SceneLight.h"
#include "TileExecutor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Drydock
{

namespace
{

std::string ResolveSceneFile(const FConfig& Config)
{
	if (!Config.Scene.File.IsSet())
	{
		throw FError(DescribeMissingScene(Config), ExitUsage);
	}
	return Config.Resolve(Config.Scene.File.Value);
}

} // namespace

FSceneFile::FSceneFile(const FConfig& InConfig)
	: Config(InConfig.Scene)
	, File(ResolveSceneFile(InConfig))
	, Camera(ReadSceneCamera(File.GetAttribute("drydock:camera_json")))
	, DeltaTime(ReadSceneDeltaTime(File.GetAttribute("drydock:camera_json")))
	, LightColor(
		  ReadSceneLightColor(File.GetAttribute("drydock:camera_json")).value_or(FLinearColor(1.0f, 1.0f, 1.0f, 1.0f)))
{
	for (const std::string& Name : File.GetChannels())
	{
		Channels.push_back({Name, false});
	}
	std::vector<FDiagnostic> Diagnostics;
	CheckSceneChannels(InConfig, &File, Diagnostics);
	if (!Diagnostics.empty())
	{
		throw FError(Diagnostics, ExitUsage);
	}
}

void FSceneFile::SetResolution(double InScreenPercentage, std::vector<FSceneRegion> InRegions)
{
	ScreenPercentage = InScreenPercentage;
	Regions = std::move(InRegions);
}

FIntPoint FSceneFile::GetExtent() const
{
	const FConfigPadding& Padding = Config.Padding;
	const FIntRect Picture = ScaleRect(FIntRect(0, 0, File.GetWidth(), File.GetHeight()), ScreenPercentage);
	return FIntPoint(Padding.Left + Picture.Width() + Padding.Right, Padding.Top + Picture.Height() + Padding.Bottom);
}

FIntPoint FSceneFile::GetOutputExtent() const
{
	const FConfigPadding& Padding = Config.Padding;
	return FIntPoint(Padding.Left + File.GetWidth() + Padding.Right, Padding.Top + File.GetHeight() + Padding.Bottom);
}

FIntRect FSceneFile::GetPictureRect() const
{
	const FIntPoint Min(Config.Padding.Left, Config.Padding.Top);
	return FIntRect(Min, Min + FIntPoint(File.GetWidth(), File.GetHeight()));
}

FSceneTextures FSceneFile::RegisterTextures(FRDGBuilder& GraphBuilder)
{
	FSceneTextures Registered;
	Registered.Config.Extent = GetExtent();
	for (const FScenePacking& Packing : GetScenePackings())
	{
		if (Packing.bOptional && !HasAnyChannel(Packing))
		{
			continue;
		}
		const FRHITextureDesc Desc =
			FRHITextureDesc::Create2D(GetExtent(), Packing.Format, FClearValueBinding::Black, Packing.Flags);
		TRefCountPtr<FRHITexture>& Texture = Textures[Packing.Name];
		Texture = new FRHITexture(Desc, Packing.Name);
		Packing.SetTexture(
			Registered, GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Packing.Name), Packing.Name));
	}
	if (Registered.CustomStencilTexture)
	{
		Registered.CustomStencil = GraphBuilder.CreateSRV(FRDGTextureSRVDesc::Create(Registered.CustomStencilTexture));
	}
	return Registered;
}

FRHITexture* FSceneFile::GetTexture(const std::string& Name) const
{
	const auto Found = Textures.find(Name);
	return Found == Textures.end() ? nullptr : Found->second.GetReference();
}

std::optional<FSceneFile::FSource> FSceneFile::FindSource(const FScenePackChannel& Channel) const
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

bool FSceneFile::HasAnyChannel(const FScenePacking& Packing) const
{
	return std::any_of(Packing.Channels.begin(), Packing.Channels.end(),
		[this](const FScenePackChannel& Channel)
		{ return Channel.Name != nullptr && FindSource(Channel).has_value(); });
}

FError FSceneFile::MakeMissingChannel(const std::string& Channel, const FNeededSceneTexture& Needed) const
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

bool FSceneFile::IsFilled(const std::string& Texture) const
{
	const auto Known = Filled.find(Texture);
	return Known != Filled.end() && Known->second;
}

/** Empty when there is nothing to do. */
std::optional<FSceneFile::FFill> FSceneFile::PlanFill(const FNeededSceneTexture& Needed) const
{
	FFill Fill{FindScenePacking(Needed.Texture), GetTexture(Needed.Texture), {}};
	if (Fill.Packing == nullptr || Fill.Texture == nullptr || IsFilled(Needed.Texture))
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

/** Those that are not read yet, in one read of the file. */
void FSceneFile::ReadPlanes(const std::vector<int>& FileChannels)
{
	std::vector<int> Indices;
	std::copy_if(FileChannels.begin(), FileChannels.end(), std::back_inserter(Indices),
		[this](int Index) { return Index >= 0 && Planes.count(Index) == 0; });
	std::sort(Indices.begin(), Indices.end());
	Indices.erase(std::unique(Indices.begin(), Indices.end()), Indices.end());
	std::vector<std::vector<float>> Values = File.Read(Indices);
	for (size_t Index = 0; Index < Indices.size(); ++Index)
	{
		Planes[Indices[Index]] = std::move(Values[Index]);
	}
}

void FSceneFile::CountDecoded(const std::vector<FSource>& Sources)
{
	for (const FSource& Source : Sources)
	{
		if (Source.FileChannel >= 0)
		{
			Channels[static_cast<size_t>(Source.FileChannel)].bDecoded = true;
		}
	}
}

std::map<std::string, FChannelValues> FSceneFile::ReadChannels(const std::vector<std::string>& Names)
{
	std::map<std::string, FSource> Sources;
	for (const FScenePacking& Packing : GetScenePackings())
	{
		for (const FScenePackChannel& Channel : Packing.Channels)
		{
			const bool bNamed =
				Channel.Name != nullptr && std::find(Names.begin(), Names.end(), Channel.Name) != Names.end();
			if (const std::optional<FSource> Source = bNamed ? FindSource(Channel) : std::nullopt)
			{
				Sources[Channel.Name] = *Source;
			}
		}
	}
	std::vector<int> FileChannels;
	for (const auto& [Name, Source] : Sources)
	{
		FileChannels.push_back(Source.FileChannel);
		CountDecoded({Source});
	}
	// Whatever else is left out, scene colour is read: once through the file brings both.
	for (const FScenePackChannel& Channel : GetScenePackings().front().Channels)
	{
		FileChannels.push_back(FindSource(Channel).value_or(FSource()).FileChannel);
	}
	ReadPlanes(FileChannels);

	const bool bZero = GetNonFinitePolicy() == ENonFinitePolicy::Zero;
	std::map<std::string, FChannelValues> Values;
	for (const auto& [Name, Source] : Sources)
	{
		const float* const Plane = Source.FileChannel >= 0 ? Planes.at(Source.FileChannel).data() : nullptr;
		Values[Name] = {Plane, Source.Default, File.GetWidth(), bZero};
	}
	return Values;
}

/** What is not filled yet; counts as filled from now on, and its channels as decoded. */
std::vector<FSceneFile::FFill> FSceneFile::PlanFills(const std::vector<FNeededSceneTexture>& Needed)
{
	std::vector<FFill> Fills;
	for (const FNeededSceneTexture& Texture : Needed)
	{
		if (std::optional<FFill> Fill = PlanFill(Texture))
		{
			Filled[Texture.Texture] = true;
			CountDecoded(Fill->Sources);
			Fills.push_back(std::move(*Fill));
		}
	}
	return Fills;
}

void FSceneFile::Plan(const std::vector<FNeededSceneTexture>& Needed)
{
	PlanFills(Needed);
}

void FSceneFile::Load(const std::vector<FNeededSceneTexture>& Needed, const FScenePackContext& Context)
{
	const std::vector<FFill> Fills = PlanFills(Needed);
	std::vector<int> FileChannels;
	for (const FFill& One : Fills)
	{
		for (const FSource& Source : One.Sources)
		{
			FileChannels.push_back(Source.FileChannel);
		}
	}
	ReadPlanes(FileChannels);
	for (const FFill& One : Fills)
	{
		Fill(One, Context);
	}
	if (!Fills.empty())
	{
		Planes.clear();
	}
}

std::vector<FSceneRegion> FSceneFile::GetRegions() const
{
	const FIntRect Whole(0, 0, File.GetWidth(), File.GetHeight());
	return Regions.empty() ? std::vector<FSceneRegion>{{Whole, Whole}} : Regions;
}

FSceneRegion FSceneFile::FindRegion(const FIntRect& ViewRect) const
{
	const FIntRect Target = ViewRect - FIntPoint(Config.Padding.Left, Config.Padding.Top);
	const auto Found = std::find_if(
		Regions.begin(), Regions.end(), [&](const FSceneRegion& Region) { return Region.Target == Target; });
	const FIntRect Whole(0, 0, File.GetWidth(), File.GetHeight());
	return Found != Regions.end() ? *Found
		   : Regions.empty()      ? FSceneRegion{Target, Target}
								  : FSceneRegion{Whole, Target};
}

namespace
{

/** The file's values at one pixel of a texture at another resolution. */
class FPixelSource
{
public:
	FPixelSource(const FSceneRegion& Region, bool bInArea)
		: bArea(bInArea)
		, Corner(Region.Source.Min)
	{
		for (int32 X = 0; X < Region.Target.Width(); ++X)
		{
			Columns.push_back(Choose(Region.Source.Width(), Region.Target.Width(), X));
		}
		for (int32 Y = 0; Y < Region.Target.Height(); ++Y)
		{
			Rows.push_back(Choose(Region.Source.Height(), Region.Target.Height(), Y));
		}
	}

	/** GetValues: of a pixel of the file. One source pixel alone comes through bit for bit. */
	template<typename TFunction>
	FScenePackValues Get(int32 X, int32 Y, TFunction&& GetValues) const
	{
		const FCoverage& Column = Columns[static_cast<size_t>(X)];
		const FCoverage& Row = Rows[static_cast<size_t>(Y)];
		if (Column.Parts.size() == 1 && Row.Parts.size() == 1)
		{
			return GetValues(Corner.X + Column.First, Corner.Y + Row.First);
		}
		std::array<double, std::tuple_size_v<FScenePackValues>> Sums = {};
		for (size_t J = 0; J < Row.Parts.size(); ++J)
		{
			for (size_t I = 0; I < Column.Parts.size(); ++I)
			{
				const FScenePackValues Values = GetValues(
					Corner.X + Column.First + static_cast<int32>(I), Corner.Y + Row.First + static_cast<int32>(J));
				for (size_t Slot = 0; Slot < Sums.size(); ++Slot)
				{
					Sums[Slot] += static_cast<double>(Values[Slot]) * Column.Parts[I] * Row.Parts[J];
				}
			}
		}
		FScenePackValues Means = {};
		std::transform(Sums.begin(), Sums.end(), Means.begin(), [](double Sum) { return static_cast<float>(Sum); });
		return Means;
	}

private:
	FCoverage Choose(int SourceSize, int TargetSize, int Index) const
	{
		return bArea ? MakeCoverage(SourceSize, TargetSize, Index)
					 : FCoverage{FindCenterPixel(SourceSize, TargetSize, Index), {1.0}};
	}

	bool bArea;
	FIntPoint Corner;
	std::vector<FCoverage> Columns;
	std::vector<FCoverage> Rows;
};

} // namespace

void FSceneFile::Fill(const FFill& Fill, const FScenePackContext& Context)
{
	const FIntPoint Corner(Config.Padding.Left, Config.Padding.Top);
	const FIntPoint Extent = GetExtent();
	const bool bZero = GetNonFinitePolicy() == ENonFinitePolicy::Zero;
	const bool bColor = Fill.Packing == &GetScenePackings().front();
	const float Limit = bColor ? GetSceneColorClamp() : std::numeric_limits<float>::infinity();
	const std::vector<FSource>& Sources = Fill.Sources;
	std::vector<const float*> Data;
	for (const FSource& Source : Sources)
	{
		Data.push_back(Source.FileChannel >= 0 ? Planes.at(Source.FileChannel).data() : nullptr);
	}
	std::vector<FNonFiniteCount> RowCounts(static_cast<size_t>(Extent.Y));
	const auto GetValues = [&](int32 X, int32 Y, FNonFiniteCount& Count)
	{
		const size_t Pixel = static_cast<size_t>(Y) * static_cast<size_t>(File.GetWidth()) + static_cast<size_t>(X);
		FScenePackValues Values = {};
		for (size_t Slot = 0; Slot < Sources.size(); ++Slot)
		{
			Values[Slot] = Data[Slot] != nullptr ? Data[Slot][Pixel] : Sources[Slot].Default;
			if (Slot < 3 && std::abs(Values[Slot]) > Limit)
			{
				Values[Slot] = std::copysign(Limit, Values[Slot]);
			}
			if (!std::isfinite(Values[Slot]))
			{
				Count = Count.Count++ == 0 ? FNonFiniteCount{1, X, Y} : Count;
				Values[Slot] = bZero ? 0.0f : Values[Slot];
			}
		}
		return Values;
	};
	const std::vector<FSceneRegion> AllRegions = GetRegions();
	std::vector<FPixelSource> PixelSources;
	for (const FSceneRegion& Region : AllRegions)
	{
		PixelSources.emplace_back(Region, Fill.Packing->bMeanOfArea);
	}
	const auto FillRow = [&](int32 Y, TArray<FLinearColor>& Row)
	{
		for (size_t Index = 0; Index < AllRegions.size(); ++Index)
		{
			const FIntRect Target = AllRegions[Index].Target + Corner;
			const bool bInside = Y >= Target.Min.Y && Y < Target.Max.Y;
			for (int32 X = Target.Min.X; bInside && X < Target.Max.X; ++X)
			{
				Row[X] =
					Fill.Packing->Pack(PixelSources[Index].Get(X - Target.Min.X, Y - Target.Min.Y,
										   [&](int32 SourceX, int32 SourceY)
										   { return GetValues(SourceX, SourceY, RowCounts[static_cast<size_t>(Y)]); }),
						Context);
			}
		}
	};

	Fill.Texture->EnsureMemory();
	ForEachTile(FKernelTile{0, 0, 0, Extent.X, Extent.Y, 1}, FIntPoint(Extent.X, 16),
		[&](const FKernelTile& Tile)
		{
			TArray<FLinearColor> Row;
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				Row.Init(Fill.Packing->Outside, Extent.X);
				FillRow(Y, Row);
				Fill.Texture->WriteRow(0, Y, Row);
			}
		});
	if (!bColor)
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
