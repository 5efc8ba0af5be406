// A picture as a texture holds it: nothing is copied or converted until somebody reads a value or a row.
#pragma once

#include "Picture/ImageFile.h"
#include "RHITexture.h"
#include "RendererInterface.h"

namespace Drydock
{

/** A part of one mip of a texture (of a 3D texture or an array its first slice). The texture must not change any more.
 * A default one is empty: 0 x 0. */
class DRYDOCK_API FPicture
{
public:
	FPicture() = default;

	/** NumChannels: the first ones; those that the format lacks are 0, alpha 1. Rect lies inside the mip (checked). */
	FPicture(TRefCountPtr<FRHITexture> InTexture, const FIntRect& InRect, int InNumChannels = 4);

	/** Holds a target of the pool, which does not go back there while the picture lives. */
	FPicture(TRefCountPtr<IPooledRenderTarget> InTarget, const FIntRect& InRect, int InNumChannels = 4);

	/** A copy of a whole mip in the texture's own format, with the channels that the format has. */
	static FPicture Copy(FRHITexture& Texture, int Mip = 0);

	/** Values of the channel of one pixel, exactly. */
	double Get(int X, int Y, int Channel) const;

	/** A row, channels interleaved: Width * NumChannels numbers, what is 64 bits wide rounded. For several threads. */
	void ReadRow(int Y, float* Row) const;

	/** The same, exactly. */
	void ReadRow(int Y, double* Row) const;

	/** Part of the same picture; Part counts from this one's corner. */
	FPicture Crop(const FIntRect& Part) const;

	/** The same picture without its last channels. */
	FPicture Take(int NumFirstChannels) const;

	/** Whether a file may keep it as half floats: halves, and what half floats hold or round by less than half a step
	 * (8 bits and fewer). Looks at every value where the texture has 32 bits a channel. */
	bool FitsHalf() const;

	/** False: it has no NaN and no infinity. Halves are looked at. */
	bool MayHoldNonFinite() const;

	/** Writes it into mip 0 of another texture, with its corner at Position; it fits (checked). */
	void PasteInto(FRHITexture& Into, FIntPoint Position) const;

	/** A copy in doubles, for figures. */
	FImage ToImage() const;

	int Width = 0;
	int Height = 0;
	int NumChannels = 0;

private:
	TRefCountPtr<FRHITexture> Texture;
	TRefCountPtr<IPooledRenderTarget> Target;
	FIntPoint Corner = FIntPoint(0, 0);
};

/** Writes an EXR file as WriteExr of an image does: half floats where FitsHalf. As many names as the picture has
 * channels. */
DRYDOCK_API void WriteExr(const std::string& Path, const FPicture& Picture,
	const std::vector<std::string>& ChannelNames, const std::map<std::string, std::string>& Attributes = {},
	const FImageWindow& Window = {});

} // namespace Drydock
