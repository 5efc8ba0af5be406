// Registers a scene's channels and loads those that surviving passes read.
#include "SceneFile/SceneFile.h"

#include "Config/ConfigReader.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneFile/ChannelValues.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneCheck.h"
#include "SceneFile/SceneFill.h"
#include "SceneFile/SceneLight.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <set>

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

FSceneFile::FSceneFile(const FConfig& InConfig, FSceneCache* InCache)
	: Config(InConfig.Scene)
	, File(ResolveSceneFile(InConfig), EImageExtent::Display)
	, Cache(InCache)
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
	for (const auto& [Name, Names] : Config.Textures)
	{
		FOwnTexture& Own = OwnTextures.emplace_back(FOwnTexture{Name, SplitChannelNames(Names.Value), {}});
		Own.Packing = MakeOwnScenePacking(Own.Name, Own.Channels);
	}
}

const FScenePacking* FSceneFile::FindPacking(const std::string& Texture) const
{
	const auto Own = std::ranges::find(OwnTextures, Texture, &FOwnTexture::Name);
	return Own != OwnTextures.end() ? &Own->Packing : FindScenePacking(Texture);
}

FRDGTextureRef FSceneFile::Register(FRDGBuilder& GraphBuilder, const FScenePacking& Packing)
{
	TRefCountPtr<FRHITexture>& Texture = Textures[Packing.Name];
	Texture = new FRHITexture(
		FRHITextureDesc::Create2D(GetExtent(), Packing.Format, FClearValueBinding::Black, Packing.Flags), Packing.Name);
	if (Cache != nullptr && KeptContext)
	{
		const std::string Key = Keys[Packing.Name] = MakeKey(Packing, *Texture);
		const FKeptSceneTexture* const Known = Cache->FindTexture(Packing.Name);
		if (Known != nullptr && Known->Key == Key)
		{
			Texture = Known->Texture;
			Kept[Packing.Name] = Known->NonFinite;
		}
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Packing.Name), Packing.Name);
}

void FSceneFile::UseKeptTextures(const FScenePackContext& Context)
{
	KeptContext = Context;
	if (Cache != nullptr)
	{
		Cache->Begin(File.GetPath());
	}
}

void FSceneFile::ForgetKept(const std::string& Texture)
{
	Keys.erase(Texture);
	if (Cache != nullptr)
	{
		Cache->ForgetTexture(Texture);
	}
}

