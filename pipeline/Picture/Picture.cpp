// Reads pictures out of textures by rows.
#include "Picture/Picture.h"

#include "Picture/ExrWriter.h"
#include "TexelRows.h"
#include "TileExecutor.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace Drydock
{

FPicture::FPicture(TRefCountPtr<FRHITexture> InTexture, const FIntRect& InRect, int InNumChannels)
	: Width(InRect.Width())
	, Height(InRect.Height())
	, NumChannels(InNumChannels)
	, Texture(std::move(InTexture))
	, Corner(InRect.Min)
{
	const FIntPoint Size = Texture->GetSizeXY();
	check(Corner.X >= 0 && Corner.Y >= 0 && InRect.Max.X <= Size.X && InRect.Max.Y <= Size.Y);
	Texture->EnsureMemory();
}

FPicture::FPicture(TRefCountPtr<IPooledRenderTarget> InTarget, const FIntRect& InRect, int InNumChannels)
	: FPicture(TRefCountPtr<FRHITexture>(InTarget->GetRHI()), InRect, InNumChannels)
{
	Target = std::move(InTarget);
}

FPicture FPicture::Copy(FRHITexture& Source, int Mip)
{
	const FIntVector Size = Source.GetMipDimensions(static_cast<uint8>(Mip));
	const FRHITextureDesc Desc = FRHITextureDesc::Create2D(
		FIntPoint(Size.X, Size.Y), Source.GetFormat(), FClearValueBinding::None, Source.GetFlags());
	TRefCountPtr<FRHITexture> Copied = new FRHITexture(Desc, *Source.GetName().ToString());
	check(Copied->GetStorage() == Source.GetStorage());
	Copied->EnsureMemory();
	const size_t RowBytes = static_cast<size_t>(Size.X) * GetTexelStorageInfo(Source.GetStorage()).BytesPerTexel;
	for (int Y = 0; Y < Size.Y; ++Y)
	{
		std::memcpy(Copied->GetTexel(0, Y), Source.GetTexelToRead(0, Y, Mip), RowBytes);
	}
	return FPicture(
		Copied, FIntRect(0, 0, Size.X, Size.Y), std::clamp(GPixelFormats[Source.GetFormat()].NumComponents, 1, 4));
}

double FPicture::Get(int X, int Y, int Channel) const
{
	double Value[4];
	DecodeTexel(Texture->GetStorage(), Texture->GetTexelToRead(Corner.X + X, Corner.Y + Y), Value);
	return Value[Channel];
}

void FPicture::ReadRow(int Y, float* Row) const
{
	DecodeTexelRow(Texture->GetStorage(), Texture->GetTexelToRead(Corner.X, Corner.Y + Y), Width, NumChannels, Row);
}

void FPicture::ReadRow(int Y, double* Row) const
{
	const ETexelStorage Storage = Texture->GetStorage();
	const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	const uint8* Texel = Texture->GetTexelToRead(Corner.X, Corner.Y + Y);
	for (int X = 0; X < Width; ++X, Texel += TexelBytes)
	{
		double Value[4];
		DecodeTexel(Storage, Texel, Value);
		Row = std::copy_n(Value, NumChannels, Row);
	}
}

FPicture FPicture::Crop(const FIntRect& Part) const
{
	FPicture Cropped(Texture, Part + Corner, NumChannels);
	Cropped.Target = Target;
	return Cropped;
}

FPicture FPicture::Take(int NumFirstChannels) const
{
	FPicture Taken = *this;
	Taken.NumChannels = NumFirstChannels;
	return Taken;
}

bool FPicture::MayHoldNonFinite() const
{
	if (!Texture || GetTexelStorageInfo(Texture->GetStorage()).Kind != ETexelKind::Float)
	{
		return false;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture->GetStorage());
	const size_t NumWords = static_cast<size_t>(Width) * Info.BytesPerTexel / sizeof(uint16_t);
	std::atomic<bool> bMay = Info.BitsPerChannel != 16;
	ForEachTile(FKernelTile{0, 0, 0, 1, Height, 1}, FIntPoint(1, 16),
		[&](const FKernelTile& Tile)
		{
			constexpr uint16_t Exponent = 0x7c00; // of a half; all its bits are set in what is not finite
			for (int Y = Tile.MinY; !bMay && Y < Tile.MaxY; ++Y)
			{
				const void* const Row = Texture->GetTexelToRead(Corner.X, Corner.Y + Y);
				const auto* const Words = static_cast<const uint16_t*>(Row);
				uint16_t bAny = 0;
				for (size_t Word = 0; Word < NumWords; ++Word)
				{
					bAny |= (Words[Word] & Exponent) == Exponent ? 1 : 0;
				}
				bMay = bMay || bAny != 0;
			}
		});
	return bMay;
}

void FPicture::PasteInto(FRHITexture& Into, FIntPoint Position) const
{
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			Into.WriteTexelDouble(Position.X + X, Position.Y + Y, Texture->ReadTexelDouble(Corner.X + X, Corner.Y + Y));
		}
	}
}

bool FPicture::FitsHalf() const
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture->GetStorage());
	if (Info.BitsPerChannel <= 8 || (Info.Kind == ETexelKind::Float && Info.BitsPerChannel <= 16))
	{
		return true;
	}
	std::atomic<bool> bFits = Info.Kind != ETexelKind::Unorm; // 10 and 16 bits: no half is near enough
	ForEachTile(FKernelTile{0, 0, 0, Width, Height, 1}, FIntPoint(Width, 16),
		[&](const FKernelTile& Tile)
		{
			std::vector<double> Row(static_cast<size_t>(Width) * static_cast<size_t>(NumChannels));
			for (int Y = Tile.MinY; bFits && Y < Tile.MaxY; ++Y)
			{
				ReadRow(Y, Row.data());
				bFits = bFits && std::all_of(Row.begin(), Row.end(), IsExactHalf);
			}
		});
	return bFits;
}

FImage FPicture::ToImage() const
{
	FImage Image{Width, Height, NumChannels, {}};
	const size_t RowSize = static_cast<size_t>(Width) * static_cast<size_t>(NumChannels);
	Image.Values.resize(RowSize * static_cast<size_t>(Height));
	ForEachTile(FKernelTile{0, 0, 0, Width, Height, 1}, FIntPoint(Width, 16),
		[&](const FKernelTile& Tile)
		{
			for (int Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				ReadRow(Y, &Image.Values[static_cast<size_t>(Y) * RowSize]);
			}
		});
	return Image;
}

void WriteExr(const std::string& Path, const FPicture& Picture, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes, const FImageWindow& Window)
{
	FExrDescription Description;
	Description.Width = Picture.Width;
	Description.Height = Picture.Height;
	Description.Channels = ChannelNames;
	Description.Half.assign(ChannelNames.size(), Picture.FitsHalf());
	Description.Attributes = Attributes;
	Description.Window = Window;
	WriteExrRows(Path, Description, [&Picture](int Y, float* Row) { Picture.ReadRow(Y, Row); });
}

} // namespace Drydock
