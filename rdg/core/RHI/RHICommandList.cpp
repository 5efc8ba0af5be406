// Dispatches, draws, clears and copies. Source: engine RHICommandList.h for meaning; the execution is drydock's.
#include "RHICommandList.h"

#include "BoundBytes.h"
#include "CodeScope.h"
#include "DispatchBackend.h"
#include "DispatchObserver.h"
#include "DispatchReuse.h"
#include "KernelWatch.h"
#include "Math/ToInteger.h"
#include "NativeFallback.h"
#include "PixelFormatConversion.h"
#include "TextureTransfer.h"
#include "TileExecutor.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

namespace
{

using Drydock::FKernelTile;

// Wide, so that lanes are full; low, so that a small target still makes tiles for every thread.
constexpr int32 GTileSizeX = 256;
constexpr int32 GTileSizeY = 16;

/** Taller and wider tiles, in multiples, where each thread still has its share of them: shaders learn once a tile where
 * their samples lie, native kernels decode what lies beside it, and rows that go on are what the processor reads
 * ahead. */
FIntPoint ChooseTileSize(const FKernelTile& Whole)
{
	constexpr int32 Widest = 8 * GTileSizeX;
	constexpr int32 Tall = 4 * GTileSizeY;
	constexpr int64 TilesPerThread = 4;
	const int32 NumThreads = Drydock::GetNumThreads();
	const int64 Rows = FMath::DivideAndRoundUp(Whole.MaxY - Whole.MinY, Tall);
	for (int32 Wide = Widest; Wide >= GTileSizeX; Wide /= 2)
	{
		const int64 Columns = FMath::DivideAndRoundUp(Whole.MaxX - Whole.MinX, Wide);
		if (NumThreads == 1 || Columns * Rows >= TilesPerThread * NumThreads)
		{
			return FIntPoint(Wide, Tall);
		}
	}
	return FIntPoint(GTileSizeX, GTileSizeY);
}

int32 RoundUp(int32 Value, int32 Multiple)
{
	return (Value + Multiple - 1) / Multiple * Multiple;
}

/** Runs all of Whole on the device that r.Drydock.Backend chooses; false: kernels have to run it. */
bool RunOnBackend(const Drydock::FBoundShader& Shader, const Drydock::FKernelArgs& Args, const FKernelTile& Whole,
	Drydock::FPassCounters& Counters)
{
	Drydock::IDispatchBackend* const Backend = Shader.Native ? nullptr : Drydock::GetDispatchBackend();
	if (!Backend)
	{
		return false;
	}
	const std::string Fault = Backend->Run(Shader, Args, Whole);
	if (!Fault.empty())
	{
		Counters.AddRemark({Drydock::ESeverity::Warning, 6071,
			Shader.Name + " runs on the CPU and not on " + Backend->GetDeviceName() + ": " + Fault, {}, 0, 0,
			"entry point " + Shader.EntryPoint});
	}
	return Fault.empty();
}

FIntRect GetMipRect(const FRHITexture& Texture, int32 Mip)
{
	const Drydock::FTextureMipLayout& At = Texture.GetMipLayout(Mip);
	return FIntRect(0, 0, At.SizeX, At.SizeY);
}

/** Texels of the destination that a copy writes, of the mip that is this many after its first. */
FIntRect GetCopiedRect(const FRHITexture& Source, const FRHICopyTextureInfo& Info, uint32 Mip)
{
	const bool bWhole = Info.Size.X == 0 && Info.Size.Y == 0 && Info.Size.Z == 0;
	const Drydock::FTextureMipLayout& At = Source.GetMipLayout(int32(Info.SourceMipIndex + Mip));
	const FIntPoint Size =
		bWhole ? FIntPoint(At.SizeX - (Info.SourcePosition.X >> Mip), At.SizeY - (Info.SourcePosition.Y >> Mip))
			   : FIntPoint(std::max(Info.Size.X >> Mip, 1), std::max(Info.Size.Y >> Mip, 1));
	const FIntPoint Min(Info.DestPosition.X >> Mip, Info.DestPosition.Y >> Mip);
	return FIntRect(Min, Min + Size);
}

} // namespace

