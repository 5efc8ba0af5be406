// Makes the keys of draws and dispatches, and moves their results.
#include "DispatchReuse.h"

#include "DispatchBackend.h"
#include "DispatchObserver.h"
#include "PixelFormatConversion.h"
#include "RunningCode.h"

#include <algorithm>

namespace Drydock
{

namespace
{

FReuseCache* GReuseCache = nullptr;

size_t GetTexelBytes(ETexelStorage Storage)
{
	return size_t(GetTexelStorageInfo(Storage).BytesPerTexel);
}

FTexelBlock MakeBlock(const FKernelMip& Mip, size_t TexelBytes, const FIntRect& Rect)
{
	return {Mip.Data + Rect.Min.Y * int64(Mip.RowPitch) + Rect.Min.X * int64(TexelBytes),
		size_t(Rect.Width()) * TexelBytes, Rect.Height(), Mip.SizeZ, Mip.RowPitch, Mip.SlicePitch};
}

FIntRect GetRect(const FKernelMip& Mip)
{
	return FIntRect(0, 0, Mip.SizeX, Mip.SizeY);
}

FTexelBlock MakeBlock(const FKernelBuffer& Buffer)
{
	return {Buffer.Data, Buffer.SizeInBytes, 1, 1, 0, 0};
}

/** The view, and its texels if they count. */
void AddView(FMemoryHasher& Hasher, const FKernelTexture& View, FRHITexture* Texture, bool bContents)
{
	Hasher.Add(View.Storage);
	Hasher.Add(View.bIs3D);
	Hasher.Add(View.bSaturateStore);
	for (int32 Level = 0; Level < View.NumMips; ++Level)
	{
		const FKernelMip& At = View.Mips[Level];
		Hasher.Add(At.SizeX);
		Hasher.Add(At.SizeY);
		Hasher.Add(At.SizeZ);
		int32 Mip, Plane;
		if (!bContents || !At.Data)
		{
			continue;
		}
		if (Texture && Texture->FindMip(At.Data, Mip, Plane))
		{
			Hasher.Add(Texture->GetMipHash(Mip, Plane));
			Hasher.Add(At.Data - Texture->GetTexelToRead(0, 0, Mip, 0, Plane)); // which slices
		}
		else
		{
			Hasher.Add(HashTexels(MakeBlock(At, GetTexelBytes(View.Storage), GetRect(At))));
		}
	}
}

void AddBuffer(FMemoryHasher& Hasher, const FKernelBuffer& Buffer)
{
	Hasher.Add(Buffer.Stride);
	Hasher.Add(Buffer.Storage);
	Hasher.Add(HashTexels(MakeBlock(Buffer)));
}

void AddSampler(FMemoryHasher& Hasher, const FKernelSampler& Sampler)
{
	Hasher.Add(Sampler.Filter);
	Hasher.Add(Sampler.AddressU);
	Hasher.Add(Sampler.AddressV);
	Hasher.Add(Sampler.AddressW);
	Hasher.Add(Sampler.SampleBits);
	Hasher.Add(Sampler.MipBias);
	Hasher.Add(Sampler.Border, sizeof(Sampler.Border));
	Hasher.Add(Sampler.Compare);
	Hasher.Add(Sampler.MinLevel);
	Hasher.Add(Sampler.MaxLevel);
}

void AddTarget(FMemoryHasher& Hasher, const FKernelTarget& Target)
{
	Hasher.Add(Target.WriteMask);
	Hasher.Add(Target.bBlend);
	Hasher.Add(Target.ColorOp);
	Hasher.Add(Target.ColorSource);
	Hasher.Add(Target.ColorDest);
	Hasher.Add(Target.AlphaOp);
	Hasher.Add(Target.AlphaSource);
	Hasher.Add(Target.AlphaDest);
}

/** Every texel of the mip gets another value, whatever it held. */
bool IsOverwritten(
	const FKernelTarget& Target, const FBoundShader& Shader, const FKernelTile& Whole, const FRHITexture* Texture)
{
	constexpr uint8 AllChannels = 15;
	const FKernelMip& At = Target.Texture.Mips[0];
	return Texture && !Target.bBlend && Target.WriteMask == AllChannels && !Shader.GetReflection().bUsesDiscard &&
		   Texture->GetMipLayout(0).SizeZ == 1 && Whole.MinX == 0 && Whole.MinY == 0 && Whole.MaxX == At.SizeX &&
		   Whole.MaxY == At.SizeY;
}

template<typename T>
T* GetAt(const std::vector<T*>& List, size_t Index)
{
	return Index < List.size() ? List[Index] : nullptr;
}

std::string FindWhyNot(const FBoundShader& Shader, bool bForeignOutput)
{
	for (const IDispatchObserver* const Observer : GetDispatchObservers())
	{
		if (!Observer->AllowsReuse())
		{
			return "somebody looks into shaders while they run";
		}
	}
	return Shader.Key.empty()                        ? "the shader has no key"
		   : bForeignOutput                          ? "it writes a texture that is not known"
		   : Shader.Native && IsForeignCodeRunning() ? "a plugin's hand-written kernel may read anything"
		   : !Shader.Native && GetDispatchBackend()  ? "another device runs it"
													 : std::string();
}

} // namespace

FReuseCache* GetReuseCache()
{
	return GReuseCache;
}

FScopedReuse::FScopedReuse(FReuseCache* Cache)
	: Before(std::exchange(GReuseCache, Cache))
{
}

FScopedReuse::~FScopedReuse()
{
	GReuseCache = Before;
}

FReuseCache::FResult* FReuseCache::Find(const FMemoryHash& Key)
{
	const auto Known = ByKey.find(Key);
	if (Known == ByKey.end())
	{
		return nullptr;
	}
	Results.splice(Results.begin(), Results, Known->second);
	Known->second->LastFrame = Frame;
	return &*Known->second;
}

void FReuseCache::BeginFrame()
{
	++Frame;
	while (!Results.empty() && Results.back().LastFrame + KeptFrames < Frame)
	{
		RemoveOldest();
	}
}

void FReuseCache::RemoveOldest()
{
	Bytes -= Results.back().NumBytes;
	ByKey.erase(Results.back().Key);
	Results.pop_back();
}

FReuseCache::FResult* FReuseCache::Add(const FMemoryHash& Key, uint64 NumBytes)
{
	while (!Results.empty() && Bytes + NumBytes > MaxBytes && Results.back().LastFrame < Frame)
	{
		RemoveOldest();
	}
	if (Bytes + NumBytes > MaxBytes || ByKey.contains(Key))
	{
		return nullptr;
	}
	std::list<FResult> New(1);
	FResult& Result = New.front();
	Result.Key = Key;
	Result.NumBytes = NumBytes;
	Result.LastFrame = Frame;
	try
	{
		Result.Written.Ensure(size_t(NumBytes));
	}
	catch (const std::bad_alloc&)
	{
		return nullptr;
	}
	ByKey.emplace(Key, New.begin());
	Results.splice(Results.begin(), New);
	Bytes += NumBytes;
	return &Result;
}

FDispatchReuse::FDispatchReuse(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
	const std::vector<FRHITexture*>& Targets)
{
	FindOutputs(Shader, Args, Whole, Targets);
	if (Cache)
	{
		WhyNot = FindWhyNot(Shader, bForeignOutput);
		if (WhyNot.empty())
		{
			FindKey(Shader, Args, Whole, Targets);
		}
	}
	// The hashes of its outputs hold no longer, taken or run.
	for (const FOutput& Output : Outputs)
	{
		if (Output.Texture)
		{
			Output.Texture->SetMipHash(Output.Mip, Output.Plane, FMemoryHash());
		}
	}
	if (bForeignOutput)
	{
		FRHITexture::ForgetMipHashes();
	}
}

void FDispatchReuse::AddMip(const FKernelMip& Mip, size_t TexelBytes, const FIntRect& Rect, FRHITexture* Texture)
{
	int32 Number, Plane;
	if (!Texture || !Texture->FindMip(Mip.Data, Number, Plane))
	{
		bForeignOutput = true;
		return;
	}
	Outputs.push_back({MakeBlock(Mip, TexelBytes, Rect), Texture, Number, Plane});
}

void FDispatchReuse::FindOutputs(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
	const std::vector<FRHITexture*>& Targets)
{
	for (int32 Index = 0; Index < Args.NumTargets; ++Index)
	{
		const FKernelTexture& View = Args.Targets[Index].Texture;
		if (Args.Targets[Index].WriteMask != 0 && View.Mips[0].Data)
		{
			FIntRect Rect(Whole.MinX, Whole.MinY, Whole.MaxX, Whole.MaxY);
			Rect.Clip(GetRect(View.Mips[0]));
			AddMip(View.Mips[0], GetTexelBytes(View.Storage), Rect, GetAt(Targets, size_t(Index)));
		}
	}
	for (size_t Slot = 0; Slot < Shader.RWTextures.size(); ++Slot)
	{
		const FKernelTexture& View = Shader.RWTextures[Slot];
		for (int32 Level = 0; Level < View.NumMips; ++Level)
		{
			const FKernelMip& Mip = View.Mips[Level];
			AddMip(Mip, GetTexelBytes(View.Storage), GetRect(Mip), GetAt(Shader.RWTextureOwners, Slot));
		}
	}
	for (const FKernelBuffer& Buffer : Shader.RWBuffers)
	{
		Outputs.push_back({MakeBlock(Buffer)});
	}
}

void FDispatchReuse::FindKey(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
	const std::vector<FRHITexture*>& Targets)
{
	FMemoryHasher Hasher;
	Hasher.Add(Shader.Key.data(), Shader.Key.size());
	Hasher.Add(Shader.EntryPoint.data(), Shader.EntryPoint.size());
	Hasher.Add(Shader.bDouble);
	Hasher.Add(reinterpret_cast<const void*>(Shader.Native)); // drydock's own, which stay where they are
	Hasher.Add(Args.Limits ? Args.Limits->LoopTurns : 0u);
	for (const int32 Edge : {Whole.MinX, Whole.MinY, Whole.MinZ, Whole.MaxX, Whole.MaxY, Whole.MaxZ})
	{
		Hasher.Add(Edge);
	}
	for (const std::vector<uint8>& Constants : Shader.ConstantData)
	{
		Hasher.Add(Constants.data(), Constants.size());
	}
	for (const FKernelSampler& Sampler : Shader.Samplers)
	{
		AddSampler(Hasher, Sampler);
	}
	for (size_t Slot = 0; Slot < Shader.Textures.size(); ++Slot)
	{
		AddView(Hasher, Shader.Textures[Slot], GetAt(Shader.TextureOwners, Slot), true);
	}
	for (size_t Slot = 0; Slot < Shader.RWTextures.size(); ++Slot)
	{
		AddView(Hasher, Shader.RWTextures[Slot], GetAt(Shader.RWTextureOwners, Slot), true);
	}
	for (const std::vector<FKernelBuffer>* const Buffers : {&Shader.Buffers, &Shader.RWBuffers})
	{
		std::ranges::for_each(*Buffers, [&](const FKernelBuffer& Buffer) { AddBuffer(Hasher, Buffer); });
	}
	for (int32 Index = 0; Index < Args.NumTargets; ++Index)
	{
		const FKernelTarget& Target = Args.Targets[Index];
		FRHITexture* const Texture = GetAt(Targets, size_t(Index));
		AddTarget(Hasher, Target);
		AddView(Hasher, Target.Texture, Texture, !IsOverwritten(Target, Shader, Whole, Texture));
	}
	if (Args.Interpolants)
	{
		Hasher.Add(Args.Interpolants, size_t(Shader.GetReflection().NumInterpolants) * sizeof(FKernelInterpolant));
	}
	Key = Hasher.Get();
}

std::optional<FDispatchReuse::FRun> FDispatchReuse::Take()
{
	const FReuseCache::FResult* const Result = Key.IsKnown() ? Cache->Find(Key) : nullptr;
	if (!Result)
	{
		return {};
	}
	const uint8* Kept = Result->Written.Get();
	for (const FOutput& Output : Outputs)
	{
		RestoreTexels(Output.Block, Kept);
		Kept += Output.Block.GetNumBytes();
	}
	for (size_t Index = 0; Index < Outputs.size(); ++Index)
	{
		if (Outputs[Index].Texture)
		{
			Outputs[Index].Texture->SetMipHash(Outputs[Index].Mip, Outputs[Index].Plane, Result->MipsAfter[Index]);
		}
	}
	return FRun{Result->Taps, Result->bFellBack};
}

void FDispatchReuse::Keep(const FRun& Run)
{
	uint64 NumBytes = 0;
	for (const FOutput& Output : Outputs)
	{
		NumBytes += Output.Block.GetNumBytes();
	}
	FReuseCache::FResult* const Result = Key.IsKnown() ? Cache->Add(Key, NumBytes) : nullptr;
	if (!Result)
	{
		WhyNot = Key.IsKnown() ? "there is no memory for its result" : WhyNot;
		return;
	}
	Result->Taps = Run.Taps;
	Result->bFellBack = Run.bFellBack;
	uint8* Kept = Result->Written.Get();
	for (const FOutput& Output : Outputs)
	{
		SaveTexels(Output.Block, Kept);
		Kept += Output.Block.GetNumBytes();
		Result->MipsAfter.push_back(
			Output.Texture ? Output.Texture->GetMipHash(Output.Mip, Output.Plane) : FMemoryHash());
	}
}

} // namespace Drydock
