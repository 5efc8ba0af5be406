// Scales textures down.
#include "Run/PassLook.h"

#include <algorithm>

namespace Drydock
{

FRunThumbnail MakeThumbnail(const std::string& Resource, FRHITexture& Texture, FIntRect Window)
{
	const FIntVector Size = Texture.GetMipDimensions(0);
	const FIntRect Whole(0, 0, Size.X, Size.Y);
	Window.Clip(Whole);
	const FPicture Picture(&Texture, Window.Area() > 0 ? Window : Whole,
		std::clamp(GPixelFormats[Texture.GetFormat()].NumComponents, 1, 4));
	const int Step = std::max({1, (Picture.Width + ThumbnailWidth - 1) / ThumbnailWidth,
		(Picture.Height + ThumbnailHeight - 1) / ThumbnailHeight});

	FRunThumbnail Thumbnail{Resource, FIntPoint(Size.X, Size.Y), {}};
	FImage& Image = Thumbnail.Image;
	Image.Width = (Picture.Width + Step - 1) / Step;
	Image.Height = (Picture.Height + Step - 1) / Step;
	Image.NumChannels = Picture.NumChannels;
	std::vector<float> Row(static_cast<size_t>(Picture.Width * Picture.NumChannels));
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		Picture.ReadRow(std::min(Y * Step + Step / 2, Picture.Height - 1), Row.data());
		for (int X = 0; X < Image.Width; ++X)
		{
			const int End = std::min((X + 1) * Step, Picture.Width);
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				double Sum = 0.0;
				for (int Texel = X * Step; Texel < End; ++Texel)
				{
					Sum += Row[static_cast<size_t>(Texel * Image.NumChannels + Channel)];
				}
				Image.Values.push_back(Sum / (End - X * Step));
			}
		}
	}
	return Thumbnail;
}

} // namespace Drydock
