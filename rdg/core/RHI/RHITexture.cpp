// Allocates the memory of textures, with their mip tables, and reads and writes single texels.
#include "RHITexture.h"

#include "DiagnosticList.h"
#include "HugePages.h"
#include "PixelFormatConversion.h"
#include "TexelRows.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

FRHIResource::~FRHIResource() = default;

namespace Drydock
{

FResourceMemory::~FResourceMemory()
{
	std::free(Owned);
}

void FResourceMemory::PlaceAt(void* Memory)
{
	checkf(reinterpret_cast<uintptr_t>(Memory) % GTextureAlignment == 0,
		TEXT("a resource must be placed at a multiple of 64 bytes"));
	std::free(Owned);
	Owned = nullptr;
	Data = static_cast<uint8*>(Memory);
}

void FResourceMemory::Ensure(size_t Size)
{
	if (Data)
	{
		return;
	}
	// calloc, not aligned_alloc and memset: the system hands out zero pages lazily.
	Owned = std::calloc(1, Size + GTextureAlignment);
	if (!Owned)
	{
		throw std::bad_alloc();
	}
	AskForHugePages(Owned, Size + GTextureAlignment);
	const uintptr_t Address = reinterpret_cast<uintptr_t>(Owned);
	Data = static_cast<uint8*>(Owned) + (GTextureAlignment - Address % GTextureAlignment) % GTextureAlignment;
}

} // namespace Drydock

FRHITexture::FRHITexture(const FRHITextureDesc& InDesc, const TCHAR* InName)
	: FRHIViewableResource(InName)
	, Desc(InDesc)
{
	FString Reason;
	const bool bValid = Desc.IsValid(&Reason);
	checkf(bValid, TEXT("texture %s cannot be created: %s"), InName, *Reason);
	Layout = Drydock::ComputeTextureLayout(Desc);

	const int32 NumSlices = Layout.Planes[0].Mips[0].SizeZ;
	MipTables.resize(Layout.Planes.size());
	for (std::vector<Drydock::FKernelMip>& Table : MipTables)
	{
		Table.resize(size_t(Desc.NumMips) * (1 + NumSlices));
	}
}

FIntVector FRHITexture::GetMipDimensions(uint8 MipIndex) const
{
	const Drydock::FTextureMipLayout& Mip = GetMipLayout(MipIndex);
	return FIntVector(Mip.SizeX, Mip.SizeY, Desc.IsTexture3D() ? Mip.SizeZ : 1);
}

size_t FRHITexture::ComputeSize(const FRHITextureDesc& Desc)
{
	return Drydock::ComputeTextureSize(Desc);
}

void FRHITexture::PlaceAt(void* InMemory)
{
	Memory.PlaceAt(InMemory);
	Touch();
	RebuildMipTables();
}

void FRHITexture::EnsureMemory()
{
	if (HasMemory())
	{
		return;
	}
	try
	{
		Memory.Ensure(Layout.SizeInBytes);
	}
	catch (const std::bad_alloc&)
	{
		const FIntVector Size = GetMipDimensions(0);
		throw Drydock::MakeMemoryError("the texture " + GetName().ToString().ToStdString() + ", " +
										   std::to_string(Size.X) + " x " + std::to_string(Size.Y),
			Layout.SizeInBytes);
	}
	RebuildMipTables();
}

TRefCountPtr<FRHITexture> FRHITexture::Clone()
{
	TRefCountPtr<FRHITexture> Copy = new FRHITexture(Desc, *GetName().ToString());
	Copy->Layout = Layout; // r.Drydock.Storage may be another one by now
	Copy->CopyFrom(*this);
	return Copy;
}

void FRHITexture::CopyFrom(FRHITexture& Source)
{
	check(Source.Layout.SizeInBytes == Layout.SizeInBytes);
	Source.EnsureMemory();
	EnsureMemory();
	Touch();
	std::memcpy(Memory.Get(), Source.Memory.Get(), Layout.SizeInBytes);
}

