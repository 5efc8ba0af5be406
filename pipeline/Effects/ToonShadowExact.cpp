// Runs the toon-shadow blur once more on 64-bit storage.
#include "Effects/ToonShadowExact.h"

#include "Picture/Picture.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "TextureLayout.h"
#include "Toon/ToonShadowBlur.h"

namespace Drydock
{

namespace
{

FScreenPassTexture RegisterShadow(FRDGBuilder& GraphBuilder, const FImage& ToonShadow)
{
	const FIntPoint Extent(ToonShadow.Width, ToonShadow.Height);
	const FRDGTextureDesc Desc =
		FRDGTextureDesc::Create2D(Extent, PF_R8G8B8A8, FClearValueBinding::None, TexCreate_ShaderResource);
	const FTextureRHIRef Texture = new FRHITexture(Desc, TEXT("ToonShadow"));
	for (int Y = 0; Y < Extent.Y; ++Y)
	{
		for (int X = 0; X < Extent.X; ++X)
		{
			Texture->WriteTexelDouble(X, Y, FVector4(ToonShadow.Get(X, Y, 0), ToonShadow.Get(X, Y, 1), 0.0, 0.0));
		}
	}
	return FScreenPassTexture(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("ToonShadow"))),
		FIntRect(FIntPoint(0, 0), Extent));
}

} // namespace

FImage BlurToonShadowExactly(const FImage& ToonShadow, const FFinalPostProcessSettings& Settings)
{
	const FScopedStorageOverride Storage(EStorageOverride::Float64);
	const FIntPoint Extent(ToonShadow.Width, ToonShadow.Height);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("ToonShadowExact"));
	const FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), Extent), Extent);
	FToonShadowBlurInputs Inputs =
		FToonShadowBlurInputs::FromSettings(Settings, RegisterShadow(GraphBuilder, ToonShadow));
	Inputs.Store = EToonShadowBlurStore::SixteenBit; // linear; the storage makes it 64 bit
	const FScreenPassTexture Blurred = AddToonShadowBlurPasses(GraphBuilder, View, Inputs);
	TRefCountPtr<IPooledRenderTarget> Extracted;
	GraphBuilder.QueueTextureExtraction(Blurred.Texture, &Extracted);
	GraphBuilder.Execute();
	return FPicture(Extracted, Blurred.ViewRect).ToImage();
}

} // namespace Drydock
