// The exposure curve of a frame without one before it: what it multiplies, and what it leaves alone.
#include "ExposureTestUtils.h"

#include "Exposure/PostProcessExposureCurve.h"
#include "SettingObjects.h"

#include <array>
#include <cmath>

using namespace Drydock;

namespace
{

/** Both entries of a metered grey picture's exposure, before and behind the curve's pass. */
struct FCurved
{
	std::array<FVector4f, 2> Metered;
	std::array<FVector4f, 2> Curved;
	bool bPassAdded = false;
};

FCurved MeterWithCurve(const char* Keys)
{
	PassTest::FMeteringRun Run(PassTest::Grey(0.25), {});
	FRDGBuilder& GraphBuilder = Run.Run.GraphBuilder;
	FEyeAdaptationInputs Inputs;
	Inputs.Parameters = Run.Parameters;
	Inputs.Parameters.ForceTarget = 1.0f;
	Inputs.LastEyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
	const FRDGBufferRef Metered = AddHistogramEyeAdaptationPass(GraphBuilder, Run.Run.View, Inputs,
		AddHistogramPass(GraphBuilder, Run.Run.View, Inputs.Parameters, Run.Run.Input));
	FFinalPostProcessSettings Settings;
	Settings.AutoExposureBiasCurve = Keys != nullptr ? FindOrAddCurve(Keys) : nullptr;
	const FRDGBufferRef Curved = AddExposureCurvePass(GraphBuilder, Settings, Metered);

	FRHIGPUBufferReadback OfMetered(TEXT("Metered")), OfCurved(TEXT("Curved"));
	AddEnqueueCopyPass(GraphBuilder, &OfMetered, Metered, Metered->Desc.GetSize());
	AddEnqueueCopyPass(GraphBuilder, &OfCurved, Curved, Curved->Desc.GetSize());
	GraphBuilder.Execute();
	const auto Read = [](FRHIGPUBufferReadback& Readback)
	{
		const FVector4f* const Entries = static_cast<const FVector4f*>(Readback.Lock(2 * sizeof(FVector4f)));
		const std::array<FVector4f, 2> Values = {Entries[0], Entries[1]};
		Readback.Unlock();
		return Values;
	};
	return {Read(OfMetered), Read(OfCurved), Curved != Metered};
}

} // namespace

TEST(ExposureCurve, MultipliesTheScalesByItsPowerOfTwo)
{
	const FCurved Result = MeterWithCurve("constant(-20 1.5, 20 1.5)");
	const double Factor = std::exp2(1.5);
	EXPECT_NEAR(Factor, static_cast<double>(Result.Curved[0].X) / static_cast<double>(Result.Metered[0].X), 1e-5);
	EXPECT_NEAR(Factor, static_cast<double>(Result.Curved[0].Y) / static_cast<double>(Result.Metered[0].Y), 1e-5);
	EXPECT_NEAR(Factor, static_cast<double>(Result.Curved[0].W) / static_cast<double>(Result.Metered[0].W), 1e-5);
}

TEST(ExposureCurve, LeavesTheMeteredLuminanceAlone)
{
	const FCurved Result = MeterWithCurve("constant(-20 1.5, 20 1.5)");
	EXPECT_GT(Result.Metered[0].Z, 0.0f);
	EXPECT_EQ(Result.Metered[0].Z, Result.Curved[0].Z);
	EXPECT_EQ(Result.Metered[1], Result.Curved[1]);
}

TEST(ExposureCurve, WithoutKeysThereIsNoPass)
{
	EXPECT_FALSE(MeterWithCurve(nullptr).bPassAdded);
	EXPECT_FALSE(MeterWithCurve("/Game/Curves/C.C").bPassAdded);
	EXPECT_TRUE(MeterWithCurve("linear(0 0, 1 1)").bPassAdded);
}