void FRHITexture::RebuildMipTables()
{
	for (size_t Plane = 0; Plane < Layout.Planes.size(); ++Plane)
	{
		const int32 NumMips = Desc.NumMips;
		for (int32 Mip = 0; Mip < NumMips; ++Mip)
		{
			const Drydock::FTextureMipLayout& From = Layout.Planes[Plane].Mips[Mip];
			uint8* const Data = Memory.Get() ? Memory.Get() + From.Offset : nullptr;
			std::vector<Drydock::FKernelMip>& Table = MipTables[Plane];
			Table[Mip] = {Data, From.SizeX, From.SizeY, From.SizeZ, From.RowPitch, From.SlicePitch};
			// Small mips of a 3D texture have fewer slices than the table has room for: those entries stay empty.
			for (int32 Slice = 0; Data && Slice < From.SizeZ; ++Slice)
			{
				Table[size_t(1 + Slice) * NumMips + Mip] = {
					Data + Slice * From.SlicePitch, From.SizeX, From.SizeY, 1, From.RowPitch, From.SlicePitch};
			}
		}
	}
}

Drydock::FKernelTexture FRHITexture::GetKernelView(int32 FirstMip, int32 NumMips, int32 Slice, int32 Plane)
{
	EnsureMemory();
	const int32 ViewMips = NumMips < 0 ? Desc.NumMips - FirstMip : NumMips;
	checkf(FirstMip >= 0 && ViewMips > 0 && FirstMip + ViewMips <= Desc.NumMips,
		TEXT("texture %s has no mips %d to %d"), *GetName().ToString(), FirstMip, FirstMip + ViewMips - 1);
	checkf(Plane >= 0 && Plane < GetNumPlanes(), TEXT("texture %s has no stencil"), *GetName().ToString());
	checkf(Slice < GetMipLayout(FirstMip).SizeZ, TEXT("texture %s has no slice %d"), *GetName().ToString(), Slice);

	Drydock::FKernelTexture View{};
	View.Mips = MipTables[Plane].data() + size_t(Slice < 0 ? 0 : 1 + Slice) * Desc.NumMips + FirstMip;
	View.NumMips = ViewMips;
	View.Storage = GetStorage(Plane);
	View.bIs3D = Slice < 0 && Desc.IsTexture3D();
	View.bSaturateStore = Drydock::IsStoreOverflowSaturated();
	return View;
}

uint8* FRHITexture::FindTexel(int32 X, int32 Y, int32 Mip, int32 Z, int32 Plane)
{
	EnsureMemory();
	checkf(Mip >= 0 && Mip < Desc.NumMips && Plane >= 0 && Plane < GetNumPlanes(),
		TEXT("texture %s has no mip %d, plane %d"), *GetName().ToString(), Mip, Plane);
	const Drydock::FTextureMipLayout& At = GetMipLayout(Mip, Plane);
	checkf(X >= 0 && X < At.SizeX && Y >= 0 && Y < At.SizeY && Z >= 0 && Z < At.SizeZ,
		TEXT("texel (%d, %d, %d) lies outside mip %d of texture %s"), X, Y, Z, Mip, *GetName().ToString());
	const size_t TexelBytes = Drydock::GetTexelStorageInfo(GetStorage(Plane)).BytesPerTexel;
	return Memory.Get() + At.Offset + Z * At.SlicePitch + int64(Y) * At.RowPitch + X * TexelBytes;
}

FLinearColor FRHITexture::ReadTexel(int32 X, int32 Y, int32 Mip, int32 Z)
{
	float Value[4];
	Drydock::DecodeTexel(GetStorage(), GetTexelToRead(X, Y, Mip, Z), Value);
	return FLinearColor(Value[0], Value[1], Value[2], Value[3]);
}

