// Matrices of colours by hand, and the change of white against published values.
#include "Tonemap/ColorMatrix.h"

#include <gtest/gtest.h>

namespace Drydock
{
namespace
{

void ExpectNear(const FColorMatrix& Expected, const FColorMatrix& Actual, double Tolerance)
{
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Column = 0; Column < 3; ++Column)
		{
			EXPECT_NEAR(Expected[Row][Column], Actual[Row][Column], Tolerance) << Row << ", " << Column;
		}
	}
}

TEST(ColorMatrix, ByHand)
{
	const FColorMatrix A = {{{2, 0, 1}, {0, 3, 0}, {1, 0, 1}}};
	const FColorMatrix B = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
	ExpectNear({{{9, 12, 15}, {12, 15, 18}, {8, 10, 12}}}, Multiply(A, B), 0.0);
	EXPECT_EQ((FColorVector{5, 6, 4}), Multiply(A, FColorVector{1, 2, 3}));
	EXPECT_EQ(3.0, GetDeterminant(A));
	EXPECT_EQ(0.0, GetDeterminant(B));
	ExpectNear({{{1, 0, -1}, {0, 1.0 / 3, 0}, {-1, 0, 2}}}, Invert(A), 1e-15);
}

TEST(ColorMatrix, WhiteOfD65)
{
	const FColorVector White = MakeWhite(0.3127, 0.3290);
	EXPECT_NEAR(0.95046, White[0], 1e-5);
	EXPECT_EQ(1.0, White[1]);
	EXPECT_NEAR(1.08906, White[2], 1e-5);
}

/** Source: Bruce Lindbloom, "Chromatic Adaptation", Bradford, D65 to D50. */
TEST(ColorMatrix, AdaptationHasThePublishedValues)
{
	const FColorVector D65 = {0.95047, 1.0, 1.08883};
	const FColorVector D50 = {0.96422, 1.0, 0.82521};
	const FColorMatrix Adaptation = MakeAdaptation(D65, D50);
	ExpectNear(
		{{{1.0478112, 0.0228866, -0.0501270}, {0.0295424, 0.9904844, -0.0170491}, {-0.0092345, 0.0150436, 0.7521316}}},
		Adaptation, 1e-6);
	const FColorVector White = Multiply(Adaptation, D65);
	for (size_t i = 0; i < 3; ++i)
	{
		EXPECT_NEAR(D50[i], White[i], 1e-12);
	}
}

} // namespace
} // namespace Drydock