void FRHIComputeCommandList::SetComputePipelineState(FRHIComputeShader* Shader)
{
	BoundCompute = Drydock::FBoundShader();
	ComputeShader = Shader;
}

void FRHIComputeCommandList::SetBoundComputeShader(Drydock::FBoundShader&& Shader)
{
	BoundCompute = std::move(Shader);
}

void FRHIComputeCommandList::DispatchComputeShader(
	uint32 ThreadGroupCountX, uint32 ThreadGroupCountY, uint32 ThreadGroupCountZ)
{
	Drydock::BindIfNothingIs(BoundCompute, ComputeShader);
	checkf(BoundCompute.IsValid(), TEXT("DispatchComputeShader without a shader: call SetShaderParameters first"));
	checkf(BoundCompute.GetReflection().Stage == Drydock::EShaderStage::Compute,
		TEXT("DispatchComputeShader: %s is not a compute shader"), BoundCompute.Name.c_str());
	const int32* const GroupSize = BoundCompute.GetReflection().GroupSize;
	const uint32 Counts[3] = {ThreadGroupCountX, ThreadGroupCountY, ThreadGroupCountZ};
	for (int32 Axis = 0; Axis < 3; ++Axis)
	{
		checkf(Counts[Axis] <= 65535, TEXT("%s: %u thread groups; 65535 is the most per axis"),
			BoundCompute.Name.c_str(), Counts[Axis]);
	}

	const FKernelTile Whole = {
		0, 0, 0, int32(Counts[0]) * GroupSize[0], int32(Counts[1]) * GroupSize[1], int32(Counts[2]) * GroupSize[2]};
	const uint64 NumThreads = uint64(Whole.MaxX) * uint64(Whole.MaxY) * uint64(Whole.MaxZ);
	if (NumThreads == 0)
	{
		return;
	}
	if (const std::string Fault = Drydock::FindTooManyGroups(BoundCompute, Counts); !Fault.empty())
	{
		Counters.AddRemark({Drydock::ESeverity::Note, 2056, Fault, {}, 0, 0, "shader class " + BoundCompute.Name});
	}
	// Whole groups per tile: threads of one group share a tile.
	const FIntPoint Chosen = ChooseTileSize(Whole);
	const FIntVector TileSize(RoundUp(Chosen.X, GroupSize[0]), RoundUp(Chosen.Y, GroupSize[1]), GroupSize[2]);
	RunTiles(BoundCompute, BoundCompute.GetArgs(), Whole,
		BoundCompute.GetReflection().bGroupsInOrder ? FIntVector(Whole.MaxX, Whole.MaxY, Whole.MaxZ) : TileSize);
	Counters.BytesWritten += Drydock::GetBytesBoundForWriting(BoundCompute, NumThreads);
}

void FRHIComputeCommandList::DispatchIndirectComputeShader(FRHIBuffer* ArgumentBuffer, uint32 ArgumentOffset)
{
	uint32 Counts[3];
	std::memcpy(Counts, LockBuffer(ArgumentBuffer, ArgumentOffset, sizeof(Counts), RLM_ReadOnly), sizeof(Counts));
	DispatchComputeShader(Counts[0], Counts[1], Counts[2]);
}

