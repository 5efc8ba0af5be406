// Chooses the instruction set for a sum of taps, turns away what it cannot do, and keeps each thread's memory.
#include "Native/TapSum.h"

#include "Native/NativeLanes.h"
#include "PixelFormatConversion.h"
#include "Templates/UnrealTemplate.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace Drydock
{

namespace
{

constexpr std::align_val_t Alignment{64};

/** Zeros at first, so that no value read beside a row is a NaN by chance. */
class FTapMemory : private FNoncopyable
{
public:
	~FTapMemory() { ::operator delete(Data, Alignment); }

	void* Get(size_t Bytes)
	{
		if (Bytes > Size)
		{
			::operator delete(Data, Alignment);
			Data = nullptr;
			Size = 0;
			Data = ::operator new(Bytes, Alignment);
			Size = Bytes;
			std::memset(Data, 0, Size);
		}
		return Data;
	}

private:
	void* Data = nullptr;
	size_t Size = 0;
};

bool CanSum(const FTapSource& Source)
{
	const FKernelTexture& Texture = *Source.Texture;
	return Source.Sampler->Filter != EKernelFilter::Point && Source.Sampler->SampleBits == 8 && Texture.NumMips == 1 &&
		   !Texture.bIs3D && HasFloatLanes(Texture.Storage) && Source.NumTaps > 0;
}

} // namespace

bool HasFloatLanes(ETexelStorage Storage)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	return Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32;
}

void* GetTapMemory(int32_t Number, size_t Bytes)
{
	static thread_local FTapMemory Memories[16];
	return Memories[Number].Get(Bytes);
}

bool StoresPlainly(const FKernelArgs& Args)
{
	return !Args.Counters &&
		   (Args.NumTargets == 0 || (!Args.Targets[0].bBlend && (Args.Targets[0].WriteMask & 15) == 15));
}

bool SumTaps(
	const FTapSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY)
{
	if (Tile.MaxX <= Tile.MinX || Tile.MaxY <= Tile.MinY)
	{
		return true;
	}
	if (!HasFloatLanes(Target.Storage) || !std::all_of(Sum.Sources, Sum.Sources + Sum.NumSources, &CanSum))
	{
		return false;
	}
	return WithNativeLanes<TTapSumLanes>(
		[&](auto Lanes) { return Lanes.Run(Sum, Target, Tile, ToTargetX, ToTargetY); });
}

} // namespace Drydock
