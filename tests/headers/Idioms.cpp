// What code from outside writes with the headers: shader classes, parameter structs and C++ habits of public plugins.
// That it compiles is the test.
#include "CoreMinimal.h"
#include "CommonRenderResources.h"
#include "DataDrivenShaderPlatformInfo.h"
#include "FXRenderingUtils.h"
#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "PostProcess/PostProcessMaterial.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

#define IDIOMS_API

DECLARE_LOG_CATEGORY_EXTERN(LogIdioms, Log, All);
DEFINE_LOG_CATEGORY(LogIdioms);
DEFINE_LOG_CATEGORY_STATIC(LogIdiomsOfOneFile, Log, All);
DECLARE_GPU_STAT(Idioms)
DECLARE_GPU_STAT_NAMED(IdiomsNamed, TEXT("Idioms by name"));
DECLARE_GPU_DRAWCALL_STAT(IdiomsDraws);

namespace
{

TAutoConsoleVariable<int32> CVarInt(
	TEXT("r.Idioms.Int"), 1, TEXT("A help text ") TEXT("in two parts."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarFloat(TEXT("r.Idioms.Float"), 1.0f, TEXT(""), ECVF_Default);
TAutoConsoleVariable<bool> CVarBool(TEXT("r.Idioms.Bool"), true, TEXT(""));
auto* CVarOnHeap = new TAutoConsoleVariable<float>(TEXT("r.Idioms.Heap"), 1.0f, TEXT(""));
int32 GIdiomsReference = 0;
FAutoConsoleVariableRef CVarReference(TEXT("r.Idioms.Reference"), GIdiomsReference, TEXT(""), ECVF_RenderThreadSafe);

BEGIN_SHADER_PARAMETER_STRUCT(FCommonIdioms, )
	SHADER_PARAMETER(FVector2f, Size)
	SHADER_PARAMETER(FIntRect, Rect)
	SHADER_PARAMETER(FScreenTransform, Transform)
END_SHADER_PARAMETER_STRUCT()

// Every member that is seen, with macros ended by nothing and by a semicolon.
class FEverythingPS final : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FEverythingPS)
	SHADER_USE_PARAMETER_STRUCT(FEverythingPS, FGlobalShader)

	class FFast : SHADER_PERMUTATION_BOOL("FAST");
	class FSteps : SHADER_PERMUTATION_INT("STEPS", 3);
	class FTaps : SHADER_PERMUTATION_SPARSE_INT("TAPS", 5, 9);
	enum class EMode : uint8
	{
		A,
		B,
		MAX
	};
	class FMode : SHADER_PERMUTATION_ENUM_CLASS("MODE", EMode);
	using FPermutationDomain = TShaderPermutationDomain<FFast, FSteps, FTaps, FMode>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, IDIOMS_API)
		RENDER_TARGET_BINDING_SLOTS()
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FCommonIdioms, Common)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Whole)
		SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTexturesStruct)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D<float4>, TypedTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture3D, VolumeTexture)
		SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D<uint2>, StencilTexture)
		SHADER_PARAMETER_TEXTURE(Texture2D, RawTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
		SHADER_PARAMETER(float, Scalar)
		SHADER_PARAMETER(int, Int)
		SHADER_PARAMETER(int32, Int32)
		SHADER_PARAMETER(uint32, UInt32)
		SHADER_PARAMETER(FVector2f, Vector2)
		SHADER_PARAMETER(FVector3f, Vector3)
		SHADER_PARAMETER(FVector4f, Vector4)
		SHADER_PARAMETER(FIntPoint, Point)
		SHADER_PARAMETER(FIntVector, IntVector)
		SHADER_PARAMETER(FUintVector2, UIntVector2)
		SHADER_PARAMETER(FUintVector4, UIntVector4)
		SHADER_PARAMETER(FLinearColor, Tint)
		SHADER_PARAMETER(FMatrix44f, Matrix)
		SHADER_PARAMETER_ARRAY(FVector4f, Weights, [8])
	END_SHADER_PARAMETER_STRUCT();

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("AN_INT"), 1);
		OutEnvironment.SetDefine(TEXT("A_UINT"), 1u);
		OutEnvironment.SetDefine(TEXT("A_BOOL"), true);
	}
};

IMPLEMENT_GLOBAL_SHADER(FEverythingPS, "/Idioms/Everything.usf", "MainPS", SF_Pixel);

} // namespace

namespace Idioms
{

BEGIN_SHADER_PARAMETER_STRUCT(FComputeParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Output)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, Points)
	SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<uint>, Counts)
	RDG_TEXTURE_ACCESS(Copied, ERHIAccess::CopySrc)
	RDG_BUFFER_ACCESS(Arguments, ERHIAccess::IndirectArgs)
END_SHADER_PARAMETER_STRUCT()

