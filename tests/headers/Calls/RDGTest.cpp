// Calls on the graph: builder, resources, passes, shaders' parameters, screen passes. A little past 500 lines: a list,
// a row for each call.
#include "Calls.h"

#include "CommonRenderResources.h"
#include "DataDrivenShaderPlatformInfo.h"
#include "GenerateMips.h"
#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessWeightedSampleSum.h"
#include "RHIGPUReadback.h"
#include "RenderGraphBlackboard.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"
#include "ShaderPermutation.h"
#include "SystemTextures.h"

struct FCallsBlackboard
{
	int32 Value = 0;
};
RDG_REGISTER_BLACKBOARD_STRUCT(FCallsBlackboard);

namespace
{

constexpr Calls::EArea Area = Calls::EArea::RDG;

DECLARE_GPU_STAT(CallsStat);
DECLARE_GPU_STAT_NAMED(CallsNamedStat, TEXT("Calls"));

BEGIN_SHADER_PARAMETER_STRUCT(FCallsInner, )
	SHADER_PARAMETER(float, Amount)
END_SHADER_PARAMETER_STRUCT()

enum class ECallsMode : uint8
{
	First,
	Second,
	MAX
};

class FCallsCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCallsCS);
	SHADER_USE_PARAMETER_STRUCT(FCallsCS, FGlobalShader);

	class FSwitch : SHADER_PERMUTATION_BOOL("CALLS_SWITCH");
	class FCount : SHADER_PERMUTATION_INT("CALLS_COUNT", 3);
	class FMode : SHADER_PERMUTATION_ENUM_CLASS("CALLS_MODE", ECallsMode);
	class FSparse : SHADER_PERMUTATION_SPARSE_INT("CALLS_SPARSE", 8, 16);
	using FPermutationDomain = TShaderPermutationDomain<FSwitch, FCount, FMode, FSparse>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, Color)
		SHADER_PARAMETER(FIntPoint, Size)
		SHADER_PARAMETER(FMatrix44f, Matrix)
		SHADER_PARAMETER_ARRAY(FVector4f, Values, [2])
		SHADER_PARAMETER_SCALAR_ARRAY(float, Scalars, [3])
		SHADER_PARAMETER_STRUCT(FCallsInner, Inner)
		SHADER_PARAMETER_STRUCT_INCLUDE(FCallsInner, Included)
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
		SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D<float4>, InputView)
		SHADER_PARAMETER_TEXTURE(Texture2D, Plain)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, Buffer)
		SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<float>, OutBuffer)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZE"), 8);
		SET_SHADER_DEFINE(OutEnvironment, CALLS_DEFINE, 1);
		OutEnvironment.CompilerFlags.Add(CFLAG_StandardOptimization);
	}
};
IMPLEMENT_GLOBAL_SHADER(FCallsCS, "/DrydockTests/Calls.usf", "MainCS", SF_Compute);