void FRHIComputeCommandList::RunTiles(const Drydock::FBoundShader& Shader, Drydock::FKernelArgs Args,
	const FKernelTile& Whole, FIntVector TileSize, const std::vector<FRHITexture*>& Targets)
{
	Drydock::RequireAllSet(Shader);
	// Behind an early return, as every compute shader has one, only who runs the shader knows how many threads tap.
	const int32 StaticSamples = Shader.GetReflection().StaticSamples;
	const bool bMeasure = StaticSamples < 0 && !Shader.Native;
	std::atomic<uint64> MeasuredTaps{0};
	const uint64 FallbacksBefore = Drydock::GetNativeFallbacks();
	bool bOnBackend = false;
	const std::vector<Drydock::IDispatchObserver*>& Observers = Drydock::GetDispatchObservers();
	for (Drydock::IDispatchObserver* const Observer : Observers)
	{
		Observer->BeforeDispatch(Shader, Args, Whole);
	}
	Drydock::FDispatchReuse Reuse(Shader, Args, Whole, Targets);
	std::optional<Drydock::FDispatchReuse::FRun> Run = Reuse.Take();
	++Counters.Dispatches;
	Counters.Reused += Run ? 1 : 0;
	if (!Run)
	{
		// Compiled by drydock: a fault inside a kernel is not the fault of its caller.
		const Drydock::FCodeOwner* const Caller = Drydock::GetRunningCode();
		const Drydock::FCodeOwner Kernel{
			.Callback = "shader " + Shader.Name, .Pass = Caller ? Caller->Pass : std::string()};
		const Drydock::FCodeScope Scope(Kernel);
		Drydock::FKernelWatch Watch(Shader.Name, Shader.EntryPoint);
		const auto RunTile = [&](const FKernelTile& Tile)
		{
			Drydock::FKernelCounters TileCounters{};
			Drydock::FKernelArgs TileArgs = Args;
			TileArgs.Counters = bMeasure ? &TileCounters : nullptr;
			Shader.Run(TileArgs, Tile);
			Watch.TileHasEnded();
			MeasuredTaps.fetch_add(TileCounters.Samples + TileCounters.Loads, std::memory_order_relaxed);
		};
		bOnBackend = RunOnBackend(Shader, Args, Whole, Counters);
		if (!bOnBackend)
		{
			Drydock::ForEachTile(
				Whole, TileSize, RunTile, Shader.bDouble ? Drydock::EDenormals::Keep : Drydock::EDenormals::Flush);
		}
		Run = {MeasuredTaps, Drydock::GetNativeFallbacks() != FallbacksBefore};
		Reuse.Keep(*Run);
		Counters.NotReusable = Reuse.GetWhyNot();
	}
	for (auto Observer = Observers.rbegin(); Observer != Observers.rend(); ++Observer)
	{
		(*Observer)->AfterDispatch(Shader, Args, Whole);
	}

	const uint64 Pixels =
		uint64(Whole.MaxX - Whole.MinX) * uint64(Whole.MaxY - Whole.MinY) * uint64(Whole.MaxZ - Whole.MinZ);
	Counters.Shader = Shader.Name;
	Counters.Entry = Shader.EntryPoint;
	Counters.Ran |= bOnBackend      ? Drydock::EShaderRun::Backend
					: Shader.Native ? Drydock::EShaderRun::NativeKernel
									: Drydock::EShaderRun::Shader;
	if (Run->bFellBack)
	{
		Counters.Ran |= Drydock::EShaderRun::Shader;
	}
	if (!Shader.Edited.empty())
	{
		Counters.AddRemark({Drydock::ESeverity::Note, 6080,
			"edited (the file, or one that it includes): runs as a shader; the hand-written kernel of the class is for "
			"the text as shipped",
			Shader.Edited, 0, 0, "shader class " + Shader.Name});
	}
	if (!Shader.GetReflection().PartedBarrier.empty())
	{
		Counters.AddRemark({Drydock::ESeverity::Warning, 6022,
			"not all threads of a group come to the barrier of " + Shader.GetReflection().PartedBarrier +
				": a branch, a loop or an early return parts them; this is undefined on GPUs, and here the others go "
				"on",
			{}, 0, 0, "shader class " + Shader.Name});
	}
	Counters.Pixels += Pixels;
	Counters.Taps += StaticSamples >= 0 ? Pixels * uint64(StaticSamples) : Run->Taps;
	Counters.TapCount = std::max(Counters.TapCount, StaticSamples >= 0        ? Drydock::ETapCount::Static
													: bMeasure && !bOnBackend ? Drydock::ETapCount::Measured
																			  : Drydock::ETapCount::Unknown);
	Counters.BytesRead += Drydock::GetBytesBoundForReading(Shader);
}

void FRHIComputeCommandList::ClearUAVFloat(FRHIUnorderedAccessView* View, const FVector4f& Value)
{
	Counters.Pixels += Drydock::ClearView(View, Value);
	NoteCleared(View);
}

void FRHIComputeCommandList::ClearUAVUint(FRHIUnorderedAccessView* View, const FUintVector4& Value)
{
	Counters.Pixels += Drydock::ClearView(View, Value);
	NoteCleared(View);
}