// A struct at namespace scope under the name that the shader class wants; the older macros; a group size of its own.
class FOlderCS : public FGlobalShader
{
public:
	static constexpr uint32 THREADGROUPSIZE_X = 8;
	static constexpr uint32 THREADGROUPSIZE_Y = 8;

	DECLARE_EXPORTED_SHADER_TYPE(FOlderCS, Global, );
	using FParameters = FComputeParameters;
	SHADER_USE_PARAMETER_STRUCT(FOlderCS, FGlobalShader);

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters&) { return true; }
};

IMPLEMENT_SHADER_TYPE(, FOlderCS, TEXT("/Idioms/Older.usf"), TEXT("MainCS"), SF_Compute)

// A constructor written by hand.
class FHandMadeVS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FHandMadeVS, Global);

public:
	FHandMadeVS() {}
	FHandMadeVS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};

IMPLEMENT_SHADER_TYPE(, FHandMadeVS, TEXT("/Idioms/Older.usf"), TEXT("MainVS"), SF_Vertex);

/** A helper over any shader class. */
template<typename TShaderClass, typename TFill>
FScreenPassTexture AddFilter(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture Input, const TCHAR* Name, TFill&& Fill)
{
	FRDGTextureDesc Desc = Input.Texture->Desc;
	Desc.Reset();
	Desc.Flags |= TexCreate_RenderTargetable | ETextureCreateFlags::ShaderResource;
	Desc.Flags &= ~(TexCreate_FastVRAM);
	Desc.ClearValue = FClearValueBinding(FLinearColor::Black);
	FScreenPassRenderTarget Output(
		GraphBuilder.CreateTexture(Desc, Name), Input.ViewRect, ERenderTargetLoadAction::ENoAction);
	typename TShaderClass::FParameters* Parameters = GraphBuilder.AllocParameters<typename TShaderClass::FParameters>();
	Fill(Parameters);
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap, RDG_EVENT_NAME("%s", Name),
		TShaderMapRef<TShaderClass>(View.ShaderMap), Parameters, Output.ViewRect);
	return MoveTemp(Output);
}

struct FPayload
{
	int32 Value = 0;
};

class FIdiomsExtension : public FSceneViewExtensionBase
{
public:
	FIdiomsExtension(const FAutoRegister& AutoRegister, FPayload InPayload)
		: FSceneViewExtensionBase(AutoRegister)
		, Payload(InPayload)
	{
		FSceneViewExtensionIsActiveFunctor Functor;
		Functor.IsActiveFunction = [](const ISceneViewExtension*, const FSceneViewExtensionContext&)
		{
			return TOptional<bool>();
		};
		IsActiveThisFrameFunctions.Add(Functor);
	}

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override{};
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void PreRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView) override {}
	virtual void PreRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&) override {}
	virtual int32 GetPriority() const override { return -5; }
	virtual bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const override
	{
		return Context.GetWorld() == nullptr || CVarInt.GetValueOnAnyThread() > 0;
	}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		FSceneViewExtensionBase::PrePostProcessPass_RenderThread(GraphBuilder, View, Inputs);
		if (!View.bIsViewInfo || View.bIsSceneCapture || View.bIsReflectionCapture || View.bIsPlanarReflection)
		{
			return;
		}
		Inputs.Validate();
		check(IsInRenderingThread());
		const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
		FRDGTextureRef SceneColor = (*Inputs.SceneTextures)->SceneColorTexture;
		FRDGTextureRef SceneDepth = Inputs.SceneTextures->GetParameters()->SceneDepthTexture;
		FRDGTextureRef GBufferA = Inputs.SceneTextures->GetContents()->GBufferATexture;
		const FIntRect Rect = UE::FXRenderingUtils::GetRawViewRectUnsafe(View);
		RDG_GPU_STAT_SCOPE(GraphBuilder, Idioms)
		RDG_EVENT_SCOPE(GraphBuilder, "Idioms %dx%d", Rect.Width(), Rect.Height());
		{
			const FScreenPassTextureViewport Viewport(SceneColor, ViewInfo.ViewRect);
			AddFilter<FEverythingPS>(GraphBuilder, ViewInfo, FScreenPassTexture(SceneColor, Rect), TEXT("Idioms"),
				[&](auto* Parameters)
				{
					Parameters->View = View.ViewUniformBuffer;
					Parameters->Input = GetScreenPassTextureViewportParameters(Viewport);
					Parameters->ColorTexture = SceneColor;
					Parameters->TypedTexture = SceneDepth;
					Parameters->StencilTexture =
						GraphBuilder.CreateSRV(FRDGTextureSRVDesc::CreateWithPixelFormat(SceneDepth, PF_X24_G8));
					Parameters->RawTexture = GWhiteTexture->TextureRHI;
					Parameters->ColorSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
					Parameters->SceneTexturesStruct = Inputs.SceneTextures;
					// Between near types.
					Parameters->Vector2 = Rect.Size();
					Parameters->Common.Size = FVector2f(1.0f) / FVector2f(Rect.Size());
					Parameters->Common.Rect = Rect;
					Parameters->Vector4 = FVector4f(Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y);
					Parameters->Vector3 = {1.0f, 2.0f, 3.0f};
					Parameters->Point = {4, 5};
					Parameters->Tint = FLinearColor::White;
					Parameters->Weights[0] = FVector4f(1.0f, 0.0f, 0.0f, 0.0f);
					Parameters->RenderTargets[1] =
						FRenderTargetBinding(GBufferA, ERenderTargetLoadAction::ELoad, /*InMipIndex*/ 0);
				});
		}
		if (CVarInt->GetInt() == 0 || CVarFloat->GetFloat() < 0.0f || CVarBool.GetValueOnRenderThread())
		{
			UE_LOG(LogIdioms, Verbose, TEXT("%s %d"), *FString::Printf(TEXT("%dx%d"), 1, 2), 3);
		}
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		if (PassId == EPostProcessingPass::MotionBlur)
		{
			InOutPassCallbacks.Add(
				FAfterPassCallbackDelegate::CreateRaw(this, &FIdiomsExtension::WithPayload, Payload));
			InOutPassCallbacks.Add(FPostProcessingPassDelegate::CreateLambda(
				[this](FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
				{ return WithPayload(GraphBuilder, View, Inputs, Payload); }));
		}
	}
	virtual void SubscribeToPostProcessingPass(EPostProcessingPass PassId, const FSceneView& InView,
		FPostProcessingPassDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		SubscribeToPostProcessingPass(PassId, InOutPassCallbacks, bIsPassEnabled);
	}
	virtual void PostRenderBasePassDeferred_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView,
		const FRenderTargetBindingSlots& RenderTargets,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures) override
	{
	}

