// Adds the raw pass: a clear and copies, without a shader.
#include "StripesRaw.h"

#include "RenderGraphUtils.h"
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FStripeParameters, )
	RDG_TEXTURE_ACCESS(Input, ERHIAccess::CopySrc)
	RDG_TEXTURE_ACCESS(Stripe, ERHIAccess::CopySrc)
	RDG_TEXTURE_ACCESS(Output, ERHIAccess::CopyDest)
END_SHADER_PARAMETER_STRUCT()

FScreenPassTexture AddStripePass(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, int32 Width, const FLinearColor& Color)
{
	const FRDGTextureDesc StripeDesc = FRDGTextureDesc::Create2D({Width, Input.Texture->Desc.Extent.Y},
		Input.Texture->Desc.Format, FClearValueBinding(Color), TexCreate_RenderTargetable | TexCreate_ShaderResource);
	FRDGTextureRef Stripe = GraphBuilder.CreateTexture(StripeDesc, TEXT("Stripe"));
	AddClearRenderTargetPass(GraphBuilder, Stripe);

	FRDGTextureDesc OutputDesc = Input.Texture->Desc;
	OutputDesc.Reset();
	FRDGTextureRef Output = GraphBuilder.CreateTexture(OutputDesc, TEXT("StripesOutput"));

	FStripeParameters* Parameters = GraphBuilder.AllocParameters<FStripeParameters>();
	Parameters->Input = Input.Texture;
	Parameters->Stripe = Stripe;
	Parameters->Output = Output;
	GraphBuilder.AddPass(RDG_EVENT_NAME("Stripes"), Parameters, ERDGPassFlags::Copy,
		[Parameters](FRHICommandList& RHICmdList)
		{
			RHICmdList.CopyTexture(Parameters->Input->GetRHI(), Parameters->Output->GetRHI(), FRHICopyTextureInfo());
			RHICmdList.CopyTexture(Parameters->Stripe->GetRHI(), Parameters->Output->GetRHI(), FRHICopyTextureInfo());
		});
	return FScreenPassTexture(Output, Input.ViewRect);
}
