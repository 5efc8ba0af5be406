// CharaGlow's box by running sums: the cost does not grow with the area. Stands in for BoxPS of CharaGlow.usf; sums run
// in double, so that they do not drift, and are rounded once. Source: drydock.
#include "CharaGlowShaders.h"
#include "NativeKernels.h"
#include "PixelFormatConversion.h"

#include <algorithm>
#include <vector>

namespace Drydock
{

namespace
{

/** One channel of the texels Min..Max (inclusive) of a row or column, repeated beyond the bounds. */
class FLineReader
{
public:
	FLineReader(const FKernelTexture& InTexture, int32 InChannel)
		: Texture(InTexture)
		, Channel(InChannel)
		, Bytes(GetTexelStorageInfo(InTexture.Storage).BytesPerTexel)
	{
	}

	/** Of a texture that is bound, but has nothing there, D3D reads 0. */
	float Read(int32 X, int32 Y) const
	{
		const FKernelMip& Mip = Texture.Mips[0];
		if (X < 0 || Y < 0 || X >= Mip.SizeX || Y >= Mip.SizeY)
		{
			return 0.0f;
		}
		float Color[4];
		DecodeTexel(Texture.Storage, Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * Bytes, Color);
		return Color[Channel];
	}

private:
	const FKernelTexture& Texture;
	int32 Channel;
	int32 Bytes;
};

/** Line holds the texels from -Reach to Count - 1 + Reach, Reach = Radius + 1; Out gets the Count weighted means. */
void RunBox(const std::vector<float>& Line, int32 Count, const FCharaGlowBoxParameters& Parameters, float* Out)
{
	const int32 Radius = Parameters.Radius;
	double Sum = 0.0;
	for (int32 Tap = 1; Tap <= 2 * Radius + 1; ++Tap)
	{
		Sum += Line[size_t(Tap)];
	}
	for (int32 Index = 0; Index < Count; ++Index)
	{
		const float First = Line[size_t(Index)];
		const float Last = Line[size_t(Index + 2 * Radius + 2)];
		const double Ring = (double(First) + Last) * Parameters.Fraction;
		Out[Index] = static_cast<float>((Sum + Ring) * Parameters.Scale);
		Sum += double(Last) - Line[size_t(Index + 1)];
	}
}

void WriteTexel(const FKernelTarget& Target, int32 X, int32 Y, float Value)
{
	const FKernelMip& Mip = Target.Texture.Mips[0];
	const int32 Bytes = GetTexelStorageInfo(Target.Texture.Storage).BytesPerTexel;
	const float Color[4] = {Value, Value, Value, 1.0f};
	EncodeTexel(Target.Texture.Storage, Color, Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * Bytes,
		Target.Texture.bSaturateStore != 0);
}

void RunLines(const FNativeKernelArgs& Args, const FKernelTile& Tile, bool bRows)
{
	const FCharaGlowBoxParameters& Parameters = GetNativeParameters<FCharaGlowBoxPS>(Args);
	const FKernelTexture* const Source =
		Args.FindTexture(bRows ? "SceneTexturesStruct_GBufferDTexture" : "RowsTexture");
	check(Source);
	const FLineReader Reader(*Source, bRows ? 2 : 0);
	const FIntPoint Min(int32(Parameters.Source.ViewportMin.X), int32(Parameters.Source.ViewportMin.Y));
	const FIntPoint Max(int32(Parameters.Source.ViewportMax.X), int32(Parameters.Source.ViewportMax.Y));
	const FIntPoint Offset(
		Min.X - int32(Parameters.Output.ViewportMin.X), Min.Y - int32(Parameters.Output.ViewportMin.Y));

	const int32 Reach = Parameters.Radius + 1;
	const int32 Begin = bRows ? Tile.MinX : Tile.MinY;
	const int32 Count = (bRows ? Tile.MaxX : Tile.MaxY) - Begin;
	const FKernelTarget& Target = Args.GetArgs().Targets[0];
	std::vector<float> Line(size_t(Count + 2 * Reach));
	std::vector<float> Means(static_cast<size_t>(Count));
	for (int32 Across = bRows ? Tile.MinY : Tile.MinX; Across < (bRows ? Tile.MaxY : Tile.MaxX); ++Across)
	{
		for (int32 Index = 0; Index < Count + 2 * Reach; ++Index)
		{
			const int32 Along = Begin + Index - Reach;
			const int32 X = (bRows ? Along : Across) + Offset.X;
			const int32 Y = (bRows ? Across : Along) + Offset.Y;
			Line[size_t(Index)] = Reader.Read(std::clamp(X, Min.X, Max.X - 1), std::clamp(Y, Min.Y, Max.Y - 1));
		}
		RunBox(Line, Count, Parameters, Means.data());
		for (int32 Index = 0; Index < Count; ++Index)
		{
			WriteTexel(Target, bRows ? Begin + Index : Across, bRows ? Across : Begin + Index, Means[size_t(Index)]);
		}
	}
}

void RunCharaGlowBox(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FCharaGlowBoxPS::FPermutationDomain Permutation(Args.GetPermutationId());
	RunLines(Args, Tile, !Permutation.Get<FCharaGlowBoxPS::FColumnsDimension>());
}

} // namespace

REGISTER_NATIVE_KERNEL(FCharaGlowBoxPS, &RunCharaGlowBox)

} // namespace Drydock
