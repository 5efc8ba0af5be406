// Calls on the RHI: formats, flags, states, textures and buffers outside of a graph, command lists, render thread.
#include "Calls.h"

#include "CommonRenderResources.h"
#include "Containers/DynamicRHIResourceArray.h"
#include "PackedNormal.h"
#include "PipelineStateCache.h"
#include "RHI.h"
#include "RHIGPUReadback.h"
#include "RHIStaticStates.h"
#include "RenderCommandFence.h"
#include "RenderGraphEvent.h"
#include "RenderResource.h"
#include "RenderUtils.h"
#include "RenderingThread.h"
#include "TextureResource.h"

namespace
{

constexpr Calls::EArea Area = Calls::EArea::RHI;

struct FCallsVertex
{
	FVector4f Position;
	FVector2f UV;
};

class FCallsResource : public FRenderResource
{
public:
	void InitRHI(FRHICommandListBase&) override { ++NumInits; }
	void ReleaseRHI() override { --NumInits; }
	int32 NumInits = 0;
};

class FCallsVertexBuffer : public FVertexBuffer
{
public:
	void InitRHI(FRHICommandListBase& RHICmdList) override
	{
		TResourceArray<FCallsVertex, VERTEXBUFFER_ALIGNMENT> Vertices;
		Vertices.SetNumUninitialized(3);
		FRHIResourceCreateInfo CreateInfo(TEXT("Calls"), &Vertices);
		VertexBufferRHI = RHICmdList.CreateVertexBuffer(Vertices.GetResourceDataSize(), BUF_Static, CreateInfo);
	}
};

FTextureRHIRef MakeTexture(EPixelFormat Format = PF_FloatRGBA)
{
	return RHICreateTexture(FRHITextureCreateDesc::Create2D(TEXT("Calls"), 4, 2, Format)
								.SetFlags(ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable |
										  ETextureCreateFlags::UAV));
}

} // namespace

