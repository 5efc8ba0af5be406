// Registers the plain textures of constant colour that every graph may read.
#include "SystemTextures.h"

#include "RenderGraphBlackboard.h"
#include "RenderTargetPool.h"

#include <mutex>

RDG_REGISTER_BLACKBOARD_STRUCT(FRDGSystemTextures);

FSystemTextures GSystemTextures;

namespace
{

FRDGTextureRef RegisterConstantTexture(FRDGBuilder& GraphBuilder, const TCHAR* Name, const FLinearColor& Color,
	bool bIs3D = false, EPixelFormat Format = PF_FloatRGBA, bool bIsCube = false)
{
	const ETextureCreateFlags Flags = TexCreate_ShaderResource;
	const FRHITextureDesc Desc =
		bIsCube ? FRHITextureDesc::CreateCube(1, Format, FClearValueBinding::None, Flags)
		: bIs3D ? FRHITextureDesc::Create3D(FIntVector(1, 1, 1), Format, FClearValueBinding::None, Flags)
				: FRHITextureDesc::Create2D(FIntPoint(1, 1), Format, FClearValueBinding::None, Flags);
	FTextureRHIRef Texture = new FRHITexture(Desc, Name);
	Texture->Fill(Color);
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Name));
}

} // namespace

const FRDGSystemTextures& FRDGSystemTextures::Get(FRDGBuilder& GraphBuilder)
{
	if (const FRDGSystemTextures* Registered = GraphBuilder.Blackboard.Get<FRDGSystemTextures>())
	{
		return *Registered;
	}
	FRDGSystemTextures& Textures = GraphBuilder.Blackboard.Create<FRDGSystemTextures>();
	Textures.White = RegisterConstantTexture(GraphBuilder, TEXT("WhiteDummy"), FLinearColor(1, 1, 1, 1));
	Textures.Black = RegisterConstantTexture(GraphBuilder, TEXT("BlackDummy"), FLinearColor(0, 0, 0, 0));
	Textures.BlackAlphaOne =
		RegisterConstantTexture(GraphBuilder, TEXT("BlackAlphaOneDummy"), FLinearColor(0, 0, 0, 1));
	Textures.MidGrey =
		RegisterConstantTexture(GraphBuilder, TEXT("MidGreyDummy"), FLinearColor(0.5f, 0.5f, 0.5f, 0.5f));
	Textures.Green = RegisterConstantTexture(GraphBuilder, TEXT("GreenDummy"), FLinearColor(0, 1, 0, 1));
	Textures.MaxFP16Depth =
		RegisterConstantTexture(GraphBuilder, TEXT("MaxFP16Depth"), FLinearColor(65504, 0, 0, 0), false, PF_R16F);
	Textures.DepthDummy =
		RegisterConstantTexture(GraphBuilder, TEXT("DepthDummy"), FLinearColor(0, 0, 0, 0), false, PF_R32_FLOAT);
	Textures.StencilDummy =
		RegisterConstantTexture(GraphBuilder, TEXT("StencilDummy"), FLinearColor(0, 0, 0, 0), false, PF_R8_UINT);
	Textures.StencilDummySRV = GraphBuilder.CreateSRV(FRDGTextureSRVDesc::Create(Textures.StencilDummy));
	Textures.VolumetricBlack =
		RegisterConstantTexture(GraphBuilder, TEXT("VolumetricBlackDummy"), FLinearColor(0, 0, 0, 0), true);
	Textures.VolumetricBlackAlphaOne =
		RegisterConstantTexture(GraphBuilder, TEXT("VolumetricBlackAlphaOneDummy"), FLinearColor(0, 0, 0, 1), true);
	Textures.CubeBlack = RegisterConstantTexture(
		GraphBuilder, TEXT("CubeBlackDummy"), FLinearColor(0, 0, 0, 0), false, PF_FloatRGBA, true);
	return Textures;
}

namespace Drydock
{

const TRefCountPtr<IPooledRenderTarget>& FPooledPlainTexture::Get() const
{
	static std::mutex Mutex;
	const std::lock_guard Lock(Mutex);
	if (Pooled == nullptr)
	{
		Pooled = new TRefCountPtr<IPooledRenderTarget>(CreateRenderTarget(Texture->TextureRHI, Name));
	}
	return *Pooled;
}

} // namespace Drydock