void FRHITexture::WriteTexel(int32 X, int32 Y, const FLinearColor& Value, int32 Mip, int32 Z)
{
	const float Channels[4] = {Value.R, Value.G, Value.B, Value.A};
	Drydock::EncodeTexel(GetStorage(), Channels, GetTexel(X, Y, Mip, Z), Drydock::IsStoreOverflowSaturated());
}

FVector4 FRHITexture::ReadTexelDouble(int32 X, int32 Y, int32 Mip, int32 Z)
{
	double Value[4];
	Drydock::DecodeTexel(GetStorage(), GetTexelToRead(X, Y, Mip, Z), Value);
	return FVector4(Value[0], Value[1], Value[2], Value[3]);
}

void FRHITexture::WriteTexelDouble(int32 X, int32 Y, const FVector4& Value, int32 Mip, int32 Z)
{
	const double Channels[4] = {Value.X, Value.Y, Value.Z, Value.W};
	Drydock::EncodeTexel(GetStorage(), Channels, GetTexel(X, Y, Mip, Z), Drydock::IsStoreOverflowSaturated());
}

FUintVector4 FRHITexture::ReadTexelUint(int32 X, int32 Y, int32 Mip, int32 Z)
{
	checkf(IsInteger(Desc.Format), TEXT("texture %s does not hold integers"), *GetName().ToString());
	uint32_t Value[4];
	Drydock::DecodeTexel(GetStorage(), GetTexelToRead(X, Y, Mip, Z), Value);
	return FUintVector4(Value[0], Value[1], Value[2], Value[3]);
}

void FRHITexture::WriteTexelUint(int32 X, int32 Y, const FUintVector4& Value, int32 Mip, int32 Z)
{
	checkf(IsInteger(Desc.Format), TEXT("texture %s does not hold integers"), *GetName().ToString());
	const uint32_t Channels[4] = {Value.X, Value.Y, Value.Z, Value.W};
	Drydock::EncodeTexel(GetStorage(), Channels, GetTexel(X, Y, Mip, Z));
}

void FRHITexture::ReadRow(int32 X, int32 Y, TArrayView<FLinearColor> OutColors, int32 Mip, int32 Z)
{
	if (OutColors.Num() == 0)
	{
		return;
	}
	GetTexelToRead(X + OutColors.Num() - 1, Y, Mip, Z); // checks the far end
	static_assert(sizeof(FLinearColor) == 4 * sizeof(float));
	Drydock::DecodeTexelRow(GetStorage(), GetTexelToRead(X, Y, Mip, Z), OutColors.Num(), 4, &OutColors[0].R);
}

void FRHITexture::WriteRow(int32 X, int32 Y, TConstArrayView<FLinearColor> Colors, int32 Mip, int32 Z)
{
	if (Colors.Num() == 0)
	{
		return;
	}
	GetTexel(X + Colors.Num() - 1, Y, Mip, Z); // checks the far end
	Drydock::EncodeTexelRow(
		GetStorage(), &Colors[0].R, Colors.Num(), GetTexel(X, Y, Mip, Z), Drydock::IsStoreOverflowSaturated());
}

void FRHITexture::Fill(const FLinearColor& Value)
{
	const float Channels[4] = {Value.R, Value.G, Value.B, Value.A};
	uint8 Texel[32];
	Drydock::EncodeTexel(GetStorage(), Channels, Texel, Drydock::IsStoreOverflowSaturated());
	for (int32 Mip = 0; Mip < Desc.NumMips; ++Mip)
	{
		const Drydock::FTextureMipLayout& At = GetMipLayout(Mip);
		FillRect(Texel, FIntRect(0, 0, At.SizeX, At.SizeY), Mip);
	}
}