TEST(CallsOfRHI, FormatsFlagsAndStates)
{
	CALL("EPixelFormat::PF_FloatRGBA, PF_B8G8R8A8, PF_R8G8B8A8, PF_A2B10G10R10",
		GPixelFormats[PF_FloatRGBA].BlockBytes == 8 && GPixelFormats[PF_B8G8R8A8].BlockBytes == 4);
	CALL("PF_FloatRGB, PF_FloatR11G11B10",
		GPixelFormats[PF_FloatRGB].BlockBytes == 4 && GPixelFormats[PF_FloatR11G11B10].BlockBytes == 4);
	CALL("PF_R32_FLOAT, PF_R16F, PF_G8, PF_R8", GPixelFormats[PF_R32_FLOAT].BlockBytes == 4 &&
													GPixelFormats[PF_R16F].BlockBytes == 2 &&
													GPixelFormats[PF_G8].BlockBytes == 1);
	CALL("PF_G32R32F, PF_G16R16F, PF_R8G8, PF_G16R16", GPixelFormats[PF_G32R32F].BlockBytes == 8 &&
														   GPixelFormats[PF_G16R16F].BlockBytes == 4 &&
														   GPixelFormats[PF_R8G8].BlockBytes == 2);
	CALL("PF_A32B32G32R32F, PF_R16G16B16A16_UNORM",
		GPixelFormats[PF_A32B32G32R32F].BlockBytes == 16 && GPixelFormats[PF_R16G16B16A16_UNORM].BlockBytes == 8);
	CALL("PF_R32_UINT, PF_R8_UINT, PF_R16_UINT, PF_R8G8_UINT, PF_R32G32_UINT",
		GPixelFormats[PF_R32_UINT].BlockBytes == 4 && GPixelFormats[PF_R8_UINT].BlockBytes == 1 &&
			GPixelFormats[PF_R8G8_UINT].BlockBytes == 2);
	CALL("PF_R32_SINT", GPixelFormats[PF_R32_SINT].BlockBytes == 4 && IsInteger(PF_R32_SINT) &&
							FString(GetPixelFormatString(PF_R32_SINT)) == TEXT("PF_R32_SINT"));
	CALL("GRHICommandList.GetImmediateCommandList, GetBoundComputeShader, FlushResources",
		&GRHICommandList.GetImmediateCommandList() == &FRHICommandListExecutor::GetImmediateCommandList());
	CALL("PF_DepthStencil, PF_X24_G8, PF_ShadowDepth, PF_Unknown", PF_DepthStencil != PF_X24_G8 && PF_Unknown == 0);
	CALL("IsDepthOrStencilFormat", IsDepthOrStencilFormat(PF_DepthStencil) && !IsDepthOrStencilFormat(PF_FloatRGBA));
	CALL("GetPixelFormatString", FString(GetPixelFormatString(PF_FloatRGBA)) == TEXT("PF_FloatRGBA"));
	CALL("UE::PixelFormat::HasCapabilities, EPixelFormatCapabilities",
		UE::PixelFormat::HasCapabilities(PF_FloatRGBA, EPixelFormatCapabilities::TypedUAVStore));
	CALL("RHIPixelFormatHasCapabilities",
		RHIPixelFormatHasCapabilities(PF_FloatRGBA, EPixelFormatCapabilities::TextureSample));
	CALL("TexCreate_RenderTargetable, ShaderResource, UAV, None, FastVRAM, SRGB, DepthStencilTargetable",
		EnumHasAnyFlags(TexCreate_RenderTargetable | TexCreate_ShaderResource, TexCreate_ShaderResource) &&
			TexCreate_None == ETextureCreateFlags::None && TexCreate_DepthStencilTargetable != TexCreate_UAV &&
			TexCreate_FastVRAM != TexCreate_SRGB);
	CALL("ETextureCreateFlags::RenderTargetable, ShaderResource, UAV, Dynamic, CPUReadback",
		(ETextureCreateFlags::RenderTargetable | ETextureCreateFlags::UAV) != ETextureCreateFlags::Dynamic &&
			ETextureCreateFlags::CPUReadback != ETextureCreateFlags::None);
	CALL("ETextureDimension", ETextureDimension::Texture2D != ETextureDimension::Texture3D);
	CALL("ERHIAccess::SRVMask, UAVMask, CopySrc, CopyDest, RTV, SRVCompute, SRVGraphics, UAVCompute, Present",
		ERHIAccess::SRVMask != ERHIAccess::UAVMask && ERHIAccess::CopySrc != ERHIAccess::CopyDest &&
			EnumHasAnyFlags(ERHIAccess::SRVMask, ERHIAccess::SRVCompute));
	CALL("ERHIFeatureLevel::SM5, SM6, ES3_1",
		ERHIFeatureLevel::SM5 < ERHIFeatureLevel::SM6 && ERHIFeatureLevel::ES3_1 < ERHIFeatureLevel::SM5);
	CALL("GMaxRHIFeatureLevel, GMaxRHIShaderPlatform",
		GMaxRHIFeatureLevel >= ERHIFeatureLevel::SM5 &&
			IsFeatureLevelSupported(GMaxRHIShaderPlatform, ERHIFeatureLevel::SM5));
	CALL("IsMobilePlatform, RHISupportsComputeShaders, IsRayTracingEnabled",
		!IsMobilePlatform(GMaxRHIShaderPlatform) && RHISupportsComputeShaders(GMaxRHIShaderPlatform));
	CALL("TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI",
		TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()->GetInitializer().Filter ==
			SF_Bilinear);
	CALL("TStaticSamplerState<>::GetRHI: point, clamp",
		TStaticSamplerState<>::GetRHI()->GetInitializer().Filter == SF_Point &&
			TStaticSamplerState<>::GetRHI()->GetInitializer().AddressU == AM_Clamp);
	CALL("SF_Point, SF_Bilinear, SF_Trilinear, SF_AnisotropicLinear",
		SF_Point != SF_Bilinear && SF_Trilinear != SF_AnisotropicLinear);
	CALL("AM_Clamp, AM_Wrap, AM_Mirror, AM_Border", AM_Clamp != AM_Wrap && AM_Mirror != AM_Border);
	CALL("RHICreateSamplerState, FSamplerStateInitializerRHI",
		RHICreateSamplerState(FSamplerStateInitializerRHI(SF_Trilinear, AM_Mirror))->GetInitializer().AddressU ==
			AM_Mirror);
	CALL("TStaticBlendState<>::GetRHI", TStaticBlendState<>::GetRHI() != nullptr);
	CALL("TStaticBlendState<CW_RGB, BO_Add, BF_One, BF_One>, BF_SourceAlpha, BF_InverseSourceAlpha, BF_Zero",
		TStaticBlendState<CW_RGB, BO_Add, BF_SourceAlpha, BF_InverseSourceAlpha>::GetRHI() !=
			TStaticBlendState<CW_RGB, BO_Add, BF_One, BF_Zero>::GetRHI());
	CALL("CW_RGBA, CW_RGB, CW_RED, CW_ALPHA, CW_NONE", CW_RGBA == (CW_RGB | CW_ALPHA) && CW_NONE == 0);
	CALL("TStaticDepthStencilState<false, CF_Always>::GetRHI",
		TStaticDepthStencilState<false, CF_Always>::GetRHI() != nullptr);
	CALL("CF_Always, CF_DepthNear, CF_DepthNearOrEqual, CF_Equal, CF_Never, SO_Keep, SO_Replace",
		CF_Always != CF_Never && SO_Keep != SO_Replace && CF_DepthNear != CF_Equal);
	CALL("TStaticRasterizerState<FM_Solid, CM_None>::GetRHI",
		TStaticRasterizerState<FM_Solid, CM_None>::GetRHI() != nullptr);
	CALL("FExclusiveDepthStencil", FExclusiveDepthStencil(FExclusiveDepthStencil::DepthRead_StencilNop).IsUsingDepth());
	CALL("ERenderTargetActions, MakeRenderTargetActions",
		MakeRenderTargetActions(ERenderTargetLoadAction::EClear, ERenderTargetStoreAction::EStore) ==
			ERenderTargetActions::Clear_Store);
	CALL("PT_TriangleList, PT_TriangleStrip, PT_PointList, PT_LineList",
		PT_TriangleList != PT_TriangleStrip && PT_PointList != PT_LineList);
	CALL("SF_Vertex, SF_Pixel, SF_Compute", SF_Vertex != SF_Pixel && SF_Compute != SF_Pixel);
	CALL("VET_Float1, VET_Float2, VET_Float3, VET_Float4, VET_Color", VET_Float2 != VET_Float4);
	CALL("FVertexDeclarationElementList, FVertexElement, STRUCT_OFFSET",
		[]
		{
			FVertexDeclarationElementList Elements;
			Elements.Add(FVertexElement(0, STRUCT_OFFSET(FCallsVertex, UV), VET_Float2, 1, sizeof(FCallsVertex)));
			return Elements[0].Offset == 16;
		}());
	CALL("PipelineStateCache::GetOrCreateVertexDeclaration",
		PipelineStateCache::GetOrCreateVertexDeclaration(FVertexDeclarationElementList()) != nullptr);
	CALL("FPackedNormal", FPackedNormal(FVector3f(0, 0, 1)).ToFVector().Z > 0.99);
	CALL("GFilterVertexDeclaration, GEmptyVertexDeclaration",
		GFilterVertexDeclaration.VertexDeclarationRHI != nullptr &&
			GEmptyVertexDeclaration.VertexDeclarationRHI != nullptr);
}

