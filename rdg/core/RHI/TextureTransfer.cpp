// Copies, reads back and clears textures.
#include "TextureTransfer.h"

#include "PixelFormatConversion.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

ETexelStorage GetNativeStorage(const FRHITexture* Texture)
{
	return GetNativeTexelStorage(Texture->GetDesc());
}

/** Size of a region along one axis at a mip, where texels halve per mip. */
int32 AtMip(int32 Value, uint32 Mip)
{
	return std::max(1, Value >> Mip);
}

void CopyMipSlice(FRHITexture* Source, FRHITexture* Dest, FIntVector From, int32 SourceMip, FIntVector To,
	int32 DestMip, FIntVector Size)
{
	const size_t RowBytes = size_t(Size.X) * GetTexelStorageInfo(Source->GetStorage()).BytesPerTexel;
	// Far corners first: a copy beyond either texture touches nothing.
	Source->GetTexelToRead(From.X + Size.X - 1, From.Y + Size.Y - 1, SourceMip, From.Z + Size.Z - 1);
	Dest->GetTexel(To.X + Size.X - 1, To.Y + Size.Y - 1, DestMip, To.Z + Size.Z - 1);
	const auto CopyRows = [&](const FKernelTile& Rows)
	{
		for (int32 Z = Rows.MinZ; Z < Rows.MaxZ; ++Z)
		{
			for (int32 Y = Rows.MinY; Y < Rows.MaxY; ++Y)
			{
				std::memmove(Dest->GetTexel(To.X, To.Y + Y, DestMip, To.Z + Z),
					Source->GetTexelToRead(From.X, From.Y + Y, SourceMip, From.Z + Z), RowBytes);
			}
		}
	};
	const FKernelTile Whole = {0, 0, 0, 1, Size.Y, Size.Z};
	// Within one texture rows may overlap: then their order counts.
	constexpr int32 RowsPerTile = 64;
	if (Source == Dest || Size.Y <= RowsPerTile)
	{
		CopyRows(Whole);
		return;
	}
	ForEachTile(Whole, FIntVector(1, RowsPerTile, 1), CopyRows);
}

/** The range of all channels, never narrower than 0..1. NaN does not count. */
void ScaleToUnit(TArray<FLinearColor>& Colors)
{
	float Min = 0;
	float Max = 1;
	for (const FLinearColor& Color : Colors)
	{
		for (float Value : {Color.R, Color.G, Color.B, Color.A})
		{
			Min = Value < Min ? Value : Min;
			Max = Value > Max ? Value : Max;
		}
	}
	if (Min == 0 && Max == 1)
	{
		return;
	}
	const auto Scale = [=](float Value)
	{
		return (Value - Min) / (Max - Min);
	};
	for (FLinearColor& Color : Colors)
	{
		Color = FLinearColor(Scale(Color.R), Scale(Color.G), Scale(Color.B), Scale(Color.A));
	}
}

void ClampColors(TArray<FLinearColor>& Colors, float Min)
{
	const auto Clamp = [Min](float Value)
	{
		return Value > Min ? std::min(Value, 1.0f) : Min;
	}; // NaN gives Min
	for (FLinearColor& Color : Colors)
	{
		Color = FLinearColor(Clamp(Color.R), Clamp(Color.G), Clamp(Color.B), Clamp(Color.A));
	}
}

/** Fills every texel of a kernel view's first mip. */
uint64 FillKernelView(const FKernelTexture& View, const uint8* Texel)
{
	const FKernelMip& Mip = View.Mips[0];
	const size_t TexelBytes = GetTexelStorageInfo(View.Storage).BytesPerTexel;
	const size_t RowBytes = TexelBytes * size_t(Mip.SizeX);
	for (size_t Byte = 0; Byte < RowBytes; Byte += TexelBytes)
	{
		std::memcpy(Mip.Data + Byte, Texel, TexelBytes);
	}
	for (int32 Z = 0; Z < Mip.SizeZ; ++Z)
	{
		for (int32 Y = Z == 0 ? 1 : 0; Y < Mip.SizeY; ++Y)
		{
			std::memcpy(Mip.Data + Z * Mip.SlicePitch + int64(Y) * Mip.RowPitch, Mip.Data, RowBytes);
		}
	}
	return uint64(Mip.SizeX) * uint64(Mip.SizeY) * uint64(Mip.SizeZ);
}

uint64 FillKernelBuffer(const FKernelBuffer& View, const uint8* Element, size_t ElementBytes)
{
	const size_t Num = View.SizeInBytes / ElementBytes;
	for (size_t Index = 0; Index < Num; ++Index)
	{
		std::memcpy(View.Data + Index * ElementBytes, Element, ElementBytes);
	}
	return Num;
}

} // namespace

uint32 GetNativeTexelBytes(const FRHITexture* Texture)
{
	return GetTexelStorageInfo(GetNativeStorage(Texture)).BytesPerTexel;
}

