// The pixels of a texture that code draws to.
#include "Engine/TextureRenderTarget2D.h"

#include "Engine/BlendableInterface.h"
#include "Engine/TextureRenderTargetVolume.h"
#include "Kismet/KismetRenderingLibrary.h"
#include "RenderGraphUtils.h"

#include <map>

namespace
{

void Fill(FRHITexture& Texture, const FLinearColor& Color, FIntPoint Size)
{
	TArray<FLinearColor> Row;
	Row.Init(Color, Size.X);
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		Texture.WriteRow(0, Y, Row);
	}
}

/** All of a target where the rectangle is empty. */
template<typename T>
bool ReadTexels(const FRenderTarget& Target, TArray<T>& OutTexels, FReadSurfaceDataFlags Flags, FIntRect Rect)
{
	const FTextureRHIRef& Texture = Target.GetRenderTargetTexture();
	if (!Texture)
	{
		return false;
	}
	FRHICommandListExecutor::GetImmediateCommandList().ReadSurfaceData(
		Texture, Rect.IsEmpty() ? FIntRect(FIntPoint::ZeroValue, Target.GetSizeXY()) : Rect, OutTexels, Flags);
	return true;
}

} // namespace

EPixelFormat GetPixelFormatFromRenderTargetFormat(ETextureRenderTargetFormat Format)
{
	static const std::map<ETextureRenderTargetFormat, EPixelFormat> Formats = {{RTF_R8, PF_G8}, {RTF_RG8, PF_R8G8},
		{RTF_RGBA8, PF_B8G8R8A8}, {RTF_RGBA8_SRGB, PF_B8G8R8A8}, {RTF_R16f, PF_R16F}, {RTF_RG16f, PF_G16R16F},
		{RTF_RGBA16f, PF_FloatRGBA}, {RTF_R32f, PF_R32_FLOAT}, {RTF_RG32f, PF_G32R32F}, {RTF_RGBA32f, PF_A32B32G32R32F},
		{RTF_RGB10A2, PF_A2B10G10R10}};
	const auto Found = Formats.find(Format);
	return Found == Formats.end() ? PF_Unknown : Found->second;
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
		Fill(*TargetResource->TextureRHI, ClearColor, FIntPoint(SizeX, SizeY));
	}
	SetResource(TargetResource.get());
}

void UTextureRenderTargetVolume::Init(int32 InSizeX, int32 InSizeY, int32 InSizeZ, EPixelFormat InFormat)
{
	SizeX = InSizeX;
	SizeY = InSizeY;
	SizeZ = InSizeZ;
	Format = InFormat;
	UpdateResourceImmediate(true);
}

void UTextureRenderTargetVolume::UpdateResourceImmediate(bool bClearRenderTarget)
{
	SetResource(nullptr);
	TargetResource.reset();
	if (SizeX <= 0 || SizeY <= 0 || SizeZ <= 0)
	{
		return;
	}
	const ETextureCreateFlags UAVFlag = bCanCreateUAV ? ETextureCreateFlags::UAV : ETextureCreateFlags::None;
	TargetResource = std::make_shared<FTextureRenderTargetResource>();
	TargetResource->TextureRHI = new FRHITexture(
		FRHITextureDesc::Create3D(FIntVector(SizeX, SizeY, SizeZ), Format, FClearValueBinding(ClearColor),
			ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | UAVFlag),
		TEXT("TextureRenderTargetVolume"));
	if (bClearRenderTarget)
	{
		TargetResource->TextureRHI->Fill(ClearColor);
	}
	SetResource(TargetResource.get());
}

bool FRenderTarget::ReadPixels(TArray<FColor>& OutImageData, FReadSurfaceDataFlags Flags, FIntRect Rect) const
{
	return ReadTexels(*this, OutImageData, Flags, Rect);
}

bool FRenderTarget::ReadLinearColorPixels(
	TArray<FLinearColor>& OutImageData, FReadSurfaceDataFlags Flags, FIntRect Rect) const
{
	return ReadTexels(*this, OutImageData, Flags, Rect);
}

FRenderTarget::~FRenderTarget() = default;

FRDGTextureRef FRenderTarget::GetRenderTargetTexture(FRDGBuilder& GraphBuilder) const
{
	const FTextureRHIRef& Texture = GetRenderTargetTexture();
	return Texture ? RegisterExternalTexture(GraphBuilder, Texture, TEXT("RenderTarget")) : nullptr;
}

IBlendableInterface::~IBlendableInterface() = default;

void IBlendableInterface::OverrideBlendableSettings(FSceneView&, float) const {}

UTextureRenderTarget2D* UKismetRenderingLibrary::CreateRenderTarget2D(UObject* WorldContextObject, int32 Width,
	int32 Height, ETextureRenderTargetFormat Format, FLinearColor ClearColor, bool bAutoGenerateMipMaps,
	bool bSupportUAVs)
{
	if (Width <= 0 || Height <= 0)
	{
		return nullptr;
	}
	UTextureRenderTarget2D* const Target = NewObject<UTextureRenderTarget2D>(WorldContextObject);
	Target->RenderTargetFormat = Format;
	Target->ClearColor = ClearColor;
	Target->bAutoGenerateMips = bAutoGenerateMipMaps;
	Target->bCanCreateUAV = bSupportUAVs;
	Target->InitAutoFormat(Width, Height);
	return Target;
}

void UKismetRenderingLibrary::ReleaseRenderTarget2D(UTextureRenderTarget2D* TextureRenderTarget)
{
	if (TextureRenderTarget != nullptr)
	{
		TextureRenderTarget->SizeX = 0;
		TextureRenderTarget->SizeY = 0;
		TextureRenderTarget->UpdateResource();
	}
}

void UKismetRenderingLibrary::ClearRenderTarget2D(
	UObject*, UTextureRenderTarget2D* TextureRenderTarget, FLinearColor ClearColor)
{
	const FTextureRenderTargetResource* const Resource =
		TextureRenderTarget != nullptr ? TextureRenderTarget->GetRenderTargetResource() : nullptr;
	if (Resource != nullptr)
	{
		Fill(*Resource->TextureRHI, ClearColor, Resource->GetSizeXY());
	}
}

void UKismetRenderingLibrary::DrawMaterialToRenderTarget(UObject*, UTextureRenderTarget2D*, UMaterialInterface*)
{
	UE_LOG(LogRenderer, Warning, "DrawMaterialToRenderTarget draws nothing: no material is compiled here");
}
