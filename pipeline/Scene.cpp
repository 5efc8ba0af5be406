// Source: drydock.
#include "Scene.h"

#include "ConfigReader.h"
#include "Json.h"
#include "NonFinite.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Every channel that a scene can have, by the names that passes know. */
const std::vector<std::string>& GetSceneChannelNames()
{
	static const std::vector<std::string> Names = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
		"velocity.X", "velocity.Y", "basecolor.R", "basecolor.G", "basecolor.B", "shadingmodel.ID", "custommask.B",
		"shadow.R", "shadow.G"};
	return Names;
}

const std::vector<std::string> SceneColorChannels = {"R", "G", "B", "A"};

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

double ReadNumber(const FJsonValue& Object, const char* Key, double Default)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr && Value->Type == EJsonType::Number ? Value->Number : Default;
}

std::optional<FSceneCamera> ReadCamera(const std::string& Json)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Json, "drydock:camera_json", Ignored, bSyntaxError);
	const FJsonValue* Position = Root.Find("position_uecm");
	FConfigVector Location;
	if (bSyntaxError || Position == nullptr || !ReadConfigVector(*Position, Location))
	{
		return std::nullopt;
	}
	FSceneCamera Camera;
	Camera.Location = FVector(Location[0], Location[1], Location[2]);
	Camera.HorizontalFov = ReadNumber(Root, "hfov_deg", Camera.HorizontalFov);
	if (const FJsonValue* Rotator = Root.Find("rotator_ue_deg"))
	{
		Camera.Pitch = ReadNumber(*Rotator, "pitch", 0.0);
		Camera.Yaw = ReadNumber(*Rotator, "yaw", 0.0);
		Camera.Roll = ReadNumber(*Rotator, "roll", 0.0);
	}
	return Camera;
}

} // namespace

FScene::FScene(const FConfig& InConfig)
	: Config(InConfig.Scene)
	, ConfigFile(InConfig.File)
	, File(ResolveSceneFile(InConfig))
	, Camera(ReadCamera(File.GetAttribute("drydock:camera_json")))
{
	for (const std::string& Name : File.GetChannels())
	{
		Channels.push_back({Name, false});
	}
	CheckNames(InConfig);
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

FRDGTextureRef FScene::RegisterSceneColor(FRDGBuilder& GraphBuilder)
{
	const FRHITextureDesc Desc = FRHITextureDesc::Create2D(GetExtent(), PF_FloatRGBA, FClearValueBinding::Black,
		ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | ETextureCreateFlags::UAV);
	SceneColor = new FRHITexture(Desc, TEXT("SceneColor"));
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(SceneColor, TEXT("SceneColor")), TEXT("SceneColor"));
}

FScene::FSource FScene::FindSource(const std::string& Channel, const FNeededSceneTexture& Needed) const
{
	const auto Mapped = Config.Channels.find(Channel);
	const int FileChannel = File.FindChannel(Mapped != Config.Channels.end() ? Mapped->second.Value : Channel);
	if (FileChannel >= 0)
	{
		return {FileChannel, 0.0f};
	}
	const auto Default = Config.Defaults.find(Channel);
	if (Default != Config.Defaults.end())
	{
		return {-1, static_cast<float>(Default->second.Value)};
	}
	if (Channel == "A")
	{
		return {-1, 1.0f}; // an RGB picture is opaque
	}
	FDiagnostic Diagnostic;
	Diagnostic.Code = ErrorChannelMissing;
	Diagnostic.File = File.GetPath();
	Diagnostic.Message = "there is no channel \"" + Channel + "\", which pass " + Needed.Pass + " needs for " +
						 Needed.Texture + Suggest(Channel, File.GetChannels()) + "; map it in scene.channels ({\"" +
						 Channel + "\": \"name in the file\"}) or give it a value in scene.defaults";
	throw FError(Diagnostic, ExitFiles);
}

void FScene::Load(const std::vector<FNeededSceneTexture>& Needed, float PreExposure)
{
	for (const FNeededSceneTexture& Texture : Needed)
	{
		if (Texture.Texture != "SceneColor" || !SceneColor)
		{
			continue;
		}
		std::vector<FSource> Sources;
		for (const std::string& Channel : SceneColorChannels)
		{
			Sources.push_back(FindSource(Channel, Texture));
		}
		FillSceneColor(Sources, PreExposure);
	}
}

void FScene::FillSceneColor(const std::vector<FSource>& Sources, float PreExposure)
{
	std::vector<int> FileChannels;
	for (const FSource& Source : Sources)
	{
		if (Source.FileChannel >= 0)
		{
			FileChannels.push_back(Source.FileChannel);
			Channels[static_cast<size_t>(Source.FileChannel)].bDecoded = true;
		}
	}
	const std::vector<std::vector<float>> Planes = File.Read(FileChannels);

	const int32 Width = File.GetWidth();
	const int32 Height = File.GetHeight();
	const ENonFinitePolicy Policy = GetNonFinitePolicy();
	std::vector<FNonFiniteCount> RowCounts(static_cast<size_t>(Height));
	SceneColor->EnsureMemory();
	const FKernelTile Whole = {0, 0, 0, Width, Height, 1};
	ForEachTile(Whole, FIntPoint(Width, 16),
		[&](const FKernelTile& Tile)
		{
			TArray<FLinearColor> Row;
			Row.SetNum(Width);
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				for (int32 X = 0; X < Width; ++X)
				{
					float Components[4];
					size_t Plane = 0;
					for (size_t Channel = 0; Channel < 4; ++Channel)
					{
						const FSource& Source = Sources[Channel];
						const size_t Pixel =
							static_cast<size_t>(Y) * static_cast<size_t>(Width) + static_cast<size_t>(X);
						float Value = Source.FileChannel >= 0 ? Planes[Plane++][Pixel] : Source.Default;
						if (!std::isfinite(Value))
						{
							FNonFiniteCount& Count = RowCounts[static_cast<size_t>(Y)];
							Count = Count.Count++ == 0 ? FNonFiniteCount{1, X, Y} : Count;
							Value = Policy == ENonFinitePolicy::Zero ? 0.0f : Value;
						}
						Components[Channel] = Channel < 3 ? Value * PreExposure : Value;
					}
					Row[X] = FLinearColor(Components[0], Components[1], Components[2], Components[3]);
				}
				SceneColor->WriteRow(0, Y, Row);
			}
		});
	for (const FNonFiniteCount& Count : RowCounts)
	{
		NonFinite = NonFinite.Count == 0
						? Count
						: FNonFiniteCount{NonFinite.Count + Count.Count, NonFinite.FirstX, NonFinite.FirstY};
	}
}

} // namespace Drydock