void FRHIComputeCommandList::NoteCleared(const FRHIUnorderedAccessView* View)
{
	Counters.BytesWritten += View->GetSizeInBytes();
	if (const FRHITexture* const Texture = View->GetTexture())
	{
		const int32 Mip = int32(View->GetFirstMip());
		Counters.AddWrite(Texture, Mip, GetMipRect(*Texture, Mip));
	}
}

void FRHICommandList::BeginRenderPass(const FRHIRenderPassInfo& Info, const TCHAR* Name)
{
	checkf(!bInsideRenderPass, TEXT("render pass %s begins inside another"), Name);
	RenderPass = Info;
	bInsideRenderPass = true;

	for (const FRHIRenderPassInfo::FColorEntry& Entry : Info.ColorRenderTargets)
	{
		if (Entry.RenderTarget && GetLoadAction(Entry.Action) == ERenderTargetLoadAction::EClear)
		{
			ClearTarget(Entry.RenderTarget, Entry.MipIndex, Entry.ArraySlice);
		}
	}
	FRHITexture* const Depth = Info.DepthStencilRenderTarget.DepthStencilTarget;
	const EDepthStencilTargetActions DepthStencilAction = Info.DepthStencilRenderTarget.Action;
	if (Depth)
	{
		float ClearDepth;
		uint32 ClearStencil;
		Depth->GetClearBinding().GetDepthStencil(ClearDepth, ClearStencil);
		const FIntRect Whole(FIntPoint(0, 0), Depth->GetSizeXY());
		if (GetLoadAction(GetDepthActions(DepthStencilAction)) == ERenderTargetLoadAction::EClear)
		{
			Depth->FillRect(&ClearDepth, Whole, 0);
			Counters.AddWrite(Depth, 0, Whole);
		}
		if (Depth->GetNumPlanes() > 1 &&
			GetLoadAction(GetStencilActions(DepthStencilAction)) == ERenderTargetLoadAction::EClear)
		{
			const uint8 Stencil = uint8(ClearStencil);
			Depth->FillRect(&Stencil, Whole, 0, -1, 1);
			Counters.AddWrite(Depth, 0, Whole);
		}
	}

	Viewport = FIntRect(0, 0, GMaxTextureDimensions, GMaxTextureDimensions);
	bScissor = false;
	Viewport = GetDrawRect();
}

void FRHICommandList::EndRenderPass()
{
	checkf(bInsideRenderPass, TEXT("EndRenderPass outside a render pass"));
	bInsideRenderPass = false;
	RenderPass = FRHIRenderPassInfo();
	Vertices = Drydock::FVertexState(); // whose buffers may be of this pass only
}

void FRHICommandList::ClearTarget(FRHITexture* Texture, int32 Mip, int32 Slice)
{
	checkf(Texture->HasClearValue(), TEXT("texture %s is cleared by its load action but has no clear value"),
		*Texture->GetName().ToString());
	const FLinearColor Color = Texture->GetClearColor();
	const float Channels[4] = {Color.R, Color.G, Color.B, Color.A};
	uint8 Texel[32];
	Drydock::EncodeTexel(Texture->GetStorage(), Channels, Texel, Drydock::IsStoreOverflowSaturated());
	const Drydock::FTextureMipLayout& At = Texture->GetMipLayout(Mip);
	Texture->FillRect(Texel, GetMipRect(*Texture, Mip), Mip, Slice);
	Counters.AddWrite(Texture, Mip, GetMipRect(*Texture, Mip));

	const uint64 Texels = uint64(At.SizeX) * uint64(At.SizeY) * (Slice < 0 ? uint64(At.SizeZ) : 1);
	Counters.BytesWritten += Texels * Drydock::GetTexelStorageInfo(Texture->GetStorage()).BytesPerTexel;
}

