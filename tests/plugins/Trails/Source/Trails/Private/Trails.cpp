// A texture kept between frames: each frame is mixed with the one before.
#include "HAL/IConsoleManager.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RenderTargetPool.h"
#include "SceneViewExtension.h"

static float GTrailsGain = 1.0f;
static FAutoConsoleVariableRef CVarTrailsGain(
	TEXT("r.Trails.Gain"), GTrailsGain, TEXT("How bright a new frame is."), ECVF_RenderThreadSafe);

class FTrailsPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTrailsPS);
	SHADER_USE_PARAMETER_STRUCT(FTrailsPS, FGlobalShader);

	class FHasHistory : SHADER_PERMUTATION_BOOL("HAS_HISTORY");
	using FPermutationDomain = TShaderPermutationDomain<FHasHistory>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Current)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, History)
		SHADER_PARAMETER(float, Gain)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTrailsPS, "/Plugin/Trails/Trails.usf", "TrailsPS", SF_Pixel);

class FTrailsExtension : public FSceneViewExtensionBase
{
public:
	FTrailsExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FTrailsExtension::Mix));
		}
	}

private:
	FScreenPassTexture Mix(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		TRefCountPtr<IPooledRenderTarget>& History = Histories.FindOrAdd(View.State ? View.State->GetViewKey() : 0);
		const bool bHistory = History.IsValid() && History->GetDesc().Extent == SceneColor.Texture->Desc.Extent;

		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Flags = TexCreate_RenderTargetable | TexCreate_ShaderResource;
		FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("Trails"), ERDGTextureFlags::MultiFrame);

		FTrailsPS::FParameters* Parameters = GraphBuilder.AllocParameters<FTrailsPS::FParameters>();
		Parameters->Current = SceneColor.Texture;
		Parameters->History = bHistory ? GraphBuilder.RegisterExternalTexture(History, TEXT("TrailsHistory")) : nullptr;
		Parameters->Gain = GTrailsGain;
		Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);

		FTrailsPS::FPermutationDomain PermutationVector;
		PermutationVector.Set<FTrailsPS::FHasHistory>(bHistory);
		FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.GetFeatureLevel());
		TShaderMapRef<FTrailsPS> PixelShader(ShaderMap, PermutationVector);
		FPixelShaderUtils::AddFullscreenPass(
			GraphBuilder, ShaderMap, RDG_EVENT_NAME("Trails"), PixelShader, Parameters, SceneColor.ViewRect);
		GraphBuilder.QueueTextureExtraction(Output, &History);
		return FScreenPassTexture(Output, SceneColor.ViewRect);
	}

	TMap<uint32, TRefCountPtr<IPooledRenderTarget>> Histories;
};

class FTrailsModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FTrailsExtension>(); }
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FTrailsExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FTrailsModule, Trails)
