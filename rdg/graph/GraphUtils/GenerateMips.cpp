// Fills mips on the CPU, texel by texel.
#include "GenerateMips.h"

BEGIN_SHADER_PARAMETER_STRUCT(FGenerateMipsParameters, )
	RDG_TEXTURE_ACCESS(Texture, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

namespace
{

/** The texels at both sides of the middle of a texel of the smaller mip, and the share of the second. */
struct FSide
{
	int32 First;
	int32 Second;
	float Share;

	FSide(int32 Index, int32 Size, int32 SizeAbove)
	{
		const float Place =
			(static_cast<float>(Index) + 0.5f) * static_cast<float>(SizeAbove) / static_cast<float>(Size);
		First = FMath::Clamp(FMath::FloorToInt32(Place - 0.5f), 0, SizeAbove - 1);
		Second = FMath::Min(First + 1, SizeAbove - 1);
		Share = FMath::Frac(Place - 0.5f);
	}
};

void FillMip(FRHITexture& Texture, int32 Mip)
{
	const FIntVector Size = Texture.GetMipDimensions(static_cast<uint8>(Mip));
	const FIntVector Above = Texture.GetMipDimensions(static_cast<uint8>(Mip - 1));
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		const FSide V(Y, Size.Y, Above.Y);
		for (int32 X = 0; X < Size.X; ++X)
		{
			const FSide U(X, Size.X, Above.X);
			const FLinearColor Top = FMath::Lerp(
				Texture.ReadTexel(U.First, V.First, Mip - 1), Texture.ReadTexel(U.Second, V.First, Mip - 1), U.Share);
			const FLinearColor Bottom = FMath::Lerp(
				Texture.ReadTexel(U.First, V.Second, Mip - 1), Texture.ReadTexel(U.Second, V.Second, Mip - 1), U.Share);
			Texture.WriteTexel(X, Y, FMath::Lerp(Top, Bottom, V.Share), Mip);
		}
	}
}

} // namespace

void FGenerateMips::Execute(
	FRDGBuilder& GraphBuilder, ERHIFeatureLevel::Type, FRDGTextureRef Texture, FGenerateMipsParams, EGenerateMipsPass)
{
	GraphBuilder.CheckArgument(Texture, "FGenerateMips::Execute", "Texture", nullptr);
	for (int32 Mip = 1; Mip < int32(Texture->Desc.NumMips); ++Mip)
	{
		FGenerateMipsParameters* const Parameters = GraphBuilder.AllocParameters<FGenerateMipsParameters>();
		Parameters->Texture = Texture;
		GraphBuilder.AddPass(RDG_EVENT_NAME("GenerateMips %d", Mip), Parameters, ERDGPassFlags::Compute,
			[Texture, Mip](FRHIComputeCommandList&) { FillMip(*Texture->GetRHI(), Mip); });
	}
}