void FRHICommandList::ApplyCachedRenderTargets(FGraphicsPipelineStateInitializer& Initializer) const
{
	Initializer.RenderTargetsEnabled = uint32(RenderPass.GetNumColorRenderTargets());
	for (int32 Index = 0; Index < MaxSimultaneousRenderTargets; ++Index)
	{
		const FRHITexture* const Target = RenderPass.ColorRenderTargets[Index].RenderTarget;
		Initializer.RenderTargetFormats[Index] = Target ? Target->GetFormat() : PF_Unknown;
	}
	const FRHITexture* const Depth = RenderPass.DepthStencilRenderTarget.DepthStencilTarget;
	Initializer.DepthStencilTargetFormat = Depth ? Depth->GetFormat() : PF_Unknown;
}

void FRHICommandList::SetGraphicsPipelineState(const FGraphicsPipelineStateInitializer& Initializer, uint32)
{
	checkf(bInsideRenderPass, TEXT("SetGraphicsPipelineState outside a render pass"));
	checkf(Initializer.PrimitiveType != PT_LineList && Initializer.PrimitiveType != PT_PointList,
		TEXT("lines and points are not simulated: draws cover the viewport"));
	BlendState = Initializer.BlendState;
	DepthStencilState = Initializer.DepthStencilState;
	BoundPixel = Drydock::FBoundShader();
	PixelShader = Initializer.BoundShaderState.PixelShaderRHI;
	Vertices.SetPipeline(Initializer);
	Interpolants.clear();
}

void FRHICommandList::SetBoundPixelShader(Drydock::FBoundShader&& Shader)
{
	BoundPixel = std::move(Shader);
}

FRHIBatchedShaderParameters& FRHIComputeCommandList::GetScratchShaderParameters()
{
	ScratchShaderParameters.Reset();
	return ScratchShaderParameters;
}

void FRHIComputeCommandList::SetBatchedShaderParameters(FRHIComputeShader*, FRHIBatchedShaderParameters& Parameters)
{
	SetBoundComputeShader(std::exchange(Parameters.Bound, {}));
}

void FRHICommandList::SetBatchedShaderParameters(FRHIGraphicsShader* Shader, FRHIBatchedShaderParameters& Parameters)
{
	checkf(Shader != nullptr, TEXT("parameters of no shader"));
	if (Shader->GetFrequency() == SF_Vertex)
	{
		SetBoundVertexShader(std::exchange(Parameters.Bound, {}));
	}
	else
	{
		SetBoundPixelShader(std::exchange(Parameters.Bound, {}));
	}
}

void FRHICommandList::SetInterpolants(TConstArrayView<Drydock::FKernelInterpolant> InInterpolants)
{
	Interpolants.assign(InInterpolants.begin(), InInterpolants.end());
}

void FRHICommandList::SetViewport(float MinX, float MinY, float, float MaxX, float MaxY, float)
{
	const auto Round = [](float Edge)
	{
		constexpr int32 Farthest = 32767; // Direct3D's bounds of a viewport
		return Drydock::ToCount(std::floor(Edge + 0.5f), -Farthest - 1, Farthest);
	};
	Viewport = FIntRect(Round(MinX), Round(MinY), Round(MaxX), Round(MaxY));
}

void FRHICommandList::SetScissorRect(bool bEnable, uint32 MinX, uint32 MinY, uint32 MaxX, uint32 MaxY)
{
	bScissor = bEnable;
	Scissor = FIntRect(int32(MinX), int32(MinY), int32(MaxX), int32(MaxY));
}

void FRHICommandList::SetBlendFactor(const FLinearColor& BlendFactor)
{
	checkf(BlendFactor == FLinearColor(1, 1, 1, 1), TEXT("blend factors other than white are not simulated"));
}

