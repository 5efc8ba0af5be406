// Serves a graph while it is built and executed: scene textures, dumps, counters, progress.
#include "Run/RunObserver.h"

#include "Budget/RunOptions.h"
#include "Engine/TextureRenderTarget2D.h"
#include "Objects/ConfigAssets.h"
#include "Objects/ObjectErrors.h"
#include "Picture/TextureImage.h"
#include "Run/PassLook.h"
#include "Run/PassValues.h"
#include "Run/PassWrites.h"
#include "Run/RunDump.h"
#include "Run/RunErrors.h"
#include "Run/RunSetup.h"
#include "Run/SilentPass.h"
#include "Run/VariableTaps.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneErrors.h"
#include "Text/Fingerprint.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace Drydock
{

namespace
{

/** The rect of each mip. */
std::vector<FIntRect> GetWholeMips(const FRHITexture& Texture)
{
	std::vector<FIntRect> Rects;
	for (uint32 Mip = 0; Mip < Texture.GetNumMips(); ++Mip)
	{
		const FIntVector Size = Texture.GetMipDimensions(static_cast<uint8>(Mip));
		Rects.emplace_back(0, 0, Size.X, Size.Y);
	}
	return Rects;
}

std::string FingerprintTexture(FRHITexture& Texture)
{
	FFingerprint Fingerprint;
	for (int Mip = 0; Mip < static_cast<int>(Texture.GetNumMips()); ++Mip)
	{
		const FImage Image = ReadTexture(Texture, Mip);
		const std::array<int, 3> Size = {Image.Width, Image.Height, Image.NumChannels};
		Fingerprint.Add(Size.data(), sizeof(Size));
		Fingerprint.Add(Image.Values.data(), Image.Values.size() * sizeof(double));
	}
	return Fingerprint.Get();
}

} // namespace

FScenePackContext MakePackContext(const FConfig& Config, const FIntRect& ViewRect)
{
	return {static_cast<float>(Config.View.PreExposure.Value), ViewRect.Size(), Config.Scene.Units};
}

FRunObserver::FRunObserver(
	const FRunOptions& InOptions, const FRunSetup& InSetup, FSceneFile& InScene, FRunResult& InResult)
	: Options(InOptions)
	, Setup(InSetup)
	, Scene(InScene)
	, Result(InResult)
{
}

void FRunObserver::OnGraphCompiled(const FRDGCompiledGraph& Graph)
{
	Result.Graph = Graph;
	ToExecute.clear();
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		if (!Pass.bCulled && !Pass.bIsSentinel)
		{
			ToExecute.push_back(static_cast<size_t>(Pass.Index));
		}
		for (const FRDGUse& Use : Pass.Uses)
		{
			if (Use.IsWrite())
			{
				Scene.ForgetKept(Graph.Resources[static_cast<size_t>(Use.Resource)].Name);
			}
		}
	}
	ReportProgress();
}

bool FRunObserver::WantsPlannedExternals() const
{
	return Options.bPlanLoads;
}

bool FRunObserver::WantsZeroedTextures() const
{
	return !Setup.Dump.empty() || Options.bFingerprints || Options.bKeepForReport || Options.OnPassExecuted;
}

bool FRunObserver::OnTextureMade(FRHITexture& Texture)
{
	return Options.bFollowUnwritten && Unwritten.OnTextureMade(Texture);
}

void FRunObserver::OnPassPlanned(int32_t PassIndex, const FRDGPass& Pass)
{
	if (Options.bPassValues || Options.bKeepForReport)
	{
		Result.PassValues[PassIndex] = ReadPassValues(Pass);
	}
}

void FRunObserver::OnExternalsPlanned(const std::vector<FRDGExternalLoad>& Loads)
{
	Scene.Plan(FindNeeded(Loads));
	ReportAbsent(Loads);
}

void FRunObserver::OnLoadExternals(const std::vector<FRDGExternalLoad>& Loads)
{
	const auto Begin = std::chrono::steady_clock::now();
	const std::vector<FNeededSceneTexture> Needed = FindNeeded(Loads);
	Scene.Load(Needed, MakePackContext(Setup.Config, Result.ViewRect));
	Result.Times.Load += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
	ReportAbsent(Loads);
	for (const FNeededSceneTexture& Texture : Needed)
	{
		FRHITexture* const Loaded = Scene.GetTexture(Texture.Texture);
		// A texture that may be read is announced again once it is.
		const bool bKept = std::any_of(Result.Dumps.begin(), Result.Dumps.end(),
			[&](const FRunDump& Dump) { return Dump.PassIndex == 0 && Dump.Resource == Texture.Texture; });
		if (Loaded != nullptr && !bKept && IsDumped(Setup.Dump, "External", Texture.Texture))
		{
			KeepTexture(0, "External", Texture.Texture, *Loaded, GetWholeMips(*Loaded));
		}
	}
}

