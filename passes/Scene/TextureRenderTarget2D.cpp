// The pixels of a texture that code draws to.
#include "Engine/TextureRenderTarget2D.h"

#include "Engine/BlendableInterface.h"
#include "RenderGraphUtils.h"

EPixelFormat GetPixelFormatFromRenderTargetFormat(ETextureRenderTargetFormat Format)
{
	switch (Format)
	{
	case RTF_R8:
		return PF_G8;
	case RTF_RG8:
		return PF_R8G8;
	case RTF_RGBA8:
	case RTF_RGBA8_SRGB:
		return PF_B8G8R8A8;
	case RTF_R16f:
		return PF_R16F;
	case RTF_RG16f:
		return PF_G16R16F;
	case RTF_RGBA16f:
		return PF_FloatRGBA;
	case RTF_R32f:
		return PF_R32_FLOAT;
	case RTF_RG32f:
		return PF_G32R32F;
	case RTF_RGBA32f:
		return PF_A32B32G32R32F;
	case RTF_RGB10A2:
		return PF_A2B10G10R10;
	}
	return PF_Unknown;
}

FTextureRenderTargetResource* UTextureRenderTarget::GetRenderTargetResource() const
{
	return static_cast<FTextureRenderTargetResource*>(GetResource());
}

UTextureRenderTarget2D::UTextureRenderTarget2D() = default;

UTextureRenderTarget2D::~UTextureRenderTarget2D() = default;

EPixelFormat UTextureRenderTarget2D::GetFormat() const
{
	return OverrideFormat != PF_Unknown ? OverrideFormat : GetPixelFormatFromRenderTargetFormat(RenderTargetFormat);
}

void UTextureRenderTarget2D::InitAutoFormat(int32 InSizeX, int32 InSizeY)
{
	SizeX = InSizeX;
	SizeY = InSizeY;
	OverrideFormat = PF_Unknown;
	UpdateResource();
}

void UTextureRenderTarget2D::InitCustomFormat(int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, bool)
{
	SizeX = InSizeX;
	SizeY = InSizeY;
	OverrideFormat = InFormat;
	UpdateResource();
}

void UTextureRenderTarget2D::UpdateResource()
{
	UpdateResourceImmediate(true);
}

void UTextureRenderTarget2D::UpdateResourceImmediate(bool bClearRenderTarget)
{
	SetResource(nullptr);
	TargetResource.reset();
	if (SizeX <= 0 || SizeY <= 0)
	{
		return;
	}
	const ETextureCreateFlags UAVFlag = bCanCreateUAV ? ETextureCreateFlags::UAV : ETextureCreateFlags::None;
	TargetResource = std::make_unique<FTextureRenderTargetResource>();
	TargetResource->TextureRHI =
		new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(SizeX, SizeY), GetFormat(), FClearValueBinding(ClearColor),
							ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | UAVFlag),
			TEXT("TextureRenderTarget2D"));
	if (bClearRenderTarget)
	{
		TArray<FLinearColor> Row;
		Row.Init(ClearColor, SizeX);
		for (int32 Y = 0; Y < SizeY; ++Y)
		{
			TargetResource->TextureRHI->WriteRow(0, Y, Row);
		}
	}
	SetResource(TargetResource.get());
}

FRenderTarget::~FRenderTarget() = default;

IBlendableInterface::~IBlendableInterface() = default;

void IBlendableInterface::OverrideBlendableSettings(FSceneView&, float) const {}
