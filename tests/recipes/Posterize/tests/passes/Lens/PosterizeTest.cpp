// The pass that posterizes, against its formula in double.
#include <gtest/gtest.h>

#include "PassTestUtils.h"

#include "Lens/Posterize.h"

using namespace PassTest;

TEST(Posterize, RoundsDownToLevels)
{
	for (const double Value : {0.0, 0.1, 0.26, 0.5, 0.999, 7.3})
	{
		FPassRun Run(FImage(4, 3, {Value, Value, Value, 0.5}), EArithmetic::Double, PF_A32B32G32R32F);
		const FImage Result = Run.Execute(Drydock::AddPosterizePass(Run.GraphBuilder, Run.View, Run.Input, 4.0f));
		EXPECT_DOUBLE_EQ(std::floor(Value * 4.0) / 4.0, Result.At(2, 1)[0]) << Value;
		EXPECT_EQ(0.5, Result.At(2, 1)[3]);
	}
}