class FCallsPS : public FGlobalShader
{
	DECLARE_EXPORTED_SHADER_TYPE(FCallsPS, Global, );
	SHADER_USE_PARAMETER_STRUCT(FCallsPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_SHADER_TYPE(, FCallsPS, TEXT("/DrydockTests/Calls.usf"), TEXT("MainPS"), SF_Pixel);

FRDGTextureDesc MakeDesc(FIntPoint Extent = FIntPoint(4, 2))
{
	return FRDGTextureDesc::Create2D(Extent, PF_FloatRGBA, FClearValueBinding::Black,
		TexCreate_RenderTargetable | TexCreate_ShaderResource | TexCreate_UAV);
}

FLinearColor ReadFirst(const TRefCountPtr<IPooledRenderTarget>& Target)
{
	return Target->GetRHI()->ReadTexel(0, 0);
}

} // namespace

TEST(CallsOfRDG, Resources)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Calls"));
	CALL("FRDGBuilder(RHICmdList, Name)", true);
	FRDGTextureDesc Desc = MakeDesc();
	CALL("FRDGTextureDesc::Create2D",
		Desc.Extent == FIntPoint(4, 2) && Desc.Format == PF_FloatRGBA && Desc.NumMips == 1);
	CALL("FRDGTextureDesc::Create3D",
		FRDGTextureDesc::Create3D(FIntVector(2, 3, 4), PF_FloatRGBA, FClearValueBinding::None, TexCreate_ShaderResource)
				.Depth == 4);
	CALL("FRDGTextureDesc::Create2DArray, CreateCube",
		FRDGTextureDesc::Create2DArray(
			FIntPoint(2, 2), PF_FloatRGBA, FClearValueBinding::None, TexCreate_ShaderResource, 3)
					.ArraySize == 3 &&
			FRDGTextureDesc::CreateCube(2, PF_FloatRGBA, FClearValueBinding::None, TexCreate_ShaderResource)
				.IsTextureCube());
	Desc.Extent = FIntPoint(8, 8);
	Desc.Format = PF_R32_FLOAT;
	Desc.ClearValue = FClearValueBinding(FLinearColor::Red);
	Desc.Flags |= TexCreate_FastVRAM;
	Desc.Flags &= ~TexCreate_FastVRAM;
	Desc.NumMips = 2;
	CALL("FRDGTextureDesc::Extent, Format, ClearValue, Flags, NumMips, NumSamples, Depth, ArraySize",
		Desc.NumSamples == 1 && Desc.Depth == 1 && Desc.ArraySize == 1 &&
			!EnumHasAnyFlags(Desc.Flags, TexCreate_FastVRAM));
	Desc.Reset();
	CALL("FRDGTextureDesc::Reset", Desc.Extent.X == 8);
	CALL("FRDGTextureDesc::GetSize, IsMipChain, IsTexture2D",
		Desc.GetSize().X == 8 && Desc.IsMipChain() && Desc.IsTexture2D());
	CALL("FClearValueBinding::Black, None, White, Transparent, GetClearColor",
		FClearValueBinding::White.GetClearColor() == FLinearColor::White &&
			FClearValueBinding::Black.GetClearColor() == FLinearColor::Black &&
			FClearValueBinding::Transparent.GetClearColor().A == 0.0f &&
			FClearValueBinding::None.ColorBinding == EClearBinding::ENoneBound);
	CALL("FPooledRenderTargetDesc::Create2DDesc",
		FPooledRenderTargetDesc::Create2DDesc(
			FIntPoint(2, 3), PF_FloatRGBA, FClearValueBinding::None, TexCreate_None, TexCreate_RenderTargetable, false)
				.Extent.Y == 3);
	const FRDGTextureRef Texture = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Texture"));
	CALL("FRDGBuilder::CreateTexture", Texture != nullptr);
	CALL("FRDGTexture::Desc", Texture->Desc.Extent == FIntPoint(4, 2));
	CALL("FRDGTexture::Name", FString(Texture->Name) == TEXT("Calls.Texture"));
	CALL("FRDGTexture::HasBeenProduced", !Texture->HasBeenProduced() && !HasBeenProduced(Texture));
	CALL("CreateTexture with ERDGTextureFlags::MultiFrame",
		GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Kept"), ERDGTextureFlags::MultiFrame) != nullptr);
	CALL(
		"CreateTexture with *FString", GraphBuilder.CreateTexture(MakeDesc(), *FString(TEXT("Calls.Text"))) != nullptr);
	CALL("FRDGBuilder::CreateSRV(Texture)", GraphBuilder.CreateSRV(Texture)->Desc.Texture == Texture);
	CALL("FRDGTextureSRVDesc::Create, CreateForMipLevel",
		GraphBuilder.CreateSRV(FRDGTextureSRVDesc::Create(Texture)) != nullptr &&
			FRDGTextureSRVDesc::CreateForMipLevel(Texture, 0).NumMipLevels == 1);
	CALL("FRDGTextureSRVDesc::CreateWithPixelFormat",
		FRDGTextureSRVDesc::CreateWithPixelFormat(Texture, PF_X24_G8).Format == PF_X24_G8);
	CALL("FRDGTextureSRVDesc::CreateForMetaData",
		FRDGTextureSRVDesc::CreateForMetaData(Texture, ERDGTextureMetaDataAccess::CompressedSurface).Texture ==
			Texture);
	CALL("FRDGBuilder::CreateUAV(Texture)", GraphBuilder.CreateUAV(Texture)->Desc.Texture == Texture);
	CALL("FRDGTextureUAVDesc", GraphBuilder.CreateUAV(FRDGTextureUAVDesc(Texture, 0))->Desc.MipLevel == 0);
	CALL("FRDGTextureSRVRef, FRDGTextureUAVRef, FRDGBufferSRVRef, FRDGBufferUAVRef",
		sizeof(FRDGTextureSRVRef) == sizeof(FRDGBufferUAVRef));
	const FRDGBufferRef Buffer =
		GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(sizeof(float), 16), TEXT("Calls.Buffer"));
	CALL("FRDGBuilder::CreateBuffer, FRDGBufferDesc::CreateStructuredDesc",
		Buffer->Desc.NumElements == 16 && Buffer->Desc.BytesPerElement == 4);
	CALL("FRDGBufferDesc::CreateBufferDesc, CreateIndirectDesc, CreateByteAddressDesc, CreateUploadDesc",
		FRDGBufferDesc::CreateBufferDesc(4, 8).GetSize() == 32 &&
			FRDGBufferDesc::CreateIndirectDesc(3).GetSize() == 12 &&
			FRDGBufferDesc::CreateByteAddressDesc(64).GetSize() == 64);
	CALL("FRDGBuilder::CreateSRV(Buffer), CreateUAV(Buffer)",
		GraphBuilder.CreateSRV(Buffer) != nullptr && GraphBuilder.CreateUAV(Buffer) != nullptr);
	CALL("FRDGBufferSRVDesc, FRDGBufferUAVDesc", GraphBuilder.CreateSRV(FRDGBufferSRVDesc(Buffer)) != nullptr &&
													 GraphBuilder.CreateUAV(FRDGBufferUAVDesc(Buffer)) != nullptr);
	const float Values[2] = {1.0f, 2.0f};
	CALL("CreateStructuredBuffer(GraphBuilder, Name, Stride, Count, Data, Size)",
		CreateStructuredBuffer(GraphBuilder, TEXT("Calls.Structured"), 4, 2, Values, 8)->Desc.NumElements == 2);
	CALL("CreateStructuredBuffer(GraphBuilder, Name, Array)",
		CreateStructuredBuffer(GraphBuilder, TEXT("Calls.Array"), TArray<float>{1.0f, 2.0f, 3.0f})->Desc.NumElements ==
			3);
	CALL("CreateUploadBuffer", CreateUploadBuffer(GraphBuilder, TEXT("Calls.Upload"), 4, 2, Values, 8) != nullptr);
	CALL("FRDGBuilder::QueueBufferUpload",
		[&]
		{
			GraphBuilder.QueueBufferUpload(Buffer, Values, sizeof(Values));
			return true;
		}());
	CALL("FRDGUploadData", FRDGUploadData<float>(GraphBuilder, 4).Num() == 4);
	CALL("FRDGBuilder::AllocParameters", GraphBuilder.AllocParameters<FCallsCS::FParameters>()->Color == FVector4f());
	CALL("FRDGBuilder::AllocObject, AllocPOD, AllocPODArray, AllocArray, Alloc",
		*GraphBuilder.AllocObject<int32>(3) == 3 && GraphBuilder.AllocPOD<int32>() != nullptr &&
			GraphBuilder.AllocPODArray<int32>(4) != nullptr && GraphBuilder.AllocArray<int32>().Num() == 0 &&
			GraphBuilder.Alloc(8) != nullptr);
	FCallsInner* const Inner = GraphBuilder.AllocParameters<FCallsInner>();
	Inner->Amount = 2.0f;
	CALL("BEGIN_SHADER_PARAMETER_STRUCT, END_SHADER_PARAMETER_STRUCT, SHADER_PARAMETER",
		FCallsInner::FTypeInfo::GetStructMetadata()->GetSize() >= 4 && Inner->Amount == 2.0f);
	CALL("SHADER_PARAMETER_STRUCT, SHADER_PARAMETER_STRUCT_INCLUDE, SHADER_PARAMETER_STRUCT_REF",
		sizeof(FCallsCS::FParameters) > sizeof(FCallsInner));
	CALL("SHADER_PARAMETER_ARRAY, SHADER_PARAMETER_SCALAR_ARRAY, GET_SCALAR_ARRAY_ELEMENT",
		[]
		{
			FCallsCS::FParameters P;
			GET_SCALAR_ARRAY_ELEMENT(P.Scalars, 2) = 3.0f;
			return GET_SCALAR_ARRAY_ELEMENT(P.Scalars, 2) == 3.0f;
		}());
	CALL("SHADER_PARAMETER_RDG_TEXTURE, _SRV, _UAV, SHADER_PARAMETER_RDG_BUFFER_SRV, _UAV",
		[]
		{
			FCallsCS::FParameters P;
			return !P.Input && !P.OutTexture && !P.Buffer;
		}());
	CALL("SHADER_PARAMETER_TEXTURE, SHADER_PARAMETER_SAMPLER, SHADER_PARAMETER_RDG_UNIFORM_BUFFER",
		[]
		{
			FCallsCS::FParameters P;
			return !P.Plain && !P.InputSampler && !P.SceneTextures;
		}());
	CALL("RENDER_TARGET_BINDING_SLOTS, FRenderTargetBindingSlots",
		[]
		{
			FCallsPS::FParameters P;
			return P.RenderTargets[0].GetTexture() == nullptr;
		}());
	FCallsPS::FParameters Targets;
	Targets.RenderTargets[1] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::EClear);
	CALL("FRenderTargetBinding, RenderTargets[i]",
		Targets.RenderTargets[1].GetTexture() == Texture &&
			Targets.RenderTargets[1].GetLoadAction() == ERenderTargetLoadAction::EClear &&
			Targets.RenderTargets[1].GetMipIndex() == 0);
	CALL("RenderTargets.DepthStencil, FDepthStencilBinding",
		[&]
		{
			Targets.RenderTargets.DepthStencil = FDepthStencilBinding(
				Texture, ERenderTargetLoadAction::ELoad, FExclusiveDepthStencil::DepthRead_StencilNop);
			return Targets.RenderTargets.DepthStencil.GetTexture() == Texture;
		}());
	CALL("ERenderTargetLoadAction::ENoAction, ELoad, EClear",
		ERenderTargetLoadAction::ELoad != ERenderTargetLoadAction::ENoAction);
	CALL("GSystemTextures.GetBlackDummy, GetWhiteDummy, GetBlackAlphaOneDummy",
		GSystemTextures.GetBlackDummy(GraphBuilder) && GSystemTextures.GetWhiteDummy(GraphBuilder) &&
			GSystemTextures.GetBlackAlphaOneDummy(GraphBuilder));
	CALL("GSystemTextures.BlackDummy, WhiteDummy",
		GSystemTextures.BlackDummy->GetRHI() != nullptr && GSystemTextures.WhiteDummy->GetRHI() != nullptr);
	CALL("GSystemTextures.GetCubeBlackDummy", GSystemTextures.GetCubeBlackDummy(GraphBuilder)->Desc.IsTextureCube());
	CALL("FRDGSystemTextures::Get: Black, White, VolumetricBlackAlphaOne",
		FRDGSystemTextures::Get(GraphBuilder).Black && FRDGSystemTextures::Get(GraphBuilder).VolumetricBlackAlphaOne);
	const TRefCountPtr<IPooledRenderTarget> Wrapped =
		CreateRenderTarget(GWhiteTexture->TextureRHI, TEXT("Calls.White"));
	CALL("CreateRenderTarget", Wrapped.IsValid() && Wrapped->GetRHI() == GWhiteTexture->TextureRHI);
	CALL("FRDGBuilder::RegisterExternalTexture",
		GraphBuilder.RegisterExternalTexture(Wrapped, TEXT("Calls.White"))->Desc.Extent == FIntPoint(1, 1));
	CALL("RegisterExternalTexture(GraphBuilder, RHITexture, Name)",
		RegisterExternalTexture(GraphBuilder, GBlackTexture->TextureRHI, TEXT("Calls.Black")) != nullptr);
	CALL("TryRegisterExternalTexture",
		TryRegisterExternalTexture(GraphBuilder, TRefCountPtr<IPooledRenderTarget>()) == nullptr);
	CALL("FRDGBuilder::FindExternalTexture", GraphBuilder.FindExternalTexture(Wrapped.GetReference()) != nullptr);
	CALL("IPooledRenderTarget::GetDesc, GetRHI, GetRefCount, IsFree",
		Wrapped->GetDesc().Extent == FIntPoint(1, 1) && Wrapped->GetRefCount() >= 1);
	CALL("GraphBuilder.Blackboard.Create, Get, GetChecked, GetOrCreate",
		[&]
		{
			GraphBuilder.Blackboard.Create<FCallsBlackboard>().Value = 4;
			return GraphBuilder.Blackboard.GetChecked<FCallsBlackboard>().Value == 4 &&
				   GraphBuilder.Blackboard.Get<FCallsBlackboard>() != nullptr &&
				   GraphBuilder.Blackboard.GetOrCreate<FCallsBlackboard>().Value == 4;
		}());
	CALL("GraphBuilder.RHICmdList", &GraphBuilder.RHICmdList == &FRHICommandListExecutor::GetImmediateCommandList());
	CALL("FRDGBuilder::CreateUniformBuffer",
		GraphBuilder.CreateUniformBuffer(GraphBuilder.AllocParameters<FSceneTextureUniformParameters>()) != nullptr);
	GraphBuilder.RemoveUnusedTextureWarning(Texture);
	CALL("FRDGBuilder::RemoveUnusedTextureWarning, RemoveUnusedBufferWarning", true);
	GraphBuilder.Execute();
	CALL("FRDGBuilder::Execute", true);
}