private:
	FScreenPassTexture WithPayload(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs, FPayload InPayload)
	{
		const FScreenPassTexture& SceneColor =
			FScreenPassTexture::CopyFromSlice(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		const FScreenPassTexture OldStyle = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		FRDGTextureRef Direct = Inputs.GetInput(EPostProcessMaterialInput::SceneColor).Texture;
		const FScreenPassTextureSlice Slice = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		const FScreenPassTexture OfSlice(Slice);
		if (!SceneColor.IsValid() || !OldStyle.IsValid() || Direct == nullptr || !OfSlice.IsValid())
		{
			return Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder);
		}
		FScreenPassRenderTarget Output = Inputs.OverrideOutput;
		if (!Output.IsValid())
		{
			Output = FScreenPassRenderTarget::CreateFromInput(
				GraphBuilder, SceneColor, View.GetOverwriteLoadAction(), TEXT("IdiomsOutput"));
		}
		const TShaderMapRef<FOlderCS> Shader(GetGlobalShaderMap(View.GetFeatureLevel()));
		auto* Parameters = GraphBuilder.AllocParameters<FOlderCS::FParameters>();
		Parameters->Input = SceneColor.Texture;
		Parameters->Output = GraphBuilder.CreateUAV(FRDGTextureUAVDesc(Output.Texture, 0));
		FComputeShaderUtils::AddPass(GraphBuilder, FRDGEventName(TEXT("Idioms %s"), *Name),
			ERDGPassFlags::Compute | ERDGPassFlags::NeverCull, Shader, Parameters,
			FComputeShaderUtils::GetGroupCount(
				Output.ViewRect.Size(), FIntPoint(Shader->THREADGROUPSIZE_X, Shader->THREADGROUPSIZE_Y)));
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Temporary"),
			TShaderMapRef<FOlderCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters, FIntVector(1, 1, 1));
		AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Draw"), View, FScreenPassTextureViewport(Output),
			FScreenPassTextureViewport(SceneColor),
			TShaderMapRef<FScreenPassVS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)),
			TShaderMapRef<FCopyRectPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), TStaticBlendState<>::GetRHI(),
			GraphBuilder.AllocParameters<FCopyRectPS::FParameters>());
		++NumFrames;
		return MoveTemp(Output);
	}

	BEGIN_SHADER_PARAMETER_STRUCT(FNested, )
		SHADER_PARAMETER(float, Value)
	END_SHADER_PARAMETER_STRUCT()

	FPayload Payload;
	FString Name = FString("Idioms") + FString::FromInt(7) + "th";
	TMap<uint32, TRefCountPtr<IPooledRenderTarget>> History;
	int32 NumFrames = 0;
};

