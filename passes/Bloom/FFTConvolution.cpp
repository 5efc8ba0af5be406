// Sizes of a transform and the pass that multiplies spectra.
#include "Bloom/FFTConvolution.h"

#include "GlobalShader.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"

#include <bit>

namespace Drydock
{

namespace
{

class FMultiplySpectraCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMultiplySpectraCS);
	SHADER_USE_PARAMETER_STRUCT(FMultiplySpectraCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FIntPoint, OutputSize)
		SHADER_PARAMETER(FIntPoint, FirstAxis)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, KernelTexture)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, FFTMulParameters)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FMultiplySpectraCS, "/Engine/Private/PostProcessFFTBloom.usf", "MultiplySpectraCS", SF_Compute);

int32 RoundUpToPowerOfTwo(int32 Size)
{
	return static_cast<int32>(std::bit_ceil(static_cast<uint32>(FMath::Max(Size, 2))));
}

} // namespace

FFFTDomain FFFTDomain::Make(FIntPoint ImageSize, FIntPoint MinSize)
{
	check(ImageSize.X > 0 && ImageSize.Y > 0);
	FFFTDomain Domain;
	Domain.ImageSize = ImageSize;
	Domain.FrequencySize = FIntPoint(RoundUpToPowerOfTwo(FMath::Max(MinSize.X, ImageSize.X)),
		RoundUpToPowerOfTwo(FMath::Max(MinSize.Y, ImageSize.Y)));
	const int64 HorizontalFirst = int64(Domain.FrequencySize.X + 2) * ImageSize.Y;
	const int64 VerticalFirst = int64(Domain.FrequencySize.Y + 2) * ImageSize.X;
	Domain.bHorizontalFirst = HorizontalFirst <= VerticalFirst;
	return Domain;
}

FIntPoint FFFTDomain::GetSpectrumExtent() const
{
	return FrequencySize + (bHorizontalFirst ? FIntPoint(2, 0) : FIntPoint(0, 2));
}

FRDGTextureRef AddMultiplySpectraPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFFTDomain& Domain,
	FRDGTextureRef ImageSpectrum, FRDGTextureRef KernelSpectrum, FRDGBufferRef FFTMulParameters)
{
	const FIntPoint Extent = Domain.GetSpectrumExtent();
	check(ImageSpectrum->Desc.Extent == Extent && KernelSpectrum->Desc.Extent == Extent);
	const FIntPoint Axis = Domain.bHorizontalFirst ? FIntPoint(1, 0) : FIntPoint(0, 1);
	const FRDGTextureRef Product = GraphBuilder.CreateTexture(ImageSpectrum->Desc, TEXT("Bloom.ProductSpectrum"));

	FMultiplySpectraCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FMultiplySpectraCS::FParameters>();
	PassParameters->FirstAxis = Axis;
	PassParameters->OutputSize = Extent;
	PassParameters->InputTexture = ImageSpectrum;
	PassParameters->KernelTexture = KernelSpectrum;
	PassParameters->FFTMulParameters = GraphBuilder.CreateSRV(FFTMulParameters);
	PassParameters->OutputTexture = GraphBuilder.CreateUAV(Product);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("FFTBloom.Multiply %dx%d (CS)", Extent.X, Extent.Y),
		TShaderMapRef<FMultiplySpectraCS>(View.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(
			FIntPoint(Extent.X / (1 + Axis.X), Extent.Y / (1 + Axis.Y)), FComputeShaderUtils::kGolden2DGroupSize));
	return Product;
}

} // namespace Drydock