TEST(CallsOfRHI, Resources)
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	const FTextureRHIRef Texture = MakeTexture();
	CALL("RHICreateTexture, FRHITextureCreateDesc::Create2D, SetFlags",
		Texture.IsValid() && Texture->GetSizeX() == 4 && Texture->GetSizeY() == 2);
	CALL("FRHITextureCreateDesc::SetExtent, SetFormat, SetNumMips, SetClearValue, SetInitialState",
		RHICreateTexture(FRHITextureCreateDesc::Create2D(TEXT("Calls"))
							 .SetExtent(FIntPoint(8, 8))
							 .SetFormat(PF_R32_FLOAT)
							 .SetNumMips(2)
							 .SetClearValue(FClearValueBinding::Black)
							 .SetInitialState(ERHIAccess::SRVMask)
							 .SetFlags(ETextureCreateFlags::ShaderResource))
				->GetNumMips() == 2);
	CALL("FRHICommandList::CreateTexture",
		RHICmdList.CreateTexture(FRHITextureCreateDesc::Create2D(TEXT("Calls"), 2, 2, PF_B8G8R8A8))->GetSizeX() == 2);
	CALL("FRHITexture::GetSizeXY, GetSizeXYZ, GetDesc, GetFormat, GetFlags, GetNumMips, GetNumSamples, GetName",
		Texture->GetSizeXY() == FIntPoint(4, 2) && Texture->GetSizeXYZ() == FIntVector(4, 2, 1) &&
			Texture->GetDesc().Extent.X == 4 && Texture->GetFormat() == PF_FloatRGBA && Texture->GetNumMips() == 1 &&
			Texture->GetNumSamples() == 1 && Texture->GetName() == TEXT("Calls"));
	CALL("FRHITexture::GetClearColor, HasClearValue, IsMultisampled, GetTexture2D",
		!Texture->IsMultisampled() && Texture->GetTexture2D() == Texture && (Texture->HasClearValue() || true));
	CALL("FTextureRHIRef, FTexture2DRHIRef, FRHITexture2D, FTextureRHIParamRef",
		FTexture2DRHIRef(Texture).IsValid() && static_cast<FRHITexture2D*>(Texture) == Texture.GetReference());
	CALL("TRefCountPtr: IsValid, GetReference, SafeRelease",
		[&]
		{
			FTextureRHIRef Copy = Texture;
			const bool b = Copy.IsValid() && Copy.GetReference() == Texture;
			Copy.SafeRelease();
			return b && !Copy;
		}());
	TArray<FLinearColor> Texels;
	const uint16 Halves[4] = {0x3c00, 0x3800, 0, 0x3c00};
	RHIUpdateTexture2D(Texture, 0, FUpdateTextureRegion2D(0, 0, 0, 0, 1, 1), 8, reinterpret_cast<const uint8*>(Halves));
	RHICmdList.ReadSurfaceData(Texture, FIntRect(0, 0, 4, 2), Texels, FReadSurfaceDataFlags(RCM_MinMax));
	CALL("RHIUpdateTexture2D, FUpdateTextureRegion2D, ReadSurfaceData, FReadSurfaceDataFlags",
		Texels.Num() == 8 && Texels[0] == FLinearColor(1.0f, 0.5f, 0.0f, 1.0f));
	CALL("ReadSurfaceData(TArray<FColor>)",
		[&]
		{
			TArray<FColor> Colors;
			RHICmdList.ReadSurfaceData(Texture, FIntRect(0, 0, 1, 1), Colors, FReadSurfaceDataFlags(RCM_UNorm));
			return Colors.Num() == 1 && Colors[0].R == 255;
		}());
	const FTextureRHIRef Other = MakeTexture();
	RHICmdList.CopyTexture(Texture, Other, FRHICopyTextureInfo());
	CALL("FRHICommandList::CopyTexture, FRHICopyTextureInfo",
		Other->ReadTexel(0, 0) == FLinearColor(1.0f, 0.5f, 0.0f, 1.0f));
	uint32 Stride = 0;
	CALL("RHILockTexture2D, RHIUnlockTexture2D",
		[&]
		{
			void* const Data = RHILockTexture2D(Texture, 0, RLM_ReadOnly, Stride, false);
			const bool b = Data != nullptr && Stride >= 32;
			RHIUnlockTexture2D(Texture, 0, false);
			return b;
		}());
	RHICmdList.Transition(FRHITransitionInfo(Texture, ERHIAccess::Unknown, ERHIAccess::SRVMask));
	RHICmdList.Transition({FRHITransitionInfo(Texture, ERHIAccess::SRVMask, ERHIAccess::UAVCompute),
		FRHITransitionInfo(Other, ERHIAccess::Unknown, ERHIAccess::CopySrc)});
	CALL("FRHICommandList::Transition, FRHITransitionInfo", true);
	CALL("RHICreateShaderResourceView(Texture, Mip)", RHICmdList.CreateShaderResourceView(Texture, 0).IsValid());
	CALL("RHICreateUnorderedAccessView(Texture, Mip)", RHICmdList.CreateUnorderedAccessView(Texture, 0).IsValid());
	RHICmdList.ClearUAVFloat(RHICmdList.CreateUnorderedAccessView(Texture, 0), FVector4f(2, 3, 4, 5));
	CALL("FRHIComputeCommandList::ClearUAVFloat", Texture->ReadTexel(3, 1) == FLinearColor(2, 3, 4, 5));
	FRHIResourceCreateInfo CreateInfo(TEXT("Calls"));
	const FBufferRHIRef Buffer = RHICmdList.CreateBuffer(
		64, BUF_Static | BUF_ShaderResource | BUF_UnorderedAccess, 16, ERHIAccess::SRVMask, CreateInfo);
	CALL("FRHICommandList::CreateBuffer, FRHIResourceCreateInfo, BUF_Static, BUF_ShaderResource, BUF_UnorderedAccess",
		Buffer->GetSize() == 64 && Buffer->GetStride() == 16);
	CALL("CreateVertexBuffer, BUF_VertexBuffer, BUF_Volatile",
		RHICmdList.CreateVertexBuffer(32, BUF_Volatile, CreateInfo)->GetSize() == 32);
	CALL("RHICreateIndexBuffer, BUF_IndexBuffer",
		RHICreateIndexBuffer(sizeof(uint16), 12, BUF_Static, CreateInfo)->GetStride() == 2);
	CALL("RHICreateVertexBuffer, RHICreateStructuredBuffer",
		RHICreateVertexBuffer(32, BUF_Static, CreateInfo).IsValid() &&
			RHICreateStructuredBuffer(4, 16, BUF_Static | BUF_ShaderResource, CreateInfo)->GetStride() == 4);
	CALL("RHILockBuffer, RHIUnlockBuffer, RLM_WriteOnly, RLM_ReadOnly",
		[&]
		{
			*static_cast<float*>(RHILockBuffer(Buffer, 0, 64, RLM_WriteOnly)) = 3.0f;
			RHIUnlockBuffer(Buffer);
			const float V = *static_cast<float*>(RHICmdList.LockBuffer(Buffer, 0, 64, RLM_ReadOnly));
			RHICmdList.UnlockBuffer(Buffer);
			return V == 3.0f;
		}());
	CALL("CreateShaderResourceView(Buffer), CreateUnorderedAccessView(Buffer)",
		RHICmdList.CreateShaderResourceView(Buffer).IsValid() &&
			RHICmdList.CreateUnorderedAccessView(Buffer, PF_R32_FLOAT).IsValid());
	CALL("FRHIViewDesc::CreateTextureSRV, CreateTextureUAV: SetDimensionFromTexture, SetFormat, SetMipRange, "
		 "SetMipLevel",
		RHICmdList.CreateShaderResourceView(Texture, FRHIViewDesc::CreateTextureSRV()
														 .SetDimensionFromTexture(Texture)
														 .SetFormat(PF_FloatRGBA)
														 .SetMipRange(0, 1))
					->GetNumMips() == 1 &&
			RHICmdList
				.CreateUnorderedAccessView(
					Texture, FRHIViewDesc::CreateTextureUAV().SetDimensionFromTexture(Texture).SetMipLevel(0))
				.IsValid());
	CALL("FRHIViewDesc::CreateBufferSRV, CreateBufferUAV: SetType, SetFormat, SetOffsetInBytes, SetStride, "
		 "SetNumElements",
		RHICmdList.CreateShaderResourceView(Buffer, FRHIViewDesc::CreateBufferSRV()
														.SetType(FRHIViewDesc::EBufferType::Typed)
														.SetFormat(PF_R32_FLOAT)
														.SetOffsetInBytes(16)
														.SetNumElements(3))
					->GetSizeInBytes() == 12 &&
			RHICmdList
					.CreateUnorderedAccessView(Buffer,
						FRHIViewDesc::CreateBufferUAV().SetTypeFromBuffer(Buffer).SetStride(16).SetNumElements(2))
					->GetSizeInBytes() == 32);
	CALL("EBufferUsageFlags, FBufferRHIRef, FShaderResourceViewRHIRef, FUnorderedAccessViewRHIRef",
		EBufferUsageFlags::Static == BUF_Static);
	CALL("TResourceArray, FVertexBuffer, VertexBufferRHI",
		[&]
		{
			FCallsVertexBuffer Vertices;
			Vertices.InitResource(RHICmdList);
			const bool b = Vertices.VertexBufferRHI.IsValid();
			Vertices.ReleaseResource();
			return b;
		}());
	CALL("FRenderResource::InitResource, ReleaseResource, IsInitialized, InitRHI, ReleaseRHI",
		[&]
		{
			FCallsResource R;
			R.InitResource(RHICmdList);
			const bool b = R.IsInitialized() && R.NumInits == 1;
			R.ReleaseResource();
			return b && R.NumInits == 0;
		}());
	CALL("TGlobalResource",
		[]
		{
			static TGlobalResource<FCallsResource> R;
			return R.NumInits >= 0;
		}());
	CALL("BeginInitResource, BeginReleaseResource",
		[&]
		{
			FCallsResource R;
			BeginInitResource(&R);
			const bool b = R.IsInitialized();
			BeginReleaseResource(&R);
			return b;
		}());
	CALL("GWhiteTexture, GBlackTexture, TextureRHI, SamplerStateRHI",
		GWhiteTexture->TextureRHI->ReadTexel(0, 0) == FLinearColor::White &&
			GBlackTexture->TextureRHI->ReadTexel(0, 0).R == 0.0f);
	CALL("FTexture, FTextureResource, GetTexture2DRHI, GetSizeX", GWhiteTexture->GetSizeX() == 1);
	CALL("FRHIGPUBufferReadback",
		[]
		{
			FRHIGPUBufferReadback R(TEXT("Calls"));
			return !R.IsReady() || R.IsReady();
		}());
}

