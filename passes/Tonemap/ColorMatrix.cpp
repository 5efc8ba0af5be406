// Multiplies and inverts by the formulas of every textbook.
#include "Tonemap/ColorMatrix.h"

#include <cstddef>

namespace Drydock
{

namespace
{

double GetCofactor(const FColorMatrix& M, size_t Row, size_t Column)
{
	const size_t R0 = (Row + 1) % 3, R1 = (Row + 2) % 3, C0 = (Column + 1) % 3, C1 = (Column + 2) % 3;
	return M[R0][C0] * M[R1][C1] - M[R0][C1] * M[R1][C0];
}

} // namespace

FColorMatrix Multiply(const FColorMatrix& A, const FColorMatrix& B)
{
	FColorMatrix Product{};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Column = 0; Column < 3; ++Column)
		{
			for (size_t Index = 0; Index < 3; ++Index)
			{
				Product[Row][Column] += A[Row][Index] * B[Index][Column];
			}
		}
	}
	return Product;
}

FColorVector Multiply(const FColorMatrix& Matrix, const FColorVector& Color)
{
	FColorVector Product{};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		Product[Row] = Matrix[Row][0] * Color[0] + Matrix[Row][1] * Color[1] + Matrix[Row][2] * Color[2];
	}
	return Product;
}

double GetDeterminant(const FColorMatrix& M)
{
	return M[0][0] * GetCofactor(M, 0, 0) + M[0][1] * GetCofactor(M, 0, 1) + M[0][2] * GetCofactor(M, 0, 2);
}

FColorMatrix Invert(const FColorMatrix& M)
{
	const double Determinant = GetDeterminant(M);
	FColorMatrix Inverse{};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Column = 0; Column < 3; ++Column)
		{
			Inverse[Row][Column] = GetCofactor(M, Column, Row) / Determinant;
		}
	}
	return Inverse;
}

FColorVector MakeWhite(double X, double Y)
{
	return {X / Y, 1.0, (1.0 - X - Y) / Y};
}

FColorMatrix MakeAdaptation(const FColorVector& From, const FColorVector& To)
{
	const FColorMatrix Cone = {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
	const FColorVector A = Multiply(Cone, From), B = Multiply(Cone, To);
	const FColorMatrix Scale = {{{B[0] / A[0], 0, 0}, {0, B[1] / A[1], 0}, {0, 0, B[2] / A[2]}}};
	return Multiply(Invert(Cone), Multiply(Scale, Cone));
}

} // namespace Drydock
