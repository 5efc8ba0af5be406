// The eye-adaptation buffer of a given exposure, read back as a shader would see it.
#include <gtest/gtest.h>

#include "PostProcessEyeAdaptation.h"

#include "Misc/AssertionMacros.h"
#include "RHICommandList.h"
#include "RHIGPUReadback.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"

#include <cmath>
#include <limits>
#include <vector>

namespace
{

std::vector<FVector4f> ReadEyeAdaptation(float ExposureScale)
{
	FRHIGPUBufferReadback Readback(TEXT("EyeAdaptation"));
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGBufferRef Buffer = CreateEyeAdaptationBuffer(GraphBuilder, ExposureScale);
	AddEnqueueCopyPass(GraphBuilder, &Readback, Buffer, Buffer->Desc.GetSize());
	GraphBuilder.Execute();

	const uint32 NumBytes = GEyeAdaptationBufferEntries * sizeof(FVector4f);
	const FVector4f* Entries = static_cast<const FVector4f*>(Readback.Lock(NumBytes));
	const std::vector<FVector4f> Result(Entries, Entries + GEyeAdaptationBufferEntries);
	Readback.Unlock();
	return Result;
}

} // namespace

TEST(PostProcessEyeAdaptationTest, FirstEntryHoldsTheScaleAsReachedAndAsTarget)
{
	const FVector4f Entry = ReadEyeAdaptation(4.0f)[0];
	EXPECT_EQ(4.0f, Entry.X);
	EXPECT_EQ(4.0f, Entry.Y);
}

TEST(PostProcessEyeAdaptationTest, AverageLuminanceIsWhatTheScaleBringsToMiddleGrey)
{
	EXPECT_FLOAT_EQ(0.045f, ReadEyeAdaptation(4.0f)[0].Z); // 0.18 / 4
	EXPECT_FLOAT_EQ(0.36f, ReadEyeAdaptation(0.5f)[0].Z);  // 0.18 / 0.5
}

TEST(PostProcessEyeAdaptationTest, CompensationAndLocalExposureAreNeutral)
{
	const std::vector<FVector4f> Entries = ReadEyeAdaptation(4.0f);
	EXPECT_EQ(1.0f, Entries[0].W);
	EXPECT_EQ(1.0f, Entries[1].X);
}

TEST(PostProcessEyeAdaptationTest, ExtremeScalesStayFinite)
{
	for (const float Scale : {1.0e-30f, 1.0e30f})
	{
		const FVector4f Entry = ReadEyeAdaptation(Scale)[0];
		EXPECT_EQ(Scale, Entry.X);
		EXPECT_TRUE(std::isfinite(Entry.Z)) << Scale;
	}
}

TEST(PostProcessEyeAdaptationTest, ScaleMustBePositiveAndFinite)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	for (const float Scale :
		{0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
	{
		EXPECT_THROW(CreateEyeAdaptationBuffer(GraphBuilder, Scale), Drydock::FCheckFailure) << Scale;
	}
	GraphBuilder.Execute();
}