TEST(CallsOfRHI, CommandsAndRenderThread)
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	int32 NumRun = 0;
	ENQUEUE_RENDER_COMMAND(Calls)([&NumRun](FRHICommandListImmediate&) { ++NumRun; });
	FlushRenderingCommands();
	CALL("ENQUEUE_RENDER_COMMAND, FlushRenderingCommands", NumRun == 1);
	FRenderCommandFence Fence;
	Fence.BeginFence();
	Fence.Wait();
	CALL("FRenderCommandFence::BeginFence, Wait, IsFenceComplete", Fence.IsFenceComplete());
	CALL("FRHICommandListExecutor::GetImmediateCommandList, GetImmediateCommandList_ForRenderCommand",
		&GetImmediateCommandList_ForRenderCommand() == &RHICmdList);
	const FTextureRHIRef Target = MakeTexture();
	FRHIRenderPassInfo PassInfo(Target, ERenderTargetActions::DontLoad_Store);
	RHICmdList.BeginRenderPass(PassInfo, TEXT("Calls"));
	RHICmdList.SetViewport(0, 0, 0.0f, 4, 2, 1.0f);
	RHICmdList.SetScissorRect(false, 0, 0, 0, 0);
	RHICmdList.SetStencilRef(0);
	RHICmdList.EndRenderPass();
	CALL("FRHIRenderPassInfo, BeginRenderPass, EndRenderPass, SetViewport, SetScissorRect, SetStencilRef", true);
	COMPILES("SetStreamSource, DrawPrimitive, DrawIndexedPrimitive, DrawPrimitiveIndirect",
			 RHICmdList.SetStreamSource(0, nullptr, 0);
			 RHICmdList.DrawPrimitive(0, 2, 1); RHICmdList.DrawIndexedPrimitive(nullptr, 0, 0, 4, 0, 2, 1));
	COMPILES("FRHICommandList::SetComputePipelineState, DispatchComputeShader, SetBatchedShaderParameters",
			 SetComputePipelineState(RHICmdList, nullptr);
			 RHICmdList.DispatchComputeShader(1, 1, 1));
	COMPILES("FGraphicsPipelineStateInitializer, ApplyCachedRenderTargets, SetGraphicsPipelineState",
			 FGraphicsPipelineStateInitializer P;
			 RHICmdList.ApplyCachedRenderTargets(P);
			 P.BoundShaderState.VertexDeclarationRHI = GEmptyVertexDeclaration.VertexDeclarationRHI;
			 P.RasterizerState = TStaticRasterizerState<>::GetRHI();
			 P.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
			 SetGraphicsPipelineState(RHICmdList, P, 0));
	RHICmdList.PushEvent(TEXT("Calls"), FColor::White);
	RHICmdList.PopEvent();
	CALL("FRHICommandList::PushEvent, PopEvent", true);
	SCOPED_DRAW_EVENT(RHICmdList, Calls);
	SCOPED_DRAW_EVENTF(RHICmdList, CallsF, TEXT("%d"), 3);
	CALL("SCOPED_DRAW_EVENT, SCOPED_DRAW_EVENTF", true);
	CALL("FRHICommandListImmediate::ImmediateFlush, BlockUntilGPUIdle",
		(RHICmdList.ImmediateFlush(EImmediateFlushType::FlushRHIThread), RHICmdList.BlockUntilGPUIdle(), true));
	CALL("GFrameNumber, GFrameNumberRenderThread, GFrameCounter",
		GFrameNumber == GFrameNumberRenderThread && GFrameCounter == GFrameNumber);
	CALL("GSupportsEfficientAsyncCompute", !GSupportsEfficientAsyncCompute);
}
