// Permutations by bool, range of integers and enum, chosen by console variables.
#include "HAL/IConsoleManager.h"
#include "PostProcess/PostProcessing.h"
#include "ShaderPermutation.h"

namespace Variants
{

static TAutoConsoleVariable<bool> CVarDouble(
	TEXT("r.Variants.Double"), false, TEXT("Twice as bright."), ECVF_RenderThreadSafe);
static TAutoConsoleVariable<int32> CVarSteps(
	TEXT("r.Variants.Steps"), 0, TEXT("Quarters to add,") TEXT(" 0 to 3."), ECVF_RenderThreadSafe);
static TAutoConsoleVariable<int32> CVarChannel(
	TEXT("r.Variants.Channel"), 0, TEXT("Where to: 0 red, 1 green, 2 blue."), ECVF_RenderThreadSafe);

enum class EChannel : uint8
{
	Red,
	Green,
	Blue,
	MAX
};

class FVariantsCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FVariantsCS)
	SHADER_USE_PARAMETER_STRUCT(FVariantsCS, FGlobalShader)

	class FDouble : SHADER_PERMUTATION_BOOL("DOUBLE");
	class FSteps : SHADER_PERMUTATION_RANGE_INT("STEPS", 0, 4);
	class FChannel : SHADER_PERMUTATION_ENUM_CLASS("CHANNEL", EChannel);
	using FPermutationDomain = TShaderPermutationDomain<FDouble, FSteps, FChannel>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D<float4>, Input)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Output)
		SHADER_PARAMETER(FIntPoint, Size)
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		const FPermutationDomain PermutationVector(Parameters.PermutationId);
		// Doubling is only for those who add something.
		return !(PermutationVector.Get<FDouble>() && PermutationVector.Get<FSteps>() == 0);
	}
};

IMPLEMENT_GLOBAL_SHADER(FVariantsCS, "/Plugin/Variants/Variants.usf", "VariantsCS", SF_Compute)

class FExtension : public FSceneViewExtensionBase
{
public:
	FExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass != EPostProcessingPass::MotionBlur)
		{
			return;
		}
		Callbacks.Add(FAfterPassCallbackDelegate::CreateLambda(
			[](FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
			{
				const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
				FRDGTextureDesc Desc = SceneColor.Texture->Desc;
				Desc.Flags |= ETextureCreateFlags::UAV;
				FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("Variants"));

				FVariantsCS::FPermutationDomain PermutationVector;
				PermutationVector.Set<FVariantsCS::FDouble>(CVarDouble.GetValueOnRenderThread());
				PermutationVector.Set<FVariantsCS::FSteps>(FMath::Clamp(CVarSteps.GetValueOnRenderThread(), 0, 3));
				PermutationVector.Set<FVariantsCS::FChannel>(
					static_cast<EChannel>(CVarChannel.GetValueOnRenderThread()));

				auto* Parameters = GraphBuilder.AllocParameters<FVariantsCS::FParameters>();
				Parameters->Input = SceneColor.Texture;
				Parameters->Output = GraphBuilder.CreateUAV(Output);
				Parameters->Size = SceneColor.ViewRect.Size();
				FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Variants"),
					TShaderMapRef<FVariantsCS>(GetGlobalShaderMap(View.FeatureLevel), PermutationVector), Parameters,
					FComputeShaderUtils::GetGroupCount(
						SceneColor.ViewRect.Size(), FComputeShaderUtils::kGolden2DGroupSize));
				return FScreenPassTexture(Output, SceneColor.ViewRect);
			}));
	}
};

TSharedPtr<FExtension, ESPMode::ThreadSafe> GExtension = FSceneViewExtensions::NewExtension<FExtension>();

} // namespace Variants