TEST(CallsOfRDG, Passes)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	RDG_EVENT_SCOPE(GraphBuilder, "Calls %d", 3);
	RDG_GPU_STAT_SCOPE(GraphBuilder, CallsStat);
	RDG_CSV_STAT_EXCLUSIVE_SCOPE(GraphBuilder, Calls);
	CALL("RDG_EVENT_SCOPE, RDG_GPU_STAT_SCOPE, RDG_CSV_STAT_EXCLUSIVE_SCOPE, DECLARE_GPU_STAT", true);
	CALL("RDG_EVENT_NAME, FRDGEventName",
		FString(RDG_EVENT_NAME("A %dx%d %s", 1, 2, TEXT("b")).GetTCHAR()) == TEXT("A 1x2 b") &&
			FString(FRDGEventName(TEXT("c")).GetTCHAR()) == TEXT("c"));
	const FRDGTextureRef First = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.First"));
	const FRDGTextureRef Second = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Second"));
	const FRDGTextureRef Third = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Third"));
	AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(First), FLinearColor(0.5f, 0.25f, 1.0f, 1.0f));
	AddCopyTexturePass(GraphBuilder, First, Second);
	AddCopyTexturePass(GraphBuilder, First, Second, FIntPoint(0, 0), FIntPoint(1, 1), FIntPoint(1, 1));
	AddCopyTexturePass(GraphBuilder, First, Second, FRHICopyTextureInfo());
	AddClearRenderTargetPass(GraphBuilder, Third, FLinearColor::Red);
	TRefCountPtr<IPooledRenderTarget> OutFirst, OutSecond, OutThird, OutDrawn;
	GraphBuilder.QueueTextureExtraction(Second, &OutSecond);
	GraphBuilder.QueueTextureExtraction(Third, &OutThird);
	bool bRan = false, bRanCompute = false;
	FRDGPassRef Pass = GraphBuilder.AddPass(
		RDG_EVENT_NAME("Calls.Lambda"), ERDGPassFlags::NeverCull, [&bRan](FRHICommandListImmediate&) { bRan = true; });
	CALL(
		"FRDGBuilder::AddPass without parameters, FRDGPass::GetName", FString(Pass->GetName()) == TEXT("Calls.Lambda"));
	FRenderTargetParameters* const Targets = GraphBuilder.AllocParameters<FRenderTargetParameters>();
	Targets->RenderTargets[0] = FRenderTargetBinding(Third, ERenderTargetLoadAction::ELoad);
	GraphBuilder.AddPass(RDG_EVENT_NAME("Calls.Raster"), Targets, ERDGPassFlags::Raster,
		[](FRHICommandList& RHICmdList) { RHICmdList.SetViewport(0, 0, 0.0f, 4, 2, 1.0f); });
	AddPass(GraphBuilder, RDG_EVENT_NAME("Calls.Utility"),
		[&bRanCompute](FRHICommandListImmediate&) { bRanCompute = true; });
	CALL("ERDGPassFlags::Raster, Compute, AsyncCompute, Copy, NeverCull, SkipRenderPass, Readback",
		EnumHasAnyFlags(ERDGPassFlags::Raster | ERDGPassFlags::NeverCull, ERDGPassFlags::NeverCull) &&
			ERDGPassFlags::AsyncCompute != ERDGPassFlags::Copy);
	FRHIGPUTextureReadback Readback(TEXT("Calls.Readback"));
	AddEnqueueCopyPass(GraphBuilder, &Readback, Second);
	GraphBuilder.AddSetupTask([] {});
	GraphBuilder.SetTextureAccessFinal(Second, ERHIAccess::SRVMask);
	CALL("FRDGBuilder::ConvertToExternalTexture", GraphBuilder.ConvertToExternalTexture(First).IsValid());
	GraphBuilder.Execute();
	CALL("AddClearUAVPass, AddCopyTexturePass", ReadFirst(OutSecond) == FLinearColor(0.5f, 0.25f, 1.0f, 1.0f));
	CALL("AddClearRenderTargetPass", ReadFirst(OutThird) == FLinearColor::Red);
	CALL("FRDGBuilder::QueueTextureExtraction", OutSecond.IsValid());
	CALL("FRDGBuilder::AddPass with a lambda", bRan && bRanCompute);
	CALL("FRDGBuilder::AddSetupTask, SetTextureAccessFinal, SetPassWorkload, AddDispatchHint", true);
	CALL("FRHIGPUTextureReadback, AddEnqueueCopyPass, IsReady, Lock, Unlock",
		[&]
		{
			int32 Pitch = 0;
			const void* const Data = Readback.Lock(Pitch);
			const bool b = Readback.IsReady() && Data != nullptr;
			Readback.Unlock();
			return b;
		}());
	CALL("FComputeShaderUtils::GetGroupCount(FIntPoint, int32)",
		FComputeShaderUtils::GetGroupCount(FIntPoint(9, 8), 8) == FIntVector(2, 1, 1));
	CALL("FComputeShaderUtils::GetGroupCount(FIntPoint, FIntPoint)",
		FComputeShaderUtils::GetGroupCount(FIntPoint(9, 8), FIntPoint(8, 4)) == FIntVector(2, 2, 1));
	CALL("FComputeShaderUtils::GetGroupCount(FIntVector, FIntVector)",
		FComputeShaderUtils::GetGroupCount(FIntVector(9, 8, 7), FIntVector(4, 4, 4)) == FIntVector(3, 2, 2));
	CALL("FComputeShaderUtils::GetGroupCount(int32, int32)",
		FComputeShaderUtils::GetGroupCount(65, 64) == FIntVector(2, 1, 1));
	CALL("FComputeShaderUtils::GetGroupCountWrapped",
		FComputeShaderUtils::GetGroupCountWrapped(100, 10) == FIntVector(10, 1, 1));
	CALL("FComputeShaderUtils::kGolden2DGroupSize", FComputeShaderUtils::kGolden2DGroupSize == 8);
	GRenderTargetPool.TickPoolElements();
	TRefCountPtr<IPooledRenderTarget> Pooled;
	CALL("GRenderTargetPool.FindFreeElement",
		GRenderTargetPool.FindFreeElement(
			FRHICommandListExecutor::GetImmediateCommandList(), MakeDesc(), Pooled, TEXT("Calls.Pooled")) ||
			Pooled.IsValid());
}