/** Everything that FillSceneTexture reads, as text. */
std::string FSceneFile::MakeKey(const FScenePacking& Packing, const FRHITexture& Texture) const
{
	std::string Key;
	const auto Add = [&Key](const auto&... Values)
	{
		((Key += NumberText(static_cast<double>(Values)) + " "), ...);
	};
	const auto AddRect = [&](const FIntRect& Rect)
	{
		Add(Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y);
	};
	Add(static_cast<int>(Texture.GetStorage()), GetExtent().X, GetExtent().Y, Config.Padding.Left, Config.Padding.Top);
	Add(static_cast<int>(GetNonFinitePolicy()), GetSceneColorClamp(), KeptContext->PreExposure, KeptContext->ViewSize.X,
		KeptContext->ViewSize.Y);
	const FSceneUnits& Units = KeptContext->Units;
	Add(Units.bDepthInCentimetres, Units.bVelocityIsNdc, Units.bNormalIsLeftHanded);
	for (const FSceneRegion& Region : GetRegions())
	{
		AddRect(Region.Source);
		AddRect(Region.Target);
	}
	for (const FScenePackChannel& Channel : Packing.Channels)
	{
		const FSource Source = Channel.Name != nullptr ? FindSource(Channel).value_or(FSource()) : FSource();
		Add(Source.FileChannel, Source.Default);
	}
	return Key;
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
		Packing.SetTexture(Registered, Register(GraphBuilder, Packing));
	}
	for (const FOwnTexture& Own : OwnTextures)
	{
		Registered.Named[Own.Name] = Register(GraphBuilder, Own.Packing);
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
	return std::ranges::any_of(Packing.Channels, [this](const FScenePackChannel& Channel)
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
	for (size_t Part = 1; Part < File.GetParts().size(); ++Part)
	{
		const FImagePart& Other = File.GetParts()[Part];
		if (std::ranges::find(Other.Channels, Channel) != Other.Channels.end())
		{
			Diagnostic.Message +=
				". Part " + std::to_string(Part + 1) + " of the file" +
				(Other.Name.empty() ? "" : ", \"" + Other.Name + "\",") +
				" has it, but drydock reads only the first part of a scene: drydock import merges all parts";
			break;
		}
	}
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
	FFill Fill{FindPacking(Needed.Texture), GetTexture(Needed.Texture), {}};
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

/** Those that are not here yet, in one read of the file. */
void FSceneFile::ReadPlanes(const std::vector<int>& FileChannels)
{
	if (Cache != nullptr)
	{
		Cache->Begin(File.GetPath());
	}
	std::set<int> Missing;
	for (const int Index : FileChannels)
	{
		if (Index < 0 || Planes.count(Index) > 0)
		{
			continue;
		}
		if (const FSceneCache::FPlane Kept = Cache != nullptr ? Cache->Find(Index) : nullptr)
		{
			Planes[Index] = Kept;
		}
		else
		{
			Missing.insert(Index);
		}
	}
	const std::vector<int> Indices(Missing.begin(), Missing.end());
	std::vector<FImagePlane> Values = File.ReadPlanes(Indices);
	for (size_t Index = 0; Index < Indices.size(); ++Index)
	{
		const auto Plane = std::make_shared<const FImagePlane>(std::move(Values[Index]));
		Planes[Indices[Index]] = Plane;
		if (Cache != nullptr)
		{
			Cache->Keep(Indices[Index], Plane);
		}
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
			const bool bNamed = Channel.Name != nullptr && std::ranges::find(Names, Channel.Name) != Names.end();
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
		const FImagePlane* const Plane = Source.FileChannel >= 0 ? Planes.at(Source.FileChannel).get() : nullptr;
		Values[Name] = {Plane, Source.Default, File.GetWidth(), bZero};
	}
	return Values;
}

/** The textures that are not filled yet. They count as filled from now on, and their channels as decoded. */
std::vector<FSceneFile::FFill> FSceneFile::PlanFills(const std::vector<FNeededSceneTexture>& Needed)
{
	std::vector<FFill> Fills;
	for (const FNeededSceneTexture& Texture : Needed)
	{
		if (std::optional<FFill> Fill = PlanFill(Texture))
		{
			Filled[Texture.Texture] = true;
			CountDecoded(Fill->Sources);
			if (const auto Known = Kept.find(Texture.Texture); Known != Kept.end())
			{
				NonFinite.insert(NonFinite.end(), Known->second.begin(), Known->second.end());
				continue;
			}
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
	const auto Found = std::ranges::find(Regions, Target, &FSceneRegion::Target);
	const FIntRect Whole(0, 0, File.GetWidth(), File.GetHeight());
	return Found != Regions.end() ? *Found
		   : Regions.empty()      ? FSceneRegion{Target, Target}
								  : FSceneRegion{Whole, Target};
}

void FSceneFile::Fill(const FFill& Fill, const FScenePackContext& Context)
{
	FSceneFillInputs Inputs{
		*Fill.Packing, {}, File.GetWidth(), Context, GetRegions(), FIntPoint(Config.Padding.Left, Config.Padding.Top)};
	for (const FSource& Source : Fill.Sources)
	{
		Inputs.Sources.push_back(
			{Source.FileChannel >= 0 ? Planes.at(Source.FileChannel).get() : nullptr, Source.Default});
	}
	const FNonFiniteSlots Counts = FillSceneTexture(*Fill.Texture, Inputs);
	std::vector<FNonFiniteChannel> Found;
	FNonFiniteChannel Color{SceneColorWhere, {}};
	for (size_t Slot = 0; Slot < Fill.Sources.size(); ++Slot)
	{
		if (Fill.Packing == &GetScenePackings().front())
		{
			Color.Found.Add(Counts[Slot]);
		}
		else if (Counts[Slot].Count > 0)
		{
			const size_t FileChannel = static_cast<size_t>(Fill.Sources[Slot].FileChannel);
			Found.push_back({"channel " + File.GetChannels()[FileChannel], Counts[Slot]});
		}
	}
	if (Color.Found.Count > 0)
	{
		Found.push_back(Color);
	}
	NonFinite.insert(NonFinite.end(), Found.begin(), Found.end());
	if (const auto Key = Keys.find(Fill.Packing->Name); Key != Keys.end())
	{
		Cache->KeepTexture(Fill.Packing->Name, {Key->second, Fill.Texture, Found});
	}
}

} // namespace Drydock