void FRunObserver::OnPassExecuted(int32_t PassIndex, const FRDGPass& Pass, double Milliseconds,
	const FPassCounters& Counters, const std::vector<FRDGTexture*>& WrittenTextures)
{
	Unwritten.OnPassExecuted(Pass.GetName(), Pass.GetOwner().IsForeign(), Counters, WrittenTextures);
	Result.Passes.push_back({PassIndex, Milliseconds, Counters});
	Result.Passes.back().Taps = CountTaps(Pass, Counters);
	OnPassPlanned(PassIndex, Pass);
	NoteSilence(Pass, Counters, WrittenTextures);
	if (!Setup.Dump.empty() || Options.bKeepForReport || Options.OnPassExecuted)
	{
		NoteDrawn(Pass, Counters, WrittenTextures);
	}
	if (Options.OnPassExecuted)
	{
		TellWrites(PassIndex, Pass, WrittenTextures);
	}
	// Looking costs as much as the pass, so only a scene that holds such values is looked at.
	const bool bWatch = !Scene.GetNonFinite().empty() && GetNonFinitePolicy() == ENonFinitePolicy::Propagate;
	for (FRDGTexture* Texture : WrittenTextures)
	{
		if (bWatch)
		{
			AddFootprint(Result.NonFinite, CountNonFinitePixels(Pass, *Texture));
		}
		if (Options.bFingerprints)
		{
			Result.Passes.back().Written.push_back({Texture->Name, FingerprintTexture(*Texture->GetRHI())});
		}
		if (IsDumped(Setup.Dump, Pass.GetName(), Texture->Name))
		{
			KeepTexture(PassIndex, Pass.GetName(), Texture->Name, *Texture->GetRHI(), Drawn[Texture]);
		}
		else if (Options.bKeepForReport)
		{
			Result.Passes.back().Thumbnails.push_back(
				MakeThumbnail(Texture->Name, *Texture->GetRHI(), Drawn[Texture].front()));
		}
	}
	ReportProgress();
}

void FRunObserver::NoteSilence(
	const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& WrittenTextures)
{
	const std::optional<FSilentPass> Silent = FindSilentPass(Pass, Counters, WrittenTextures);
	if (!Silent)
	{
		return;
	}
	Result.Passes.back().SameAs = Silent->Input;
	Result.Passes.back().SameBecause = Silent->Because;
	Result.Diagnostics.push_back({.Severity = ESeverity::Note,
		.Code = NoteSilentPass,
		.Message = DescribeSilentPass(*Silent),
		.Where = std::string("pass ") + Pass.GetName()});
}

void FRunObserver::TellWrites(int PassIndex, const FRDGPass& Pass, const std::vector<FRDGTexture*>& WrittenTextures)
{
	FPassWrites Writes{PassIndex, Pass, Result.Graph, {}};
	for (FRDGTexture* Texture : WrittenTextures)
	{
		const std::vector<FIntRect>& Windows = Drawn[Texture];
		for (size_t Mip = 0; Mip < Windows.size(); ++Mip)
		{
			Writes.Mips.push_back(
				{Texture->Name, Texture->GetRHI(), static_cast<int>(Mip), Texture->IsExternal(), Windows[Mip]});
		}
	}
	Options.OnPassExecuted(Writes);
}

void FRunObserver::NoteDrawn(
	const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& WrittenTextures)
{
	for (FRDGTexture* Texture : WrittenTextures)
	{
		FRHITexture& RHITexture = *Texture->GetRHI();
		const std::vector<FIntRect> Whole = GetWholeMips(RHITexture);
		const auto [Known, bNew] = Drawn.try_emplace(Texture, Whole.size());
		std::vector<FIntRect>& Rects = Known->second;
		const auto Add = [&Rects](int32 Mip, const FIntRect& Rect)
		{
			FIntRect& Sum = Rects[static_cast<size_t>(Mip)];
			if (Sum.Area() == 0)
			{
				Sum = Rect;
			}
			else
			{
				Sum.Union(Rect);
			}
		};

		bool bNoted = false;
		for (const FTextureWrite& Write : Counters.Writes)
		{
			if (Write.Texture == &RHITexture)
			{
				bNoted = true;
				Add(Write.Mip, Write.Rect);
			}
		}
		const TOptional<FIntRect> Output = FindOutputRect(Pass, Texture->Desc.Extent);
		if (!bNoted && Output.IsSet() && Whole.size() == 1)
		{
			Add(0, Output.GetValue());
		}
		// A texture from outside holds something everywhere.
		else if (!bNoted || (bNew && Texture->IsExternal()))
		{
			Rects = Whole;
		}
	}
}