TEST(CallsOfRDG, ShadersAndScreenPasses)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	CALL("AddShaderSourceDirectoryMapping, AllShaderSourceDirectoryMappings",
		AllShaderSourceDirectoryMappings().Contains(TEXT("/DrydockTests")));
	FGlobalShaderMap* const ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
	CALL("GetGlobalShaderMap, GMaxRHIFeatureLevel", ShaderMap != nullptr);
	FCallsCS::FPermutationDomain Domain;
	Domain.Set<FCallsCS::FSwitch>(true);
	Domain.Set<FCallsCS::FCount>(2);
	Domain.Set<FCallsCS::FMode>(ECallsMode::Second);
	Domain.Set<FCallsCS::FSparse>(16);
	CALL("TShaderPermutationDomain, Set, Get, ToDimensionValueId",
		Domain.Get<FCallsCS::FSwitch>() && Domain.Get<FCallsCS::FSparse>() == 16 &&
			FCallsCS::FPermutationDomain(Domain.ToDimensionValueId()).Get<FCallsCS::FCount>() == 2);
	CALL(
		"SHADER_PERMUTATION_BOOL, _INT, _ENUM_CLASS, _SPARSE_INT", Domain.Get<FCallsCS::FMode>() == ECallsMode::Second);
	const TShaderMapRef<FCallsCS> ComputeShader(ShaderMap, Domain);
	CALL("TShaderMapRef(ShaderMap, Domain), TShaderRef::IsValid, GetComputeShader",
		ComputeShader.IsValid() && ComputeShader.GetComputeShader() != nullptr);
	CALL("DECLARE_GLOBAL_SHADER, IMPLEMENT_GLOBAL_SHADER, SHADER_USE_PARAMETER_STRUCT", true);
	CALL("DECLARE_EXPORTED_SHADER_TYPE, IMPLEMENT_SHADER_TYPE",
		TShaderMapRef<FCallsPS>(ShaderMap).GetPixelShader() != nullptr);
	CALL("ShouldCompilePermutation, FGlobalShaderPermutationParameters, IsFeatureLevelSupported",
		IsFeatureLevelSupported(GMaxRHIShaderPlatform, ERHIFeatureLevel::SM5));
	CALL("ModifyCompilationEnvironment, FShaderCompilerEnvironment::SetDefine, SET_SHADER_DEFINE, CompilerFlags", true);
	CALL("FDataDrivenShaderPlatformInfo, IsMobilePlatform, RHISupportsComputeShaders",
		!IsMobilePlatform(GMaxRHIShaderPlatform) && RHISupportsComputeShaders(GMaxRHIShaderPlatform));

	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGTextureRef Source = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Source"));
	AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Source), FLinearColor(0.25f, 0.5f, 1.0f, 1.0f));
	const FRDGTextureRef Target = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Target"));
	const FRDGTextureRef Full = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Full"));
	const FRDGTextureRef Computed = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Computed"));
	const FRDGTextureRef Drawn = GraphBuilder.CreateTexture(MakeDesc(), TEXT("Calls.Drawn"));
	const TShaderMapRef<FCallsPS> PixelShader(ShaderMap);
	const auto MakeParameters = [&](FRDGTextureRef Into)
	{
		FCallsPS::FParameters* const Parameters = GraphBuilder.AllocParameters<FCallsPS::FParameters>();
		Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Into));
		Parameters->Input = Source;
		Parameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		Parameters->RenderTargets[0] = FRenderTargetBinding(Into, ERenderTargetLoadAction::ENoAction);
		return Parameters;
	};
	const FScreenPassTextureViewport Viewport(Source);
	AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Calls.Screen"), FScreenPassViewInfo(GMaxRHIFeatureLevel), Viewport,
		Viewport, PixelShader, MakeParameters(Target));
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, ShaderMap, RDG_EVENT_NAME("Calls.Full"), PixelShader, MakeParameters(Full), FIntRect(0, 0, 4, 2));
	FCallsPS::FParameters* const Added = MakeParameters(Full);
	Added->RenderTargets[0].SetLoadAction(ERenderTargetLoadAction::ELoad);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Calls.Blended"), PixelShader, Added,
		FIntRect(0, 0, 4, 2), TStaticBlendState<CW_RGBA, BO_Add, BF_One, BF_One>::GetRHI());
	AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Calls.State"), FScreenPassViewInfo(GMaxRHIFeatureLevel), Viewport,
		Viewport, FScreenPassPipelineState(TShaderMapRef<FScreenPassVS>(ShaderMap), PixelShader), PixelShader,
		MakeParameters(Target));
	FCallsCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FCallsCS::FParameters>();
	Parameters->Color = FVector4f(1, 2, 3, 4);
	Parameters->Size = FIntPoint(4, 2);
	Parameters->OutTexture = GraphBuilder.CreateUAV(Computed);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Calls.Compute"), ComputeShader, Parameters,
		FComputeShaderUtils::GetGroupCount(FIntPoint(4, 2), 8));
	AddDrawTexturePass(GraphBuilder, FScreenPassViewInfo(GMaxRHIFeatureLevel), FScreenPassTexture(Source),
		FScreenPassRenderTarget(Drawn, ERenderTargetLoadAction::ENoAction));
	TRefCountPtr<IPooledRenderTarget> OutTarget, OutFull, OutComputed, OutDrawn;
	GraphBuilder.QueueTextureExtraction(Target, &OutTarget);
	GraphBuilder.QueueTextureExtraction(Full, &OutFull);
	GraphBuilder.QueueTextureExtraction(Computed, &OutComputed);
	GraphBuilder.QueueTextureExtraction(Drawn, &OutDrawn);

	const FScreenPassTexture SourcePass(Source);
	CALL("FScreenPassTexture(Texture), IsValid, ViewRect",
		SourcePass.IsValid() && SourcePass.ViewRect == FIntRect(0, 0, 4, 2));
	CALL("FScreenPassTexture(Texture, ViewRect)",
		FScreenPassTexture(Source, FIntRect(1, 0, 3, 2)).ViewRect.Width() == 2);
	CALL("FScreenPassTextureSlice::CreateFromScreenPassTexture",
		FScreenPassTextureSlice::CreateFromScreenPassTexture(GraphBuilder, SourcePass).IsValid());
	CALL("FScreenPassRenderTarget(Texture, ViewRect, LoadAction), GetRenderTargetBinding",
		FScreenPassRenderTarget(Source, FIntRect(0, 0, 2, 2), ERenderTargetLoadAction::ELoad)
				.GetRenderTargetBinding()
				.GetTexture() == Source);
	CALL("FScreenPassRenderTarget::CreateFromInput", FScreenPassRenderTarget::CreateFromInput(GraphBuilder, SourcePass,
														 ERenderTargetLoadAction::EClear, TEXT("Calls.FromInput"))
															 .Texture->Desc.Extent == FIntPoint(4, 2));
	CALL("FScreenPassRenderTarget::LoadAction",
		FScreenPassRenderTarget(SourcePass, ERenderTargetLoadAction::EClear).LoadAction ==
			ERenderTargetLoadAction::EClear);
	CALL("FScreenPassTextureViewport(FScreenPassTexture), Extent, Rect",
		FScreenPassTextureViewport(SourcePass).Extent == FIntPoint(4, 2));
	CALL("FScreenPassTextureViewport(Extent, Rect), IsEmpty, IsFullscreen",
		FScreenPassTextureViewport().IsEmpty() && Viewport.IsFullscreen() &&
			!FScreenPassTextureViewport(FIntPoint(4, 2), FIntRect(0, 0, 2, 2)).IsFullscreen());
	CALL("FScreenPassTextureViewport::GetRectToExtentRatio",
		FScreenPassTextureViewport(FIntPoint(4, 2), FIntRect(0, 0, 2, 2)).GetRectToExtentRatio() ==
			FVector2D(0.5, 1.0));
	CALL("GetScreenPassTextureViewportParameters",
		GetScreenPassTextureViewportParameters(Viewport).ExtentInverse == FVector2f(0.25f, 0.5f));
	CALL("GetScreenPassTextureInput, FScreenPassTextureInput",
		GetScreenPassTextureInput(SourcePass, TStaticSamplerState<SF_Point>::GetRHI()).Texture == Source);
	CALL("GetDownscaledExtent, GetDownscaledRect, GetDownscaledViewport",
		GetDownscaledExtent(FIntPoint(5, 4), FIntPoint(2, 2)) == FIntPoint(3, 2) &&
			GetDownscaledRect(FIntRect(0, 0, 5, 4), FIntPoint(2, 2)) == FIntRect(0, 0, 3, 2) &&
			GetDownscaledViewport(Viewport, FIntPoint(2, 2)).Extent == FIntPoint(2, 1));
	CALL("GetScreenPassTextureViewportTransform",
		GetScreenPassTextureViewportTransform(FVector2f(0, 0), FVector2f(4, 2), FVector2f(0, 0), FVector2f(4, 2))
				.Scale == FVector2f(1, 1));
	CALL("FScreenTransform::ChangeTextureBasisFromTo, ETextureBasis",
		[&]
		{
			const FScreenTransform T = FScreenTransform::ChangeTextureBasisFromTo(
				Viewport, FScreenTransform::ETextureBasis::TexelPosition, FScreenTransform::ETextureBasis::TextureUV);
			return T.Scale == FVector2f(0.25f, 0.5f) && T.Bias == FVector2f(0, 0);
		}());
	CALL("FScreenTransform::ChangeRectFromTo, Identity, operator*",
		(FScreenTransform::ChangeRectFromTo(FIntRect(0, 0, 2, 2), FIntRect(0, 0, 4, 4)) * FScreenTransform::Identity)
				.Scale == FVector2f(2, 2));
	CALL("FScreenPassViewInfo, EScreenPassDrawFlags::None",
		FScreenPassViewInfo(GMaxRHIFeatureLevel).FeatureLevel == GMaxRHIFeatureLevel &&
			EScreenPassDrawFlags::None == EScreenPassDrawFlags(0));
	CALL("FScreenPassPipelineState, FDefaultBlendState, FDefaultDepthStencilState",
		FScreenPassPipelineState::FDefaultBlendState::GetRHI() != nullptr);
	CALL("FScreenVS, FScreenPassVS, FCopyRectPS", TShaderMapRef<FScreenVS>(ShaderMap).GetVertexShader() != nullptr);
	FGaussianBlurInputs Blur;
	Blur.Filter = FScreenPassTextureSlice::CreateFromScreenPassTexture(GraphBuilder, SourcePass);
	CALL("FGaussianBlurInputs::Filter, KernelSizePercent, NameX", (Blur.NameX = TEXT("X")) != nullptr);
	FGenerateMips::Execute(GraphBuilder, GMaxRHIFeatureLevel, Source, FGenerateMipsParams{});
	CALL("FGenerateMips::Execute", true);
	COMPILES("FComputeShaderUtils::Dispatch, DispatchIndirect",
		FComputeShaderUtils::Dispatch(GraphBuilder.RHICmdList, ComputeShader, *Parameters, FIntVector(1, 1, 1)));
	COMPILES("SetShaderParameters, SetGraphicsPipelineState, FGraphicsPipelineStateInitializer",
			 FGraphicsPipelineStateInitializer PSO;
			 GraphBuilder.RHICmdList.ApplyCachedRenderTargets(PSO); PSO.BlendState = TStaticBlendState<>::GetRHI();
			 PSO.BoundShaderState.PixelShaderRHI = PixelShader.GetPixelShader(); PSO.PrimitiveType = PT_TriangleList;
			 SetGraphicsPipelineState(GraphBuilder.RHICmdList, PSO, 0); SetShaderParameters(
				 GraphBuilder.RHICmdList, PixelShader, PixelShader.GetPixelShader(), FCallsPS::FParameters()));
	COMPILES("DrawRectangle, DrawScreenPass, SetScreenPassPipelineState",
			 DrawScreenPass(GraphBuilder.RHICmdList, FScreenPassViewInfo(GMaxRHIFeatureLevel), Viewport, Viewport,
				 FScreenPassPipelineState(), [](FRHICommandList&) {});
			 DrawRectangle(GraphBuilder.RHICmdList, 0, 0, 4, 2, 0, 0, 4, 2, FIntPoint(4, 2), FIntPoint(4, 2)));
	CALL("ClearUnusedGraphResources",
		[&]
		{
			ClearUnusedGraphResources(PixelShader, MakeParameters(Target));
			return true;
		}());
	GraphBuilder.Execute();
	CALL("AddDrawScreenPass(PS), AddDrawScreenPass(State, PS)",
		ReadFirst(OutTarget) == FLinearColor(0.25f, 0.5f, 1.0f, 1.0f));
	CALL("FPixelShaderUtils::AddFullscreenPass", ReadFirst(OutFull) == FLinearColor(0.5f, 1.0f, 2.0f, 1.0f));
	CALL("FComputeShaderUtils::AddPass", ReadFirst(OutComputed) == FLinearColor(1, 2, 3, 4));
	CALL("AddDrawTexturePass", ReadFirst(OutDrawn) == FLinearColor(0.25f, 0.5f, 1.0f, 1.0f));
}
