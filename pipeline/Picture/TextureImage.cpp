// Reads textures into images of doubles.
#include "Picture/TextureImage.h"

#include "Picture/Picture.h"

namespace Drydock
{

FImage ReadTexture(FRHITexture& Texture, int Mip)
{
	return FPicture::Copy(Texture, Mip).ToImage();
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

std::vector<std::string> GetChannelNames(int NumChannels)
{
	const std::vector<std::string> Names = {"R", "G", "B", "A"};
	return std::vector<std::string>(Names.begin(), Names.begin() + NumChannels);
}

} // namespace Drydock