void FRHICommandList::DrawRect(
	const FIntRect& Rect, const std::vector<Drydock::FKernelInterpolant>& Inputs, uint32 NumInstances)
{
	if (Rect.Width() <= 0 || Rect.Height() <= 0)
	{
		return;
	}
	const std::vector<Drydock::FKernelTarget> Targets = MakeTargets();
	const int32 NumBound = RenderPass.GetNumColorRenderTargets();
	if (const int32 NumWritten = BoundPixel.GetReflection().NumTargets; NumWritten > NumBound && NumBound > 0)
	{
		const std::string Last = std::to_string(NumWritten - 1);
		Counters.AddRemark({Drydock::ESeverity::Warning, 6023,
			"the shader writes SV_Target" + Last + ", and the pass binds " + std::to_string(NumBound) +
				(NumBound == 1 ? " render target" : " render targets") +
				": what it writes there is lost; set RenderTargets[" + Last + "]",
			{}, 0, 0, "shader class " + BoundPixel.Name});
	}
	Drydock::FKernelArgs Args = BoundPixel.GetArgs();
	Args.Targets = Targets.data();
	Args.NumTargets = int32(Targets.size());
	Args.Interpolants = Inputs.data();

	const FKernelTile Whole = {Rect.Min.X, Rect.Min.Y, 0, Rect.Max.X, Rect.Max.Y, 1};
	const uint64 Pixels = uint64(Rect.Width()) * uint64(Rect.Height());
	for (const FRHIRenderPassInfo::FColorEntry& Entry : RenderPass.ColorRenderTargets)
	{
		if (Entry.RenderTarget && NumInstances > 0)
		{
			Counters.AddWrite(Entry.RenderTarget, Entry.MipIndex, Rect);
		}
	}
	if (Targets.size() > size_t(Drydock::GDepthTarget) && NumInstances > 0)
	{
		Counters.AddWrite(RenderPass.DepthStencilRenderTarget.DepthStencilTarget, 0, Rect);
	}
	for (uint32 Instance = 0; Instance < NumInstances; ++Instance)
	{
		const FIntPoint TileSize = ChooseTileSize(Whole);
		RunTiles(BoundPixel, Args, Whole, FIntVector(TileSize.X, TileSize.Y, 1), GetTargetTextures());
		for (const Drydock::FKernelTarget& Target : Targets)
		{
			if (Target.WriteMask)
			{
				const uint64 Bytes = Pixels * Drydock::GetTexelStorageInfo(Target.Texture.Storage).BytesPerTexel;
				Counters.BytesWritten += Bytes;
				Counters.BytesRead += Target.bBlend ? Bytes : 0;
			}
		}
		Counters.BytesWritten += Drydock::GetBytesBoundForWriting(BoundPixel, Pixels);
	}
}

void FRHICommandList::CopyTexture(FRHITexture* Source, FRHITexture* Dest, const FRHICopyTextureInfo& Info)
{
	const uint64 Texels = Drydock::CopyTextureRegion(Source, Dest, Info);
	for (uint32 Mip = 0; Mip < Info.NumMips; ++Mip)
	{
		const int32 DestMip = int32(Info.DestMipIndex + Mip);
		Counters.AddWrite(Dest, DestMip, GetCopiedRect(*Source, Info, Mip));
	}
	const uint64 Bytes = Texels * Drydock::GetTexelStorageInfo(Source->GetStorage()).BytesPerTexel;
	Counters.Pixels += Texels;
	Counters.BytesRead += Bytes;
	Counters.BytesWritten += Bytes;
}

void FRHICommandList::CopyBufferRegion(
	FRHIBuffer* Dest, uint64 DestOffset, FRHIBuffer* Source, uint64 SourceOffset, uint64 NumBytes)
{
	check(Source && Dest);
	checkf(NumBytes <= Source->GetSize() && SourceOffset <= Source->GetSize() - NumBytes &&
			   NumBytes <= Dest->GetSize() && DestOffset <= Dest->GetSize() - NumBytes,
		TEXT("CopyBufferRegion goes beyond buffer %s or %s"), *Source->GetName().ToString(),
		*Dest->GetName().ToString());
	std::memmove(Dest->GetData() + DestOffset, Source->GetData() + SourceOffset, size_t(NumBytes));
	Counters.BytesRead += NumBytes;
	Counters.BytesWritten += NumBytes;
}

void FRHICommandListImmediate::ReadSurfaceData(
	FRHITexture* Texture, FIntRect Rect, TArray<FLinearColor>& OutData, FReadSurfaceDataFlags Flags)
{
	Drydock::ReadSurface(Texture, Rect, OutData, Flags);
}

void FRHICommandListImmediate::ReadSurfaceData(
	FRHITexture* Texture, FIntRect Rect, TArray<FColor>& OutData, FReadSurfaceDataFlags Flags)
{
	Drydock::ReadSurface(Texture, Rect, OutData, Flags);
}
