// A plugin that is tuned from outside: by its ini files, by a config's "objects", and by settings of its own that
// volumes blend.
#include "Engine/Engine.h"
#include "EngineUtils.h"
#include "HAL/IConsoleManager.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "PostProcessSetting.h"
#include "SceneRendering.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"
#include "TunedActor.h"
#include "TunedSettings.h"
#include "Engine/Texture2D.h"

static TAutoConsoleVariable<float> CVarTunedGain(TEXT("r.Tuned.Gain"), 1.0f, TEXT("Multiplies green."));

static TAutoConsoleVariable<int32> CVarTunedOn(TEXT("r.Tuned.On"), 0, TEXT("0: red is 64 more."));

enum class ETunedMix : uint8
{
	Replace,
	Keep,
};

static const Drydock::TPostProcessSetting<float> GTunedGlow(TEXT("TunedGlow"), 0.0f, 0.0f, 8.0f, TEXT("Added to red."));
static const Drydock::TPostProcessSetting<FLinearColor> GTunedColor(
	TEXT("TunedColor"), FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), {.Doc = TEXT("Multiplies all.")});
static const Drydock::TPostProcessSetting<ETunedMix> GTunedMix(
	TEXT("TunedMix"), ETunedMix::Replace, {.Doc = TEXT("What becomes of blue."), .EnumNames = {"Replace", "Keep"}});

namespace
{

class FTunedPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTunedPS);
	SHADER_USE_PARAMETER_STRUCT(FTunedPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER_TEXTURE(Texture2D, Mask)
		SHADER_PARAMETER(FVector4f, Scale)
		SHADER_PARAMETER(FVector4f, Lift)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTunedPS, "/Plugin/Tuned/Tuned.usf", "TunedPS", SF_Pixel);

class FTunedExtension : public FSceneViewExtensionBase
{
public:
	FTunedExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FTunedExtension::Draw));
		}
	}

private:
	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const UTunedSettings* Settings = GetDefault<UTunedSettings>();
		const UTunedSubsystem* Subsystem = GEngine->GetEngineSubsystem<UTunedSubsystem>();
		const FFinalPostProcessSettings& Final = View.FinalPostProcessSettings;
		const FLinearColor Color = GTunedColor.Get(Final);
		const float Factor = Settings->Weights.Scale * static_cast<float>(Settings->Steps);

		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		const FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, ERenderTargetLoadAction::EClear, TEXT("Tuned"));
		FTunedPS::FParameters* Parameters = GraphBuilder.AllocParameters<FTunedPS::FParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->Input = SceneColor.Texture;
		Parameters->InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		Parameters->Mask = Settings->Mask ? Settings->Mask->GetResource()->TextureRHI : GWhiteTexture->TextureRHI;
		Parameters->Scale = FVector4f(1.0f, 1.0f, 1.0f, 1.0f);
		if (Settings->Mode == ETunedMode::Multiply)
		{
			Parameters->Scale = FVector4f(Settings->Tint.R * Color.R * Factor,
				Settings->Tint.G * Color.G * CVarTunedGain.GetValueOnAnyThread(),
				GTunedMix.Get(Final) == ETunedMix::Keep ? Color.B * Subsystem->BoostAtStart : 0.0f, 1.0f);
		}
		Parameters->Lift = FVector4f(
			GTunedGlow.Get(Final) + Settings->GetSecret() + (CVarTunedOn.GetValueOnAnyThread() != 0 ? 0.0f : 64.0f),
			static_cast<float>(Settings->Weights.Lift.Y) + (Settings->bInvert ? 16.0f : 0.0f),
			Settings->GetSumOfOffsets() + (Settings->Label == TEXT("a \"tuned\" plugin; no comment") ? 1.0f : 0.0f),
			0.0f);
		for (TActorIterator<ATunedActor> Actor(GWorld); Actor; ++Actor)
		{
			const float Lift = Actor->LiftAtPlay;
			Parameters->Lift += FVector4f(Lift, Lift, Lift + static_cast<float>(Actor->NumTicks), 0.0f);
		}
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.FeatureLevel);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Tuned"),
			TShaderMapRef<FTunedPS>(ShaderMap), Parameters, Output.ViewRect);
		return Output;
	}
};

class FTunedModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		const UClass* Class = GetDefault<UTunedSettings>()->GetClass();
		check(Class == UTunedSettings::StaticClass() && Class->GetName() == TEXT("TunedSettings"));
		check(Class->IsChildOf<UDeveloperSettings>() && Class->GetDefaultObject() == GetDefault<UTunedSettings>());
		AddShaderSourceDirectoryMapping(TEXT("/Plugin/Tuned"),
			FPaths::Combine(IPluginManager::Get().FindPlugin(TEXT("Tuned"))->GetBaseDir(), TEXT("Shaders")));
		Extension = FSceneViewExtensions::NewExtension<FTunedExtension>();
	}

private:
	TSharedPtr<FTunedExtension, ESPMode::ThreadSafe> Extension;
};

} // namespace

void UTunedSubsystem::Initialize(FSubsystemCollectionBase& Collection)
{
	Super::Initialize(Collection);
	BoostAtStart = Boost;
}

IMPLEMENT_MODULE(FTunedModule, Tuned);
