// Writes the clobber value over a resource, in its own format.
#include "RenderGraphClobber.h"

#include "PixelFormatConversion.h"

#include <cstring>
#include <limits>

namespace Drydock
{

namespace
{

constexpr uint32 ClobberInteger = 1000;
constexpr float ClobberDepth = 0.123456789f;
constexpr uint8 ClobberStencil = 123;

float GetClobberValue(int32 Mode)
{
	return Mode == 2   ? std::numeric_limits<float>::quiet_NaN()
		   : Mode == 3 ? std::numeric_limits<float>::infinity()
					   : 1000.0f;
}

void FillPlane(FRHITexture& Texture, const void* Texel, int32 Plane)
{
	for (int32 Mip = 0; Mip < int32(Texture.GetNumMips()); ++Mip)
	{
		const FTextureMipLayout& Layout = Texture.GetMipLayout(Mip, Plane);
		Texture.FillRect(Texel, FIntRect(0, 0, Layout.SizeX, Layout.SizeY), Mip, -1, Plane);
	}
}

} // namespace

void ClobberTexture(FRHITexture& Texture, int32 Mode)
{
	Texture.EnsureMemory();
	uint8 Texel[32] = {}; // four doubles are the largest texel
	if (IsInteger(Texture.GetFormat()))
	{
		const uint32_t Value[4] = {ClobberInteger, ClobberInteger, ClobberInteger, ClobberInteger};
		EncodeTexel(Texture.GetStorage(), Value, Texel);
	}
	else
	{
		const float Channel = IsDepthOrStencilFormat(Texture.GetFormat()) ? ClobberDepth : GetClobberValue(Mode);
		const float Value[4] = {Channel, Channel, Channel, Channel};
		EncodeTexel(Texture.GetStorage(), Value, Texel);
	}
	FillPlane(Texture, Texel, 0);
	if (Texture.GetNumPlanes() > 1)
	{
		FillPlane(Texture, &ClobberStencil, 1);
	}
}

void ZeroTexture(FRHITexture& Texture)
{
	Texture.EnsureMemory();
	const uint8 Texel[32] = {};
	for (int32 Plane = 0; Plane < int32(Texture.GetNumPlanes()); ++Plane)
	{
		FillPlane(Texture, Texel, Plane);
	}
}

void ZeroBuffer(FRHIBuffer& Buffer)
{
	Buffer.EnsureMemory();
	std::memset(Buffer.GetData(), 0, Buffer.GetSize());
}

void ClobberBuffer(FRHIBuffer& Buffer, int32 Mode)
{
	Buffer.EnsureMemory();
	const float Value = GetClobberValue(Mode);
	uint8* const Data = Buffer.GetData();
	for (uint32 Byte = 0; Byte + sizeof(Value) <= Buffer.GetSize(); Byte += sizeof(Value))
	{
		std::memcpy(Data + Byte, &Value, sizeof(Value));
	}
}

} // namespace Drydock
