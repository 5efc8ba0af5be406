// Moves texels of inputs, and looks for those of outputs.
#include "Prove/PassTransform.h"

#include "KernelRerun.h"
#include "PixelFormatConversion.h"
#include "RunningCode.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr int32_t Shift = 8; // texels of the output: whole ones in inputs down to an eighth of its size

/** The column that a texel of the transformed picture has been in. */
int32_t FindSource(EPassTransform Transform, int32_t X, int32_t SizeX, int32_t By)
{
	return Transform == EPassTransform::Mirrored ? SizeX - 1 - X : (X + SizeX - By) % SizeX;
}

std::vector<double> ReadTexel(const FKernelTexture& Texture, int32_t X, int32_t Y)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
	double Color[4] = {};
	DecodeTexel(Texture.Storage, GetTexelAddress(Texture.Mips[0], X, Y, Info.BytesPerTexel), Color);
	return {Color, Color + Info.NumChannels};
}

} // namespace

FPassTransform::~FPassTransform() = default;

void FPassTransform::AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const FCodeOwner* const Owner = GetRunningCode();
	const FKernelTexture* const Output = Args.NumTargets > 0          ? &Args.Targets[0].Texture
										 : !Shader.RWTextures.empty() ? &Shader.RWTextures[0]
																	  : nullptr;
	if (Difference || !Owner || !Owner->IsForeign() || !Output || Output->NumMips < 1 ||
		Shader.GetReflection().bLoadsStored || !Shader.RWBuffers.empty() || !Shader.Buffers.empty() ||
		GetTexelStorageInfo(Output->Storage).Kind == ETexelKind::Uint ||
		(Args.NumTargets > 0 && Args.Targets[0].bBlend))
	{
		return;
	}
	const FKernelMip& Mip = Output->Mips[0];
	const bool bWhole = Whole.MinX == 0 && Whole.MinY == 0 && Whole.MaxX >= Mip.SizeX && Whole.MaxY >= Mip.SizeY;
	FKernelRerun Rerun(Shader, Args, Whole);
	bool bReads = false;
	for (size_t Slot = 0; Slot < Shader.Textures.size() && bWhole; ++Slot)
	{
		const FKernelTexture& Read = Shader.Textures[Slot];
		const bool bFlat = Read.NumMips > 0 && !Read.bIs3D && Read.Mips[0].SizeZ == 1;
		const int64_t By = bFlat ? int64_t(Shift) * Read.Mips[0].SizeX : 0;
		if (bFlat && Transform == EPassTransform::Shifted && Read.Mips[0].SizeX > 1 && By % Mip.SizeX != 0)
		{
			return; // no whole texel
		}
		if (!bFlat || Read.NumMips > 1)
		{
			continue; // a table of colours
		}
		bReads = true;
		const FKernelMip& From = Read.Mips[0];
		const FKernelMip& To = Rerun.OwnInput(Slot).GetMip();
		const int32_t Bytes = GetTexelStorageInfo(Read.Storage).BytesPerTexel;
		for (int32_t y = 0; y < From.SizeY; ++y)
		{
			for (int32_t x = 0; x < From.SizeX; ++x)
			{
				const int32_t Source = FindSource(Transform, x, From.SizeX, int32_t(By / Mip.SizeX) % From.SizeX);
				std::memcpy(GetTexelAddress(To, x, y, Bytes), GetTexelAddress(From, Source, y, Bytes), size_t(Bytes));
			}
		}
	}
	if (!bReads)
	{
		return;
	}
	Rerun.Run();
	const bool bShifted = Transform == EPassTransform::Shifted;
	const FIntPoint Min = bShifted ? FIntPoint(Mip.SizeX / 4 + Shift, Mip.SizeY / 4) : FIntPoint(0, 0);
	const FIntPoint Max = bShifted ? FIntPoint(Mip.SizeX * 3 / 4, Mip.SizeY * 3 / 4) : FIntPoint(Mip.SizeX, Mip.SizeY);
	std::optional<FPixelDifference> First;
	for (int32_t y = Min.Y; y < Max.Y; ++y)
	{
		for (int32_t x = Min.X; x < Max.X; ++x)
		{
			std::vector<double> Base = ReadTexel(*Output, FindSource(Transform, x, Mip.SizeX, Shift), y);
			std::vector<double> Other = ReadTexel(Rerun.GetWritten()[0], x, y);
			if (!std::ranges::equal(Base, Other, AreClose))
			{
				First = First ? First : FPixelDifference{x, y, std::move(Base), std::move(Other), 0};
				++First->NumPixels;
			}
		}
	}
	if (First && First->NumPixels * 1000 > uint64_t(Mip.SizeX) * uint64_t(Mip.SizeY))
	{
		const std::string Name = Args.NumTargets > 0 ? "SV_Target0" : Shader.GetReflection().RWTextures[0].Name;
		Difference = FFirstDifference{Owner->Pass, Shader.Name, Owner->Plugin, Name, 0, "", std::move(First), {}};
	}
}

} // namespace Drydock
