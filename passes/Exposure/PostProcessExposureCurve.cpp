// One pass on the CPU, as the curve is evaluated there.
#include "Exposure/PostProcessExposureCurve.h"

#include "CurveKeys.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "FinalPostProcessSettings.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FExposureCurveParameters, )
	RDG_BUFFER_ACCESS(Metered, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(Output, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

} // namespace

FRDGBufferRef AddExposureCurvePass(
	FRDGBuilder& GraphBuilder, const FFinalPostProcessSettings& Settings, FRDGBufferRef Metered)
{
	check(Metered);
	if (!FindCurveKeys(Settings.AutoExposureBiasCurve))
	{
		return Metered;
	}
	FExposureCurveParameters* const Parameters = GraphBuilder.AllocParameters<FExposureCurveParameters>();
	Parameters->Metered = Metered;
	Parameters->Output = GraphBuilder.CreateBuffer(Metered->Desc, TEXT("EyeAdaptation"));
	GraphBuilder.AddPass(RDG_EVENT_NAME("ExposureCurve"), Parameters, ERDGPassFlags::Compute,
		[Parameters, Settings = Settings](FRHIComputeCommandList&)
		{
			const auto GetEntries = [](FRDGBufferRef Buffer)
			{
				return reinterpret_cast<FVector4f*>(Buffer->GetRHI()->GetData());
			};
			const FVector4f* const Last = GetEntries(Parameters->Metered);
			const float Factor = GetExposureCompensationFromCurve(Settings, Last[0].Z);
			GetEntries(Parameters->Output)[0] =
				FVector4f(Last[0].X * Factor, Last[0].Y * Factor, Last[0].Z, Last[0].W * Factor);
			GetEntries(Parameters->Output)[1] = Last[1]; // it and middle grey move alike
		});
	return Parameters->Output;
}

} // namespace Drydock
