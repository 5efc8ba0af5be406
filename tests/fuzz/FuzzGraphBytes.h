// What calls on the render graph are called with, decoded from bytes: numbers, descriptions, accesses and flags, sound
// ones and others.
#pragma once

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"

namespace Drydock
{

/** Reads on from byte to byte; beyond the last one all are 0. */
class FCallBytes
{
public:
	FCallBytes(const uint8_t* InData, size_t InSize)
		: Data(InData)
		, Size(InSize)
	{
	}

	bool IsAtEnd() const { return At >= Size; }

	uint8 Byte() { return At < Size ? Data[At++] : 0; }

	/** Mostly small, now and then far off. */
	int32 Number()
	{
		const int8 Value = int8(Byte());
		return Value > 100 ? Value << 20 : Value < -100 ? Value << 20 : Value / 4;
	}

	FRDGTextureDesc MakeTextureDesc()
	{
		static constexpr EPixelFormat Formats[] = {PF_FloatRGBA, PF_R32_FLOAT, PF_R8G8B8A8, PF_DepthStencil,
			PF_R32_UINT, PF_FloatR11G11B10, PF_R8, PF_A32B32G32R32F};
		const uint8 Kind = Byte();
		const uint8 Shape = Byte();
		const FIntPoint Extent((Shape & 15) + ((Kind & 64) != 0 ? 0 : 1), (Shape >> 4) + 1);
		const EPixelFormat Format = (Kind & 128) != 0 ? EPixelFormat(Byte()) : Formats[Kind & 7];
		const uint8 More = Byte();
		ETextureCreateFlags Flags = TexCreate_ShaderResource;
		Flags |= (More & 1) != 0 ? TexCreate_None : TexCreate_RenderTargetable;
		Flags |= (More & 2) != 0 ? TexCreate_None : TexCreate_UAV;
		Flags |= IsDepthOrStencilFormat(Format) ? TexCreate_DepthStencilTargetable : TexCreate_None;
		const FClearValueBinding Clear = (More & 4) != 0 ? FClearValueBinding::None : FClearValueBinding::Black;
		const uint8 NumMips = uint8((More >> 3) & 7);
		switch ((Kind >> 3) & 7)
		{
		case 1:
			return FRDGTextureDesc::Create2DArray(Extent, Format, Clear, Flags, uint16(More >> 6), NumMips);
		case 2:
			return FRDGTextureDesc::Create3D(
				FIntVector(Extent.X, Extent.Y, More >> 6), Format, Clear, Flags, uint8(NumMips));
		case 3:
			return FRDGTextureDesc::CreateCube(uint32(Extent.X), Format, Clear, Flags, NumMips);
		case 4:
			return FRDGTextureDesc::Create2D(Extent, Format, Clear, Flags, NumMips, uint8(1 << (More >> 6)));
		default:
			return FRDGTextureDesc::Create2D(Extent, Format, Clear, Flags, uint8(NumMips + 1));
		}
	}

	FRHICopyTextureInfo MakeCopyInfo()
	{
		FRHICopyTextureInfo Info;
		const uint8 Which = Byte();
		if ((Which & 1) != 0)
		{
			Info.Size = FIntVector(Number(), Number(), Number());
		}
		if ((Which & 2) != 0)
		{
			Info.SourcePosition = FIntVector(Number(), Number(), Number());
		}
		if ((Which & 4) != 0)
		{
			Info.DestPosition = FIntVector(Number(), Number(), Number());
		}
		if ((Which & 8) != 0)
		{
			Info.SourceMipIndex = uint32(Number());
			Info.DestMipIndex = uint32(Number());
			Info.NumMips = uint32(Number());
		}
		if ((Which & 16) != 0)
		{
			Info.SourceSliceIndex = uint32(Number());
			Info.DestSliceIndex = uint32(Number());
			Info.NumSlices = uint32(Number());
		}
		return Info;
	}

	ERHIAccess MakeAccess()
	{
		const uint8 Value = Byte();
		return (Value & 128) != 0 ? ERHIAccess(uint32(Value & 127) << (Byte() & 15)) : ERHIAccess(1u << (Value % 19));
	}

	ERDGPassFlags MakePassFlags(ERDGPassFlags Usual)
	{
		const uint8 Value = Byte();
		return Value < 128 ? Usual | (Value < 32 ? ERDGPassFlags::NeverCull : ERDGPassFlags::None)
						   : ERDGPassFlags(uint16(Value & 127) | uint16((Byte() & 3) << 7));
	}

private:
	const uint8_t* Data;
	size_t Size;
	size_t At = 0;
};

} // namespace Drydock