std::vector<FNeededSceneTexture> FRunObserver::FindNeeded(const std::vector<FRDGExternalLoad>& Loads) const
{
	std::vector<FNeededSceneTexture> Needed;
	for (const FRDGExternalLoad& Load : Loads)
	{
		Needed.push_back({Load.Texture->Name, Load.Pass->GetName(), Load.bIsRead});
	}
	for (const FScenePacking& Packing : GetScenePackings())
	{
		if (Options.bNoSkip)
		{
			Needed.push_back({Packing.Name, "", false});
		}
	}
	return Needed;
}

void FRunObserver::ReportAbsent(const std::vector<FRDGExternalLoad>& Loads)
{
	// Their replacements, as in the engine (SceneTextureParameters.cpp).
	const std::pair<const char*, const char*> StandIns[] = {
		{"DepthDummy", "customdepth.Z"}, {"StencilDummy", "customstencil.ID"}};
	for (const FRDGExternalLoad& Load : Loads)
	{
		for (const auto& [Texture, Channel] : StandIns)
		{
			const std::string Name = Channel;
			if (!Load.bIsRead || Load.Texture->Name != std::string(Texture))
			{
				continue;
			}
			const std::string Message =
				"the shader reads custom " + Name.substr(6, Name.find('.') - 6) + ", and the scene has no channel \"" +
				Name + "\": there is none anywhere; map it in scene.channels ({\"" + Name +
				"\": \"name in the file\"}) or give it a value in scene.defaults ({\"" + Name + "\": 1})";
			Result.Diagnostics.push_back({.Severity = ESeverity::Warning,
				.Code = WarnNoCustomDepth,
				.Message = Message,
				.Where = std::string("pass ") + Load.Pass->GetName()});
		}
	}
}

void FRunObserver::KeepTexture(int PassIndex, const std::string& Pass, const std::string& Resource,
	FRHITexture& Texture, const std::vector<FIntRect>& Windows)
{
	const int NumMips = static_cast<int>(Texture.GetNumMips());
	for (int Mip = 0; Mip < NumMips; ++Mip)
	{
		FRunDump Dump{PassIndex, Pass, Resource, NumMips > 1 ? Mip : -1, FPicture::Copy(Texture, Mip), {}, {}};
		const FIntRect Whole(0, 0, Dump.Image.Width, Dump.Image.Height);
		Dump.Window = Windows[static_cast<size_t>(Mip)];
		Dump.Window.Clip(Whole);
		if (Dump.Window.Area() == 0) // a mip that nobody has drawn yet: a file without pixels there cannot be
		{
			Dump.Window = Whole;
		}
		Dump.Channels = GetChannelNames(Dump.Image.NumChannels);
		Result.Dumps.push_back(std::move(Dump));
	}
}

void FRunObserver::KeepAssets()
{
	for (const FAssetTarget& Asset : GetAssetTargets(Setup.Config))
	{
		const FTextureRenderTargetResource* const Resource =
			Asset.Target != nullptr ? Asset.Target->GetRenderTargetResource() : nullptr;
		if (Resource == nullptr)
		{
			Result.Diagnostics.push_back({.Severity = ESeverity::Note,
				.Code = NoteAssetUnused,
				.Message = "nothing asks for the render target " + Asset.Name,
				.Where = "/assets/" + Asset.Name});
			continue;
		}
		FRHITexture& Texture = *Resource->GetRenderTargetTexture();
		KeepTexture(
			static_cast<int>(Result.Graph.Passes.size()) - 1, "Assets", Asset.Name, Texture, GetWholeMips(Texture));
	}
}

void FRunObserver::ReportProgress() const
{
	if (!Options.Progress)
	{
		return;
	}
	const size_t NumDone = Result.Passes.size();
	Options.Progress(static_cast<int>(NumDone), static_cast<int>(ToExecute.size()),
		NumDone < ToExecute.size() ? Result.Graph.Passes[ToExecute[NumDone]].Name : "");
}

} // namespace Drydock