void FRHITexture::FillRect(const void* Texel, FIntRect Rect, int32 Mip, int32 Slice, int32 Plane)
{
	if (Rect.Width() <= 0 || Rect.Height() <= 0)
	{
		return;
	}
	FindTexel(Rect.Max.X - 1, Rect.Max.Y - 1, Mip, std::max(0, Slice), Plane); // checks the far corner
	const Drydock::FTextureMipLayout& At = GetMipLayout(Mip, Plane);
	const size_t TexelBytes = Drydock::GetTexelStorageInfo(GetStorage(Plane)).BytesPerTexel;
	const size_t RowBytes = size_t(Rect.Width()) * TexelBytes;

	const int32 FirstSlice = Slice < 0 ? 0 : Slice;
	const int32 LastSlice = Slice < 0 ? At.SizeZ - 1 : Slice;
	uint8* const FirstRow = FindTexel(Rect.Min.X, Rect.Min.Y, Mip, FirstSlice, Plane);
	for (size_t Byte = 0; Byte < RowBytes; Byte += TexelBytes)
	{
		std::memcpy(FirstRow + Byte, Texel, TexelBytes);
	}
	for (int32 Z = FirstSlice; Z <= LastSlice; ++Z)
	{
		for (int32 Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
		{
			uint8* const Row = FindTexel(Rect.Min.X, Y, Mip, Z, Plane);
			if (Row != FirstRow)
			{
				std::memcpy(Row, FirstRow, RowBytes);
			}
		}
	}

	// Cheaper than a look at the texels, and another hash than that gives.
	Drydock::FMemoryHash Hash;
	if (Rect == FIntRect(0, 0, At.SizeX, At.SizeY) && (Slice < 0 || At.SizeZ == 1))
	{
		Drydock::FMemoryHasher Hasher;
		Hasher.Add(Texel, TexelBytes);
		Hash = Hasher.Get();
	}
	SetMipHash(Mip, Plane, Hash);
}

namespace
{

std::atomic<uint64> GTimesForgotten{1};

} // namespace

void FRHITexture::ForgetMipHashes()
{
	GTimesForgotten.fetch_add(1, std::memory_order_relaxed);
}

bool FRHITexture::FindMip(const uint8* Address, int32& OutMip, int32& OutPlane) const
{
	for (OutPlane = 0; OutPlane < GetNumPlanes(); ++OutPlane)
	{
		for (OutMip = 0; OutMip < int32(Desc.NumMips); ++OutMip)
		{
			const Drydock::FTextureMipLayout& At = GetMipLayout(OutMip, OutPlane);
			const uint8* const First = Memory.Get() + At.Offset;
			if (Memory.Get() && Address >= First && Address < First + At.SlicePitch * At.SizeZ)
			{
				return true;
			}
		}
	}
	return false;
}

Drydock::FMemoryHash FRHITexture::GetMipHash(int32 Mip, int32 Plane)
{
	const size_t Index = size_t(Plane) * Desc.NumMips + size_t(Mip);
	if (!bTouched && MipHashesSince == GTimesForgotten && MipHashes[Index].IsKnown())
	{
		return MipHashes[Index];
	}
	uint8* const First = FindTexel(0, 0, Mip, 0, Plane);
	const Drydock::FTextureMipLayout& At = GetMipLayout(Mip, Plane);
	const size_t TexelBytes = Drydock::GetTexelStorageInfo(GetStorage(Plane)).BytesPerTexel;
	SetMipHash(Mip, Plane,
		Drydock::HashTexels({First, size_t(At.SizeX) * TexelBytes, At.SizeY, At.SizeZ, At.RowPitch, At.SlicePitch}));
	return MipHashes[Index];
}

void FRHITexture::SetMipHash(int32 Mip, int32 Plane, const Drydock::FMemoryHash& Hash)
{
	const uint64 Forgotten = GTimesForgotten;
	if (bTouched || MipHashesSince != Forgotten || MipHashes.empty())
	{
		MipHashes.assign(Layout.Planes.size() * Desc.NumMips, {});
		MipHashesSince = Forgotten;
		bTouched = false;
	}
	MipHashes[size_t(Plane) * Desc.NumMips + size_t(Mip)] = Hash;
}