void ReadNativeTexels(FRHITexture* Texture, FIntRect Rect, int32 Mip, int32 Slice, uint8* Dest, size_t DestPitch)
{
	const ETexelStorage Native = GetNativeStorage(Texture);
	const ETexelStorage Stored = Texture->GetStorage();
	const size_t NativeBytes = GetTexelStorageInfo(Native).BytesPerTexel;
	const size_t StoredBytes = GetTexelStorageInfo(Stored).BytesPerTexel;
	Texture->GetTexel(Rect.Max.X - 1, Rect.Max.Y - 1, Mip, Slice);
	for (int32 Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		const uint8* const From = Texture->GetTexelToRead(Rect.Min.X, Y, Mip, Slice);
		uint8* const To = Dest + size_t(Y - Rect.Min.Y) * DestPitch;
		if (Native == Stored)
		{
			std::memcpy(To, From, size_t(Rect.Width()) * NativeBytes);
			continue;
		}
		for (int32 X = 0; X < Rect.Width(); ++X)
		{
			double Value[4];
			DecodeTexel(Stored, From + size_t(X) * StoredBytes, Value);
			EncodeTexel(Native, Value, To + size_t(X) * NativeBytes, IsStoreOverflowSaturated());
		}
	}
}

void WriteNativeTexels(
	FRHITexture* Texture, FIntRect Rect, int32 Mip, int32 Slice, const uint8* Source, size_t SourcePitch)
{
	const ETexelStorage Native = GetNativeStorage(Texture);
	const ETexelStorage Stored = Texture->GetStorage();
	const size_t NativeBytes = GetTexelStorageInfo(Native).BytesPerTexel;
	const size_t StoredBytes = GetTexelStorageInfo(Stored).BytesPerTexel;
	Texture->GetTexel(Rect.Max.X - 1, Rect.Max.Y - 1, Mip, Slice);
	for (int32 Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		const uint8* const From = Source + size_t(Y - Rect.Min.Y) * SourcePitch;
		uint8* const To = Texture->GetTexel(Rect.Min.X, Y, Mip, Slice);
		if (Native == Stored)
		{
			std::memcpy(To, From, size_t(Rect.Width()) * NativeBytes);
			continue;
		}
		for (int32 X = 0; X < Rect.Width(); ++X)
		{
			double Value[4];
			DecodeTexel(Native, From + size_t(X) * NativeBytes, Value);
			EncodeTexel(Stored, Value, To + size_t(X) * StoredBytes);
		}
	}
}

uint64 CopyTextureRegion(FRHITexture* Source, FRHITexture* Dest, const FRHICopyTextureInfo& Info)
{
	check(Source && Dest);
	checkf(Source->GetFormat() == Dest->GetFormat() && Source->GetStorage() == Dest->GetStorage(),
		TEXT("CopyTexture does not convert: %s is %s, %s is %s"), *Source->GetName().ToString(),
		GetPixelFormatString(Source->GetFormat()), *Dest->GetName().ToString(),
		GetPixelFormatString(Dest->GetFormat()));

	uint64 NumTexels = 0;
	for (uint32 Mip = 0; Mip < Info.NumMips; ++Mip)
	{
		const int32 SourceMip = int32(Info.SourceMipIndex + Mip);
		const int32 DestMip = int32(Info.DestMipIndex + Mip);
		checkf(SourceMip < Source->GetDesc().NumMips && DestMip < Dest->GetDesc().NumMips,
			TEXT("CopyTexture: %s has %d mips, %s has %d"), *Source->GetName().ToString(), Source->GetDesc().NumMips,
			*Dest->GetName().ToString(), Dest->GetDesc().NumMips);

		const FTextureMipLayout& At = Source->GetMipLayout(SourceMip);
		FIntVector From(Info.SourcePosition.X >> Mip, Info.SourcePosition.Y >> Mip, Info.SourcePosition.Z >> Mip);
		FIntVector To(Info.DestPosition.X >> Mip, Info.DestPosition.Y >> Mip, Info.DestPosition.Z >> Mip);
		FIntVector Size(AtMip(Info.Size.X, Mip), AtMip(Info.Size.Y, Mip), AtMip(Info.Size.Z, Mip));
		if (Info.Size.X == 0 && Info.Size.Y == 0 && Info.Size.Z == 0)
		{
			Size = FIntVector(At.SizeX - From.X, At.SizeY - From.Y, At.SizeZ - From.Z);
		}
		if (!Source->GetDesc().IsTexture3D())
		{
			From.Z = int32(Info.SourceSliceIndex);
			To.Z = int32(Info.DestSliceIndex);
			Size.Z = int32(Info.NumSlices);
		}
		CopyMipSlice(Source, Dest, From, SourceMip, To, DestMip, Size);
		NumTexels += uint64(Size.X) * uint64(Size.Y) * uint64(Size.Z);
	}
	return NumTexels;
}

