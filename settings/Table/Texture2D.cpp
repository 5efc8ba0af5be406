// A texture with bytes of its own: the texture that shaders read is made of them.
#include "Engine/Texture.h"
#include "RHICommandList.h"
#include "TextureResource.h"

float UTexture2D::GetSurfaceWidth() const
{
	return PlatformData ? float(PlatformData->SizeX) : 0.0f;
}

float UTexture2D::GetSurfaceHeight() const
{
	return PlatformData ? float(PlatformData->SizeY) : 0.0f;
}

UTexture2D* UTexture2D::CreateTransient(int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, FName InName)
{
	if (InSizeX <= 0 || InSizeY <= 0)
	{
		return nullptr;
	}
	UTexture2D* const Texture = NewObject<UTexture2D>(nullptr, InName);
	Texture->PlatformData = std::make_shared<FTexturePlatformData>();
	FTexturePlatformData& Data = *Texture->PlatformData;
	Data.SizeX = InSizeX;
	Data.SizeY = InSizeY;
	Data.PixelFormat = InFormat;
	Data.Mips.AddDefaulted();
	Data.Mips[0].SizeX = InSizeX;
	Data.Mips[0].SizeY = InSizeY;
	Data.Mips[0].BulkData.Realloc(int64(InSizeX) * InSizeY * GPixelFormats[InFormat].BlockBytes);
	return Texture;
}

void UTexture2D::UpdateResource()
{
	SetResource(nullptr);
	OwnResource.reset();
	if (!PlatformData)
	{
		return;
	}
	const FTexturePlatformData& Data = *PlatformData;
	const FIntPoint Size(Data.SizeX, Data.SizeY);
	const ETextureCreateFlags Flags = SRGB ? ETextureCreateFlags::SRGB : ETextureCreateFlags::None;
	OwnResource = std::make_shared<FTextureResource>();
	OwnResource->TextureRHI =
		new FRHITexture(FRHITextureDesc::Create2D(Size, Data.PixelFormat, FClearValueBinding::None,
							ETextureCreateFlags::ShaderResource | Flags),
			*GetName());
	RHIUpdateTexture2D(OwnResource->TextureRHI, 0, FUpdateTextureRegion2D(0, 0, 0, 0, uint32(Size.X), uint32(Size.Y)),
		uint32(Size.X * GPixelFormats[Data.PixelFormat].BlockBytes),
		static_cast<const uint8*>(Data.Mips[0].BulkData.LockReadOnly()));
	const auto GetMode = [](TextureAddress Address)
	{
		return Address == TA_Clamp ? AM_Clamp : Address == TA_Mirror ? AM_Mirror : AM_Wrap;
	};
	const ESamplerFilter Sampling = Filter == TF_Nearest    ? SF_Point
									: Filter == TF_Bilinear ? SF_Bilinear
															: SF_Trilinear;
	OwnResource->SamplerStateRHI =
		RHICreateSamplerState(FSamplerStateInitializerRHI(Sampling, GetMode(AddressX), GetMode(AddressY)));
	SetResource(OwnResource.get());
}
