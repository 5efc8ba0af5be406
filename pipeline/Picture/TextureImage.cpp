// Reads textures into pictures, tile by tile.
#include "Picture/TextureImage.h"

#include "TileExecutor.h"

#include <algorithm>

namespace Drydock
{

FImage ReadTexture(FRHITexture& Texture, int Mip)
{
	const FIntVector Size = Texture.GetMipDimensions(static_cast<uint8>(Mip));
	FImage Image;
	Image.Width = Size.X;
	Image.Height = Size.Y;
	Image.NumChannels = std::clamp(GPixelFormats[Texture.GetFormat()].NumComponents, 1, 4);
	Image.Values.resize(
		static_cast<size_t>(Size.X) * static_cast<size_t>(Size.Y) * static_cast<size_t>(Image.NumChannels));
	Texture.EnsureMemory();
	ForEachTile(FKernelTile{0, 0, 0, Size.X, Size.Y, 1}, FIntPoint(Size.X, 16),
		[&](const FKernelTile& Tile)
		{
			double* Out = Image.Values.data() + static_cast<size_t>(Tile.MinY) * static_cast<size_t>(Size.X) *
													static_cast<size_t>(Image.NumChannels);
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				for (int32 X = 0; X < Size.X; ++X)
				{
					const FVector4 Texel = Texture.ReadTexelDouble(X, Y, Mip);
					const double Components[4] = {Texel.X, Texel.Y, Texel.Z, Texel.W};
					Out = std::copy(Components, Components + Image.NumChannels, Out);
				}
			}
		});
	return Image;
}

FImage ReadChannel(FRHITexture& Texture, const FIntRect& Rect, int Channel)
{
	FImage Values{Rect.Width(), Rect.Height(), 1, {}};
	Values.Values.reserve(static_cast<size_t>(Rect.Width()) * static_cast<size_t>(Rect.Height()));
	TArray<FLinearColor> Row;
	Row.SetNum(Rect.Width());
	for (int32 Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		Texture.ReadRow(Rect.Min.X, Y, Row);
		for (const FLinearColor& Texel : Row)
		{
			const float Components[4] = {Texel.R, Texel.G, Texel.B, Texel.A};
			Values.Values.push_back(static_cast<double>(Components[Channel]));
		}
	}
	return Values;
}

FImage CropToRgba(const FImage& Image, const FIntRect& Rect)
{
	FImage Crop;
	Crop.Width = Rect.Width();
	Crop.Height = Rect.Height();
	Crop.NumChannels = 4;
	Crop.Values.reserve(static_cast<size_t>(Crop.Width) * static_cast<size_t>(Crop.Height) * 4);
	for (int Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		for (int X = Rect.Min.X; X < Rect.Max.X; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				Crop.Values.push_back(Channel < Image.NumChannels ? Image.Get(X, Y, Channel)
									  : Channel == 3              ? 1.0
																  : 0.0);
			}
		}
	}
	return Crop;
}

std::vector<std::string> GetChannelNames(int NumChannels)
{
	const std::vector<std::string> Names = {"R", "G", "B", "A"};
	return std::vector<std::string>(Names.begin(), Names.begin() + NumChannels);
}

} // namespace Drydock