void ReadSurface(FRHITexture* Texture, FIntRect Rect, TArray<FLinearColor>& OutData, const FReadSurfaceDataFlags& Flags)
{
	check(Texture);
	OutData.Reset();
	if (Rect.Width() <= 0 || Rect.Height() <= 0)
	{
		return;
	}
	const bool bCubeFace = Texture->GetDesc().IsTextureCube() && Flags.GetCubeFace() != CubeFace_MAX;
	const int32 Slice = bCubeFace ? Flags.GetArrayIndex() * 6 + int32(Flags.GetCubeFace()) : Flags.GetArrayIndex();
	Texture->GetTexel(Rect.Max.X - 1, Rect.Max.Y - 1, Flags.GetMip(), Slice);

	OutData.SetNum(Rect.Width() * Rect.Height());
	for (int32 Y = 0; Y < Rect.Height(); ++Y)
	{
		const TArrayView<FLinearColor> Row(OutData.GetData() + Y * Rect.Width(), Rect.Width());
		Texture->ReadRow(Rect.Min.X, Rect.Min.Y + Y, Row, Flags.GetMip(), Slice);
	}
	switch (Flags.GetCompressionMode())
	{
	case RCM_UNorm:
		ClampColors(OutData, 0.0f);
		break;
	case RCM_SNorm:
		ClampColors(OutData, -1.0f);
		break;
	case RCM_MinMaxNorm:
		ScaleToUnit(OutData);
		break;
	case RCM_MinMax:
		break;
	}
}

void ReadSurface(FRHITexture* Texture, FIntRect Rect, TArray<FColor>& OutData, const FReadSurfaceDataFlags& Flags)
{
	check(Texture);
	FReadSurfaceDataFlags RealFlags = Flags;
	RealFlags.SetCompressionMode(Flags.GetCompressionMode() == RCM_MinMaxNorm ? RCM_MinMaxNorm : RCM_UNorm);
	TArray<FLinearColor> Colors;
	ReadSurface(Texture, Rect, Colors, RealFlags);

	// Eight-bit formats come back as their bytes: an sRGB texture was decoded above and is encoded again, a linear one
	// stays.
	const ETexelKind Kind = GetTexelStorageInfo(GetNativeStorage(Texture)).Kind;
	const bool bEncode = Kind == ETexelKind::Srgb || (Kind == ETexelKind::Float && Flags.GetLinearToGamma());
	const auto Encode = [bEncode](float Value)
	{
		return bEncode ? EncodeSrgb8(Value) : uint8(EncodeUnorm(Value, 8));
	};
	OutData.Reset(Colors.Num());
	for (const FLinearColor& Color : Colors)
	{
		OutData.Add(FColor(Encode(Color.R), Encode(Color.G), Encode(Color.B), uint8(EncodeUnorm(Color.A, 8))));
	}
}

uint64 ClearView(const FRHIUnorderedAccessView* View, const FVector4f& Value)
{
	check(View);
	const float Channels[4] = {Value.X, Value.Y, Value.Z, Value.W};
	uint8 Texel[32];
	if (View->IsTexture())
	{
		const FKernelTexture Texture = View->GetKernelTexture();
		View->GetTexture()->Touch();
		EncodeTexel(Texture.Storage, Channels, Texel, Texture.bSaturateStore);
		return FillKernelView(Texture, Texel);
	}
	const FKernelBuffer Buffer = View->GetKernelBuffer();
	const ETexelStorage Storage = View->IsTyped() ? Buffer.Storage : ETexelStorage::R32_FLOAT;
	EncodeTexel(Storage, Channels, Texel, IsStoreOverflowSaturated());
	return FillKernelBuffer(Buffer, Texel, GetTexelStorageInfo(Storage).BytesPerTexel);
}

uint64 ClearView(const FRHIUnorderedAccessView* View, const FUintVector4& Value)
{
	check(View);
	const uint32_t Channels[4] = {Value.X, Value.Y, Value.Z, Value.W};
	uint8 Texel[32];
	if (View->IsTexture())
	{
		const FKernelTexture Texture = View->GetKernelTexture();
		View->GetTexture()->Touch();
		const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
		if (Info.BitsPerChannel == 32)
		{
			std::memcpy(Texel, Channels, sizeof(Channels)); // float texels receive the bits, as on GPUs
		}
		else
		{
			checkf(Info.Kind == ETexelKind::Uint,
				TEXT("ClearUAVUint: texture %s is stored as %s, which holds no integers"),
				*View->GetTexture()->GetName().ToString(), Info.Name);
			EncodeTexel(Texture.Storage, Channels, Texel);
		}
		return FillKernelView(Texture, Texel);
	}
	const FKernelBuffer Buffer = View->GetKernelBuffer();
	const FTexelStorageInfo& Info = GetTexelStorageInfo(View->IsTyped() ? Buffer.Storage : ETexelStorage::R32_UINT);
	checkf(Info.Kind == ETexelKind::Uint || Info.BitsPerChannel == 32,
		TEXT("ClearUAVUint: buffer %s is viewed as %s, which holds no integers"),
		*View->GetBuffer()->GetName().ToString(), Info.Name);
	if (Info.Kind == ETexelKind::Uint)
	{
		EncodeTexel(View->IsTyped() ? Buffer.Storage : ETexelStorage::R32_UINT, Channels, Texel);
	}
	else
	{
		std::memcpy(Texel, Channels, sizeof(Channels));
	}
	return FillKernelBuffer(Buffer, Texel, Info.BytesPerTexel);
}

} // namespace Drydock