/** What is asked of a family, and of the engine's globals. */
float AskFamily(const FSceneViewFamily& Family)
{
	float Fraction = Family.SecondaryViewFraction;
	if (const ISceneViewFamilyScreenPercentage* Interface = Family.GetScreenPercentageInterface())
	{
		const DynamicRenderScaling::TMap<float> UpperBounds = Interface->GetResolutionFractionsUpperBound();
		Fraction *= UpperBounds[GDynamicPrimaryResolutionFraction];
	}
	if (Family.EngineShowFlags.PostProcessing && Family.Scene && Family.Scene->GetWorld())
	{
		Fraction += Family.Time.GetDeltaRealTimeSeconds();
	}
	return Fraction + IConsoleManager::Get().FindConsoleVariable(TEXT("r.Idioms.Float"))->GetFloat();
}

TSharedRef<FIdiomsExtension, ESPMode::ThreadSafe> MakeExtension()
{
	TSharedPtr<FIdiomsExtension, ESPMode::ThreadSafe> Extension =
		FSceneViewExtensions::NewExtension<FIdiomsExtension>(FPayload());
	ENQUEUE_RENDER_COMMAND(Idioms)([Extension](FRHICommandListImmediate& RHICmdList) { (void)Extension; });
	return Extension.ToSharedRef();
}

/** Conversions between near types, and the standard library without its headers. */
FIntPoint Convert(const FIntRect& Rect, FRDGBuilder& GraphBuilder, const FRDGTextureDesc& Desc)
{
	const FVector2f Scaled = FVector2f(Rect.Size()) * 0.5f;
	FIntPoint Half(Scaled.X, Scaled.Y);
	Half = FIntPoint(FMath::RoundToInt(Scaled.X), FMath::CeilToInt(Scaled.Y));
	Half = FIntPoint::DivideAndRoundUp(Rect.Size(), 2);
	const FIntRect Scale = Rect.Scale(0.5f);
	const FString Name = FString(TEXT("Convert")) + FString::FromInt(Half.X);
	FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, *Name);
	std::function<FIntPoint(FIntPoint)> Double = [](FIntPoint Point)
	{
		return Point * 2;
	};
	TArray<FIntPoint> Points = {{1, 2}, {3, 4}};
	Points.Append({Half, Scale.Size()});
	FIntPoint Sum = FIntPoint::ZeroValue;
	for (const FIntPoint& Point : Points)
	{
		Sum += Double(Point);
	}
	static int32 NumCalls = 0;
	++NumCalls;
	return std::move(Sum) + FMath::Max(Texture->Desc.Extent.X, NumCalls);
}

/** A pass that names its states by hand. */
[[maybe_unused]] void AddRawPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FEverythingPS::FParameters* Parameters)
{
	FEverythingPS::FPermutationDomain Permutation;
	Permutation.Set<FEverythingPS::FFast>(true);
	Permutation.Set<FEverythingPS::FSteps>(2);
	Permutation.Set<FEverythingPS::FTaps>(9);
	Permutation.Set<FEverythingPS::FMode>(FEverythingPS::EMode::B);
	TShaderMapRef<FScreenVS> VertexShader(View.ShaderMap);
	TShaderMapRef<FEverythingPS> PixelShader(View.ShaderMap, Permutation);
	ClearUnusedGraphResources(PixelShader, Parameters);
	GraphBuilder.AddPass(RDG_EVENT_NAME("Raw"), Parameters, ERDGPassFlags::Raster,
		[Parameters, VertexShader, PixelShader, Rect = View.ViewRect](FRHICommandListImmediate& RHICmdList)
		{
			FGraphicsPipelineStateInitializer GraphicsPSOInit;
			RHICmdList.ApplyCachedRenderTargets(GraphicsPSOInit);
			GraphicsPSOInit.BlendState = TStaticBlendState<CW_RGBA, BO_Add, BF_One, BF_One>::GetRHI();
			GraphicsPSOInit.RasterizerState = TStaticRasterizerState<>::GetRHI();
			GraphicsPSOInit.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
			GraphicsPSOInit.BoundShaderState.VertexDeclarationRHI = GFilterVertexDeclaration.VertexDeclarationRHI;
			GraphicsPSOInit.BoundShaderState.VertexShaderRHI = VertexShader.GetVertexShader();
			GraphicsPSOInit.BoundShaderState.PixelShaderRHI = PixelShader.GetPixelShader();
			GraphicsPSOInit.PrimitiveType = PT_TriangleList;
			SetGraphicsPipelineState(RHICmdList, GraphicsPSOInit, 0);
			RHICmdList.SetViewport(Rect.Min.X, Rect.Min.Y, 0.0f, Rect.Max.X, Rect.Max.Y, 1.0f);
			SetShaderParameters(RHICmdList, PixelShader, PixelShader.GetPixelShader(), *Parameters);
			RHICmdList.SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
			RHICmdList.DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, 1);
		});
}

} // namespace Idioms
