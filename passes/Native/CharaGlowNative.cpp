// CharaGlow's box by running sums: the cost hardly grows with the area. Stands in for BoxPS of CharaGlow.usf; sums run
// in double, so that they do not drift, and are rounded once.
#include <Imath/half.h>

#include "NativeKernels.h"
#include "PixelFormatConversion.h"
#include "Toon/CharaGlowShaders.h"

#include <algorithm>
#include <vector>

namespace Drydock
{

namespace
{

float DecodeChannel(const FKernelTexture& Texture, const uint8_t* Texel, int32 Channel)
{
	switch (Texture.Storage)
	{
	case ETexelStorage::RGBA8_UNORM:
		return static_cast<float>(Texel[Channel] / 255.0);
	case ETexelStorage::BGRA8_UNORM:
		return static_cast<float>(Texel[Channel < 3 ? 2 - Channel : 3] / 255.0);
	case ETexelStorage::R16_FLOAT:
	{
		Imath::half Value;
		Value.setBits(*reinterpret_cast<const uint16_t*>(Texel));
		return Value;
	}
	default:
		float Color[4];
		DecodeTexel(Texture.Storage, Texel, Color);
		return Color[Channel];
	}
}

/** A channel of the texels of a window, row by row; where the window leaves Bounds, the nearest texel inside. */
std::vector<float> ReadWindow(
	const FKernelTexture& Texture, int32 Channel, const FIntRect& Window, const FIntRect& Bounds)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int32 Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	// Beyond the texture a shader reads 0; only a texture smaller than its viewport gets there.
	const bool bInside = Bounds.Max.X <= Mip.SizeX && Bounds.Max.Y <= Mip.SizeY;
	std::vector<float> Values(size_t(Window.Width()) * size_t(Window.Height()), 0.0f);
	float* Out = Values.data();
	for (int32 Y = Window.Min.Y; bInside && Y < Window.Max.Y; ++Y)
	{
		const uint8_t* const Row = Mip.Data + int64_t(std::clamp(Y, Bounds.Min.Y, Bounds.Max.Y - 1)) * Mip.RowPitch;
		for (int32 X = Window.Min.X; X < Window.Max.X; ++X)
		{
			*Out++ =
				DecodeChannel(Texture, Row + int64_t(std::clamp(X, Bounds.Min.X, Bounds.Max.X - 1)) * Bytes, Channel);
		}
	}
	return Values;
}

void WriteTexel(const FKernelTexture& Texture, int32 X, int32 Y, float Value)
{
	const FKernelMip& Mip = Texture.Mips[0];
	uint8_t* const Texel =
		Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	if (Texture.Storage == ETexelStorage::R16_FLOAT && !Texture.bSaturateStore)
	{
		*reinterpret_cast<uint16_t*>(Texel) = Imath::half(Value).bits();
		return;
	}
	const float Color[4] = {Value, Value, Value, 1.0f};
	EncodeTexel(Texture.Storage, Color, Texel, Texture.bSaturateStore != 0);
}

/** The weighted means of one direction over a tile. Steps are distances in Values, along the box and across it; Values
 *  starts Radius + 1 texels before the tile. Sums stand side by side across the box, so that memory is walked in order.
 */
template<typename WriteType>
void RunBox(const float* Values, int32 Along, int32 Across, ptrdiff_t StepAlong, ptrdiff_t StepAcross,
	const FCharaGlowBoxParameters& Parameters, const WriteType& Write)
{
	const int32 Radius = Parameters.Radius;
	const double Fraction = Parameters.Fraction, Scale = Parameters.Scale;
	std::vector<double> Sums(static_cast<size_t>(Across), 0.0);
	for (int32 Tap = 1; Tap <= 2 * Radius + 1; ++Tap)
	{
		for (int32 Index = 0; Index < Across; ++Index)
		{
			Sums[size_t(Index)] += Values[Tap * StepAlong + Index * StepAcross];
		}
	}
	for (int32 Position = 0; Position < Along; ++Position)
	{
		const float* const First = Values + Position * StepAlong;
		const float* const Next = First + StepAlong;
		const float* const Last = First + (2 * Radius + 2) * StepAlong;
		for (int32 Index = 0; Index < Across; ++Index)
		{
			const ptrdiff_t Offset = Index * StepAcross;
			double& Sum = Sums[size_t(Index)];
			Write(
				Position, Index, static_cast<float>((Sum + (double(First[Offset]) + Last[Offset]) * Fraction) * Scale));
			Sum += double(Last[Offset]) - Next[Offset];
		}
	}
}

void RunCharaGlowBox(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FCharaGlowBoxPS::FPermutationDomain Permutation(Args.GetPermutationId());
	const bool bColumns = Permutation.Get<FCharaGlowBoxPS::FColumnsDimension>();
	const FCharaGlowBoxParameters& Parameters = GetNativeParameters<FCharaGlowBoxPS>(Args);
	const FKernelTexture* const Source =
		Args.FindTexture(bColumns ? "RowsTexture" : "SceneTexturesStruct_GBufferDTexture");
	check(Source);
	const FIntRect Bounds(Parameters.Source.ViewportMin, Parameters.Source.ViewportMax);
	const FIntPoint Offset = Bounds.Min - Parameters.Output.ViewportMin;
	const int32 Reach = Parameters.Radius + 1;
	const FIntPoint Margin(bColumns ? 0 : Reach, bColumns ? Reach : 0);
	const FIntRect Window(Tile.MinX + Offset.X - Margin.X, Tile.MinY + Offset.Y - Margin.Y,
		Tile.MaxX + Offset.X + Margin.X, Tile.MaxY + Offset.Y + Margin.Y);
	const std::vector<float> Values = ReadWindow(*Source, bColumns ? 0 : 2, Window, Bounds);

	const FKernelTexture& Target = Args.GetArgs().Targets[0].Texture;
	const int32 Width = Tile.MaxX - Tile.MinX, Height = Tile.MaxY - Tile.MinY;
	if (bColumns)
	{
		RunBox(Values.data(), Height, Width, Window.Width(), 1, Parameters,
			[&](int32 Y, int32 X, float Value) { WriteTexel(Target, Tile.MinX + X, Tile.MinY + Y, Value); });
		return;
	}
	for (int32 Y = 0; Y < Height; ++Y)
	{
		RunBox(Values.data() + int64_t(Y) * Window.Width(), Width, 1, 1, 0, Parameters,
			[&](int32 X, int32, float Value) { WriteTexel(Target, Tile.MinX + X, Tile.MinY + Y, Value); });
	}
}

} // namespace

REGISTER_NATIVE_KERNEL(FCharaGlowBoxPS, &RunCharaGlowBox)

} // namespace Drydock
