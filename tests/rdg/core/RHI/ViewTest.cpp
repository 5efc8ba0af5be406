// Views of textures and buffers show the range and the format they were made with.
#include <cstring>

#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

TEST(KernelView, AllMipsByDefault)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(8, 8), PF_FloatRGBA, 4));
	const FKernelTexture View = Texture->GetKernelView();
	EXPECT_EQ(4, View.NumMips);
	EXPECT_EQ(8, View.Mips[0].SizeX);
	EXPECT_EQ(0, View.bIs3D);
}

TEST(KernelView, MipsStartAtTheFirstAskedFor)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(8, 8), PF_FloatRGBA, 4));
	const FKernelTexture View = Texture->GetKernelView(2, 1);
	EXPECT_EQ(1, View.NumMips);
	EXPECT_EQ(2, View.Mips[0].SizeX);
	EXPECT_EQ(Texture->GetTexel(0, 0, 2), View.Mips[0].Data);
}

TEST(KernelView, ASliceIsA2DTexture)
{
	const FTextureRHIRef Texture = MakeTexture(
		FRHITextureDesc::Create3D(FIntVector(4, 4, 4), PF_R32_FLOAT, FClearValueBinding::Black, TexCreate_UAV, 2));
	EXPECT_EQ(1, Texture->GetKernelView().bIs3D);
	const FKernelTexture Slice = Texture->GetKernelView(1, 1, 1);
	EXPECT_EQ(0, Slice.bIs3D);
	EXPECT_EQ(1, Slice.Mips[0].SizeZ);
	EXPECT_EQ(Texture->GetTexel(0, 0, 1, 1), Slice.Mips[0].Data);
}

TEST(KernelView, MissingMipsAndSlicesAreChecked)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(8, 8), PF_FloatRGBA, 2));
	EXPECT_THROW(Texture->GetKernelView(1, 2), FCheckFailure);
	EXPECT_THROW(Texture->GetKernelView(0, 1, 1), FCheckFailure);
}

TEST(View, AnSrvSeesAllMipsAnUavOne)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(8, 8), PF_FloatRGBA, 4));
	const FShaderResourceViewRHIRef Srv = new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo());
	const FUnorderedAccessViewRHIRef Uav = RHICreateUnorderedAccessView(Texture, 1);
	EXPECT_EQ(4, Srv->GetKernelTexture().NumMips);
	EXPECT_EQ(1, Uav->GetKernelTexture().NumMips);
	EXPECT_EQ(4, Uav->GetKernelTexture().Mips[0].SizeX);
}

TEST(View, KeepsItsTextureAlive)
{
	FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	const FShaderResourceViewRHIRef View = RHICreateShaderResourceView(Texture, 0);
	EXPECT_EQ(2u, Texture->GetRefCount());
	Texture = nullptr;
	EXPECT_EQ(4, View->GetKernelTexture().Mips[0].SizeX);
}

TEST(View, ARangeOfSlices)
{
	const FTextureRHIRef Texture = MakeTexture(FRHITextureDesc::Create2DArray(
		FIntPoint(4, 4), PF_R32_FLOAT, FClearValueBinding::Black, TexCreate_ShaderResource, 5));
	const FShaderResourceViewRHIRef View = new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 1, 2, 2));
	EXPECT_EQ(2, View->GetKernelTexture().Mips[0].SizeZ);
	EXPECT_EQ(Texture->GetTexel(0, 0, 0, 2), View->GetKernelTexture().Mips[0].Data);
	EXPECT_EQ(2u * 16 * 4, View->GetSizeInBytes());
}

TEST(View, BeyondTheTextureIsChecked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	EXPECT_THROW(new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(1, 1)), FCheckFailure);
	EXPECT_THROW(new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 2)), FCheckFailure);
	EXPECT_THROW(new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 1, 0, 2)), FCheckFailure);
}

TEST(View, AFormatOfTheSameSizeReinterprets)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R32_FLOAT);
	const FShaderResourceViewRHIRef View =
		new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 1, PF_R32_UINT));
	EXPECT_EQ(ETexelStorage::R32_UINT, View->GetKernelTexture().Storage);
}

TEST(View, AFormatOfAnotherSizeIsChecked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R32_FLOAT);
	EXPECT_THROW(new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 1, PF_FloatRGBA)), FCheckFailure);
}

TEST(View, UavFormatOfTheDescriptionIsUsed)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(1, 1), PF_B8G8R8A8);
	Desc.UAVFormat = PF_R8G8B8A8;
	const FTextureRHIRef Texture = MakeTexture(Desc);
	EXPECT_EQ(ETexelStorage::RGBA8_UNORM, RHICreateUnorderedAccessView(Texture)->GetKernelTexture().Storage);
}

TEST(View, TheStencilPlaneIsX24G8)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_DepthStencil);
	const FShaderResourceViewRHIRef View =
		new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(0, 1, PF_X24_G8));
	EXPECT_EQ(ETexelStorage::R8_UINT, View->GetKernelTexture().Storage);
	EXPECT_EQ(Texture->GetTexel(0, 0, 0, 0, 1), View->GetKernelTexture().Mips[0].Data);
}

TEST(View, TheWrongKindIsChecked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	EXPECT_THROW(RHICreateShaderResourceView(Texture, 0)->GetKernelBuffer(), FCheckFailure);
}

TEST(Buffer, StructuredViewsHaveTheStride)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(12, 120, BUF_ShaderResource, TEXT("Test"));
	const FKernelBuffer View = RHICreateShaderResourceView(Buffer)->GetKernelBuffer();
	EXPECT_EQ(12u, View.Stride);
	EXPECT_EQ(120u, View.SizeInBytes);
}

TEST(Buffer, TypedViewsHaveTheFormat)
{
	const FBufferRHIRef Buffer = RHICreateVertexBuffer(64, BUF_ShaderResource, TEXT("Test"));
	const FKernelBuffer View = RHICreateUnorderedAccessView(Buffer, PF_FloatRGBA)->GetKernelBuffer();
	EXPECT_EQ(ETexelStorage::RGBA16_FLOAT, View.Storage);
	EXPECT_EQ(8u, View.Stride);
}

TEST(Buffer, AViewMayStartLater)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(4, 64, BUF_ShaderResource, TEXT("Test"));
	const FShaderResourceViewRHIRef View =
		new FRHIShaderResourceView(Buffer, FRHIBufferSRVCreateInfo(PF_R32_UINT, 16, 4));
	EXPECT_EQ(Buffer->GetData() + 16, View->GetKernelBuffer().Data);
	EXPECT_EQ(16u, View->GetKernelBuffer().SizeInBytes);
	EXPECT_THROW(new FRHIShaderResourceView(Buffer, FRHIBufferSRVCreateInfo(PF_R32_UINT, 60, 2)), FCheckFailure);
}

TEST(Buffer, LocksGiveItsBytes)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(4, 16, BUF_ShaderResource, TEXT("Test"));
	const uint32 Value = 42;
	std::memcpy(RHILockBuffer(Buffer, 8, 4, RLM_WriteOnly), &Value, 4);
	RHIUnlockBuffer(Buffer);
	EXPECT_EQ(42, Buffer->GetData()[8]);
	EXPECT_THROW(RHILockBuffer(Buffer, 8, 12, RLM_WriteOnly), FCheckFailure);
}

TEST(Buffer, AnEmptyOneIsChecked)
{
	EXPECT_THROW(RHICreateStructuredBuffer(4, 0, BUF_ShaderResource, TEXT("Test")), FCheckFailure);
}
