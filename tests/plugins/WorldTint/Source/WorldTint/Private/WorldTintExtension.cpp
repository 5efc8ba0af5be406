// Asks the world of the family for its subsystem on the game thread, and draws on the render thread: a multiplying
// blend over scene colour.
#include "WorldTintExtension.h"

#include "Engine/World.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessInputs.h"
#include "SceneInterface.h"
#include "ScenePrivate.h"
#include "WorldTintSubsystem.h"

namespace
{

class FWorldTintPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FWorldTintPS);
	SHADER_USE_PARAMETER_STRUCT(FWorldTintPS, FGlobalShader);
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, Tint)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FWorldTintPS, "/Plugin/WorldTint/WorldTint.usf", "WorldTintPS", SF_Pixel);

} // namespace

FWorldTintExtension::FWorldTintExtension(const FAutoRegister& AutoRegister, UWorld* InWorld)
	: FWorldSceneViewExtension(AutoRegister, InWorld)
{
}

void FWorldTintExtension::BeginRenderViewFamily(FSceneViewFamily& InViewFamily)
{
	const UWorld* World = InViewFamily.Scene ? InViewFamily.Scene->GetWorld() : nullptr;
	if (const UWorldTintSubsystem* Subsystem = World ? World->GetSubsystem<UWorldTintSubsystem>() : nullptr)
	{
		const UWorldTintAsset* Asset = Subsystem->GetAsset();
		const FLinearColor Tint =
			IsValid(Asset) && Asset->Mode == EWorldTintMode::Multiply ? Asset->Tint : FLinearColor::White;
		ENQUEUE_RENDER_COMMAND(WorldTint)
		([this, Tint](FRHICommandListImmediate& RHICmdList) { Tint_RenderThread = Tint; });
	}
}

void FWorldTintExtension::PrePostProcessPass_RenderThread(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs)
{
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	FWorldTintPS::FParameters* Parameters = GraphBuilder.AllocParameters<FWorldTintPS::FParameters>();
	Parameters->Tint = FVector4f(Tint_RenderThread);
	Parameters->RenderTargets[0] =
		FRenderTargetBinding(Inputs.SceneTextures->GetParameters()->SceneColorTexture, ERenderTargetLoadAction::ELoad);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ViewInfo.ShaderMap, RDG_EVENT_NAME("WorldTint"),
		TShaderMapRef<FWorldTintPS>(ViewInfo.ShaderMap), Parameters, ViewInfo.ViewRect,
		TStaticBlendState<CW_RGB, BO_Add, BF_DestColor, BF_Zero>::GetRHI());
}
